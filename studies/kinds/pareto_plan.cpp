#include "studies/kinds/pareto_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/statistics/design.hpp"
#include "studies/statistics/seed_purpose.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

using Point = std::vector<double>;

/// The other objectives enter with this weight, scaled to the front, so that of strategies equal in what is asked
/// for the search takes the one that no other beats (augmented epsilon-constraint, Mavrotas 2009; augmented
/// Chebyshev norm, Steuer and Choo 1983).
constexpr double kAugmentation = 1e-3;

/// The box that the anchors span: where each objective is best, and how far it is given up for the others.
struct ObjectiveBox {
  std::vector<double> ideal;
  std::vector<double> range;  ///< > 0
};

ObjectiveBox objective_box(const std::vector<Candidate>& known, std::size_t objectives) {
  ObjectiveBox box;
  std::vector<const Candidate*> ends;
  for (std::size_t k = 0; k < objectives; ++k) ends.push_back(best_feasible(known, k));
  for (std::size_t k = 0; k < objectives; ++k) {
    double low = ends[k]->objectives[k];
    double high = low;
    for (const Candidate* end : ends) high = std::max(high, end->objectives[k]);
    const double least_range = 1e-12 + 1e-9 * std::abs(low);
    box.ideal.push_back(low);
    box.range.push_back(std::max(high - low, least_range));
  }
  return box;
}

/// Where on the front to look, as parts in (0, 1): of two objectives evenly, of three over a square.
std::vector<std::vector<double>> positions(const Study& study) {
  const std::size_t points = study.search().points;
  std::vector<std::vector<double>> all;
  if (study.search().objectives.size() == 2) {
    for (std::size_t p = 0; p < points; ++p) {
      all.push_back({static_cast<double>(p + 1) / static_cast<double>(points + 1)});
    }
    return all;
  }
  const UnitDesign design =
      unit_design(DesignKind::sobol, points, 2, seed_for(study.seed(), SeedPurpose::front_positions));
  for (std::size_t p = 0; p < points; ++p) all.push_back({design.at(p, 0), design.at(p, 1)});
  return all;
}

/// Weights of the Chebyshev norm at a position: parts of the unit simplex.
std::vector<double> weights_at(const std::vector<double>& position) {
  if (position.size() == 1) return {position[0], 1.0 - position[0]};
  const double root = std::sqrt(position[0]);
  return {1.0 - root, root * (1.0 - position[1]), root * position[1]};
}

/// A search from `start` whose worth is `objective` plus extra constraints.
PlannedSearch plain_search(const StrategyJudge& judge, const Point& start, std::size_t evaluations,
                           std::size_t objective) {
  PlannedSearch plan;
  plan.start = start;
  plan.evaluations_most = evaluations;
  plan.constraint_count = judge.component_names().size();
  plan.worth = [objective](const Candidate& candidate, double) {
    return optimizer::Evaluation{candidate.objectives[objective], candidate.components};
  };
  return plan;
}

double scaled_sum(const Candidate& candidate, const ObjectiveBox& box) {
  double sum = 0.0;
  for (std::size_t k = 0; k < box.ideal.size(); ++k) {
    sum += (candidate.objectives[k] - box.ideal[k]) / box.range[k];
  }
  return sum;
}

/// Minimise one objective, and where that leaves a choice the others.
PlannedSearch end_search(const StrategyJudge& judge, const Point& start, std::size_t evaluations,
                         const ObjectiveBox& box, std::size_t objective) {
  PlannedSearch plan = plain_search(judge, start, evaluations, objective);
  plan.worth = [box, objective](const Candidate& candidate, double) {
    const double own = (candidate.objectives[objective] - box.ideal[objective]) / box.range[objective];
    return optimizer::Evaluation{own + kAugmentation * scaled_sum(candidate, box), candidate.components};
  };
  return plan;
}

/// Minimise the first objective while the others stay below their epsilon.
PlannedSearch epsilon_search(const StrategyJudge& judge, const Point& start, std::size_t evaluations,
                             const ObjectiveBox& box, const std::vector<double>& position) {
  PlannedSearch plan = plain_search(judge, start, evaluations, 0);
  plan.constraint_count += position.size();
  plan.worth = [box, position](const Candidate& candidate, double) {
    const double own = (candidate.objectives[0] - box.ideal[0]) / box.range[0];
    optimizer::Evaluation worth{own + kAugmentation * scaled_sum(candidate, box), candidate.components};
    for (std::size_t k = 0; k < position.size(); ++k) {
      const double epsilon = box.ideal[k + 1] + position[k] * box.range[k + 1];
      worth.constraints.push_back((candidate.objectives[k + 1] - epsilon) / box.range[k + 1]);
    }
    return worth;
  };
  return plan;
}

/// Minimise t subject to w_k (f_k - ideal_k) / range_k <= t.
PlannedSearch chebyshev_search(const StrategyJudge& judge, const Point& start, std::size_t evaluations,
                               const ObjectiveBox& box, const std::vector<double>& weights) {
  PlannedSearch plan = plain_search(judge, start, evaluations, 0);
  plan.start.push_back(0.5);
  plan.slack = optimizer::Variable{"slack", "1", 0.0, 1.0, optimizer::Scale::linear};
  plan.constraint_count += weights.size();
  plan.worth = [box, weights](const Candidate& candidate, double slack) {
    optimizer::Evaluation worth{slack + kAugmentation * scaled_sum(candidate, box), candidate.components};
    for (std::size_t k = 0; k < weights.size(); ++k) {
      worth.constraints.push_back(weights[k] * (candidate.objectives[k] - box.ideal[k]) / box.range[k] - slack);
    }
    return worth;
  };
  return plan;
}

/// The known feasible candidate that the planned search would think best of; nullptr: none.
const Candidate* best_start(const PlannedSearch& plan, const std::vector<Candidate>& known) {
  const Candidate* best = nullptr;
  double least = 0.0;
  for (const Candidate& candidate : known) {
    if (!candidate.feasible()) continue;
    const optimizer::Evaluation worth = plan.worth(candidate, 0.0);
    double broken = 0.0;
    for (const double constraint : worth.constraints) broken = std::max(broken, constraint);
    // With a slack the constraints alone measure the distance; without, staying below epsilon comes first.
    const double badness = plan.slack ? broken : (broken > 0.0 ? 1e6 * (1.0 + broken) : worth.objective);
    if (best == nullptr || badness < least) {
      best = &candidate;
      least = badness;
    }
  }
  return best;
}

}  // namespace

std::vector<PlannedSearch> plan_multistart(const Study& study, const StrategyJudge& judge,
                                           const std::vector<std::vector<double>>& starts) {
  const std::size_t each = study.search().budget / starts.size();
  std::vector<PlannedSearch> searches;
  for (const Point& start : starts) searches.push_back(plain_search(judge, start, each, 0));
  return searches;
}

ParetoBudget pareto_budget(const Study& study) {
  const SearchSettings& search = study.search();
  ParetoBudget budget;
  budget.anchor_starts = std::max<std::size_t>(kAnchorStarts, search.starts);
  budget.starts = search.starts;
  budget.evaluations_each = std::max<std::size_t>(
      1, search.budget / pareto_search_count(search.objectives.size(), search.points, search.starts));
  return budget;
}

std::vector<PlannedSearch> plan_anchors(const Study& study, const StrategyJudge& judge,
                                        const std::vector<std::vector<double>>& starts) {
  std::vector<PlannedSearch> searches;
  for (std::size_t k = 0; k < judge.objectives().size(); ++k) {
    for (const Point& start : starts) {
      searches.push_back(plain_search(judge, start, pareto_budget(study).evaluations_each, k));
      searches.back().purpose = joined({"least ", judge.objectives()[k].text});
    }
  }
  return searches;
}

std::vector<PlannedSearch> plan_points(const Study& study, const StrategyJudge& judge,
                                       const std::vector<Candidate>& known,
                                       const std::vector<std::vector<double>>& starts) {
  std::vector<PlannedSearch> searches;
  const std::size_t objectives = judge.objectives().size();
  if (best_feasible(known, 0) == nullptr) return searches;
  const ObjectiveBox box = objective_box(known, objectives);
  const std::size_t each = pareto_budget(study).evaluations_each;
  for (std::size_t k = 0; k < objectives; ++k) {
    for (std::size_t s = 0; s < starts.size(); ++s) {
      const Point& start = s == 0 ? best_feasible(known, k)->values : starts[s];
      searches.push_back(end_search(judge, start, each, box, k));
      searches.back().purpose = joined({"end of least ", judge.objectives()[k].text});
    }
  }
  std::size_t number = 0;
  for (const std::vector<double>& position : positions(study)) {
    ++number;
    for (std::size_t s = 0; s < starts.size(); ++s) {
      PlannedSearch plan = study.search().method == ParetoMethod::chebyshev
                               ? chebyshev_search(judge, starts[s], each, box, weights_at(position))
                               : epsilon_search(judge, starts[s], each, box, position);
      if (const Candidate* nearest = s == 0 ? best_start(plan, known) : nullptr) {
        std::copy(nearest->values.begin(), nearest->values.end(), plan.start.begin());
      }
      plan.purpose = joined({"point ", std::to_string(number)});
      searches.push_back(std::move(plan));
    }
  }
  return searches;
}

}  // namespace unbruised::studies
