#include "studies/kinds/search_study.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <utility>
#include <variant>

#include "core/scenario/body_modes.hpp"
#include "studies/findings/balances.hpp"
#include "studies/findings/check_warnings.hpp"
#include "studies/findings/front_check.hpp"
#include "studies/kinds/pareto_plan.hpp"
#include "studies/statistics/design.hpp"
#include "studies/statistics/seed_purpose.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/key_names.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// The finer mesh of the check has at least this many times the cells along the product's smallest extent: about
/// twice as many in all.
constexpr double kMoreCells = 1.25;
/// Products on which the time step and the mesh are checked.
constexpr std::size_t kCheckedProducts = 32;

/// Of the checks: behind those of the best strategy.
constexpr std::size_t kFrontGeneration = 4;

constexpr const char* kCellSizeKey = "product.cell_size_m";
constexpr const char* kModeCountKey = "simulation.mode_count";  ///< 0: every particle moves

/// Keys of the checks that the study does not vary itself.
std::vector<std::string> numeric_keys(const Study& study) {
  std::vector<std::string> keys;
  for (const SearchVariable& variable : study.variables()) keys.push_back(variable.key);
  for (const RandomVariable& random : study.randoms()) keys.push_back(random.key);
  for (const char* key : {kTimeStepKey, kCellSizeKey, kModeCountKey}) {
    const bool is_varied = std::find(keys.begin(), keys.end(), key) != keys.end();
    const bool is_moot = key == kModeCountKey && mode_count(study.scenario(0)) == 0;
    if (!is_varied && !is_moot && study.base_value(key)) keys.emplace_back(key);
  }
  return keys;
}

optimizer::SearchSpace space_of(const Study& study) {
  std::vector<optimizer::Variable> variables;
  for (const SearchVariable& variable : study.variables()) {
    variables.push_back({variable.key, variable.units, variable.from, variable.to, variable.scale});
  }
  return optimizer::SearchSpace(std::move(variables));
}

/// A cell size that really gives more cells: extents are divided into a whole number of them.
double finer_cell_m(const Study& study, double cell_m) {
  const auto lattice = std::get<LatticeParameters>(study.scenario(0).product);
  const double extent_m = *std::min_element(lattice.size_m.begin(), lattice.size_m.end());
  const double cells = std::max(2.0, std::round(extent_m / cell_m));
  return extent_m / std::ceil(kMoreCells * cells);
}

class SearchStudy {
 public:
  SearchStudy(const StrategyJudge& judge, EvaluationBroker& broker)
      : judge_(judge),
        study_(judge.study()),
        broker_(broker),
        keys_(numeric_keys(study_)),
        space_(space_of(study_)) {
    if (is_sampled_search(study_.kind())) {
      found_.products = study_products(study_);
    }
  }

  SearchFindings run() {
    const auto begin = std::chrono::steady_clock::now();
    if (has_several_objectives(study_.kind())) {
      run_pareto();
    } else if (study_.variables().empty()) {
      run_stage({[this] { evaluate_as_written(); }});
    } else {
      run_multistart();
    }
    found_.candidates = log_.sorted();
    found_.searching = broker_.counts().lane_use;
    found_.search_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (!interrupted_) run_checks();
    found_.interrupted = interrupted_;
    return std::move(found_);
  }

 private:
  using Point = std::vector<double>;

  // -- Stages. ---------------------------------------------------------------------------------------------

  void run_stage(const std::vector<std::function<void()>>& searches) {
    if (!interrupted_) broker_.run(searches);
  }

  /// optimize and robust: the same problem from many starts.
  void run_multistart() {
    const SearchSettings& settings = study_.search();
    const std::vector<Point> starts = start_points(settings.starts, SeedPurpose::starts);
    run_planned(plan_multistart(study_, judge_, starts));
  }

  /// A robust study without variables judges the strategy as it is written.
  void evaluate_as_written() {
    const auto answers = ask({0, 0, 0}, {{}}, *found_.products, {});
    if (answers) log_.add(answers->front());
  }

  /// pareto: the best of each objective alone, then the points between them.
  void run_pareto() {
    const ParetoBudget budget = pareto_budget(study_);
    run_planned(plan_anchors(study_, judge_, start_points(budget.anchor_starts, SeedPurpose::starts)));
    if (interrupted_) return;
    const std::vector<Candidate> anchors = log_.sorted();
    run_planned(plan_points(study_, judge_, anchors, start_points(budget.starts, SeedPurpose::later_starts)));
  }

  void run_planned(const std::vector<PlannedSearch>& planned) {
    const std::size_t first = found_.searches.size();
    found_.searches.resize(first + planned.size());
    std::vector<std::function<void()>> searches;
    for (std::size_t i = 0; i < planned.size(); ++i) {
      searches.emplace_back([this, &plan = planned[i], number = first + i] { run_search(plan, number); });
    }
    run_stage(searches);
  }

  void run_search(const PlannedSearch& plan, std::size_t number) {
    const SearchSettings& settings = study_.search();
    optimizer::Problem problem;
    std::vector<optimizer::Variable> variables = space_.variables();
    if (plan.slack) variables.push_back(*plan.slack);
    problem.space = optimizer::SearchSpace(std::move(variables));
    problem.constraint_count = plan.constraint_count;
    problem.evaluate = [&](const std::vector<optimizer::Question>& questions) {
      return answer(plan, number, questions);
    };
    optimizer::SearchOptions options;
    options.algorithm = settings.algorithm;
    options.local = settings.local;
    options.start = plan.start;
    options.seed = seed_for(study_.seed(), SeedPurpose::searches, number);
    options.evaluations_most = plan.evaluations_most;
    options.tolerance = settings.tolerance;
    options.initial_step = settings.initial_step;
    SearchRecord& record = found_.searches[number];
    record.purpose = plan.purpose;
    record.start.assign(plan.start.begin(),
                        plan.start.begin() + static_cast<std::ptrdiff_t>(study_.variables().size()));
    record.result = optimizer::search(problem, options);
  }

  std::optional<std::vector<optimizer::Evaluation>> answer(const PlannedSearch& plan, std::size_t number,
                                                           const std::vector<optimizer::Question>& questions) {
    const std::size_t variables = study_.variables().size();
    std::vector<Point> points;
    for (const optimizer::Question& question : questions) {
      points.emplace_back(question.point.begin(), question.point.begin() + static_cast<std::ptrdiff_t>(variables));
    }
    const SearchPlace place{number, questions.front().generation, 0};
    const auto candidates =
        found_.products ? ask(place, points, *found_.products, {}) : ask(place, points, ProductSample{}, {});
    if (!candidates) return std::nullopt;
    std::vector<optimizer::Evaluation> evaluations;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      log_.add((*candidates)[i]);
      const double slack = plan.slack ? questions[i].point.back() : 0.0;
      evaluations.push_back(plan.worth((*candidates)[i], slack));
    }
    return evaluations;
  }

  // -- Asking. ---------------------------------------------------------------------------------------------

  /// What a check changes.
  struct Change {
    std::string key;
    double value = 0.0;
  };

  /// Judges points of the space on products (or alone, where there are none). Nothing: interrupted.
  std::optional<std::vector<Candidate>> ask(const SearchPlace& place, const std::vector<Point>& points,
                                            const ProductSample& products, const std::optional<Change>& change) {
    const std::size_t each = std::max<std::size_t>(1, products.size());
    std::vector<BrokerQuestion> questions;
    for (std::size_t p = 0; p < points.size(); ++p) {
      for (std::size_t product = 0; product < each; ++product) {
        questions.push_back(question({place.search, place.generation, p * each + product}, points[p],
                                     products.size() == 0 ? std::span<const double>{} : products.at(product),
                                     change));
      }
    }
    const auto results = broker_.ask(questions);
    if (!results) {
      interrupted_ = true;
      return std::nullopt;
    }
    std::vector<Candidate> candidates;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const std::span<const ScenarioResult> own(results->data() + p * each, each);
      Candidate candidate = judge_.judge(points[p], own, products.structure());
      candidate.place = {place.search, place.generation, p};
      candidate.first_scenario = journal_id(questions[p * each].place);
      candidate.unresolved_impact = std::any_of(
          own.begin(), own.end(), [](const ScenarioResult& result) { return impact_is_unresolved(result); });
      candidates.push_back(std::move(candidate));
    }
    return candidates;
  }

  BrokerQuestion question(const SearchPlace& place, const Point& point, std::span<const double> product,
                          const std::optional<Change>& change) const {
    std::vector<double> values = point;
    values.insert(values.end(), product.begin(), product.end());
    for (std::size_t k = values.size(); k < keys_.size(); ++k)
      values.push_back(study_.base_value(keys_[k]).value());
    for (std::size_t k = 0; change && k < keys_.size(); ++k) {
      if (keys_[k] == change->key) values[k] = change->value;
    }
    BrokerQuestion asked{place, study_.scenario_with(keys_, values), {}};
    asked.inputs.assign(values.begin(), values.end());
    return asked;
  }

  /// The given start or the middle of the box, then points of the purpose's seed all over it.
  std::vector<Point> start_points(std::size_t count, SeedPurpose purpose) const {
    const std::vector<SearchVariable>& variables = study_.variables();
    std::vector<Point> points;
    const UnitDesign design =
        unit_design(DesignKind::sobol, count, variables.size(), seed_for(study_.seed(), purpose));
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<double> unit(variables.size(), 0.5);
      if (i > 0) {
        for (std::size_t k = 0; k < unit.size(); ++k) unit[k] = design.at(i, k);
      }
      points.push_back(space_.from_unit(unit));
    }
    for (std::size_t k = 0; k < variables.size(); ++k) points[0][k] = variables[k].start.value_or(points[0][k]);
    return points;
  }

  // -- Checks. ---------------------------------------------------------------------------------------------

  /// What the winner is asked again, otherwise than it was found.
  struct PlannedCheck {
    std::string name;
    std::optional<Change> change;
    ProductSample products;
  };

  /// All checks at once: none needs the answer of another.
  void run_checks() {
    const Candidate* best = winner(study_, found_.candidates);
    if (best == nullptr) return;
    const Point point = best->values;
    const std::vector<PlannedCheck> planned = planned_checks();
    std::vector<std::optional<Check>> done(planned.size());
    std::vector<std::function<void()>> asking;
    for (std::size_t i = 0; i < planned.size(); ++i) {
      asking.emplace_back([&, i] { done[i] = check(planned[i], point, i); });
    }
    if (has_several_objectives(study_.kind())) asking.emplace_back([this] { check_front(); });
    run_stage(asking);
    if (interrupted_) return;
    for (std::optional<Check>& each : done) found_.checks.push_back(std::move(each).value());
  }

  [[nodiscard]] bool has_key(const char* key) const {
    return std::find(keys_.begin(), keys_.end(), key) != keys_.end();
  }
  [[nodiscard]] Change half_step() const { return {kTimeStepKey, 0.5 * study_.base_value(kTimeStepKey).value()}; }

  /// Points of the front that rest on impacts, at half the time step.
  void check_front() {
    const std::vector<const Candidate*> front = front_of(found_.candidates);
    std::vector<Point> points;
    for (const std::size_t i : points_on_impacts(front)) points.push_back(front[i]->values);
    if (points.empty()) return;
    auto again = ask({check_number(), kFrontGeneration, 0}, points, {}, half_step());
    if (again) found_.front_again = *std::move(again);
  }

  [[nodiscard]] std::vector<PlannedCheck> planned_checks() const {
    ProductSample products;
    if (found_.products) products = found_.products->first(kCheckedProducts);
    std::vector<PlannedCheck> planned = {{"as found", {}, products}, {kHalfStep, half_step(), products}};
    const std::optional<double> cell_m = study_.base_value(kCellSizeKey);
    if (has_key(kCellSizeKey) && cell_m) {
      planned.push_back({"finer mesh", Change{kCellSizeKey, finer_cell_m(study_, *cell_m)}, products});
    }
    if (has_key(kModeCountKey)) planned.push_back({"every particle", Change{kModeCountKey, 0.0}, products});
    if (found_.products) {
      planned.push_back(
          {"other products",
           {},
           draw_products(study_, study_.sampling().count, seed_for(study_.seed(), SeedPurpose::other_products))});
    }
    return planned;
  }

  /// Behind the last search; the strategy as written counts as one.
  [[nodiscard]] std::size_t check_number() const { return std::max<std::size_t>(1, found_.searches.size()); }

  /// Nothing: interrupted.
  std::optional<Check> check(const PlannedCheck& planned, const Point& point, std::size_t generation) {
    const auto candidates = ask({check_number(), generation, 0}, {point}, planned.products, planned.change);
    if (!candidates) return std::nullopt;
    Check done{.name = planned.name, .what = {}, .candidate = candidates->front()};
    if (planned.change) done.what = joined({planned.change->key, " = ", short_number(planned.change->value)});
    return done;
  }

  const StrategyJudge& judge_;
  const Study& study_;
  EvaluationBroker& broker_;
  const std::vector<std::string> keys_;
  const optimizer::SearchSpace space_;
  CandidateLog log_;
  std::atomic<bool> interrupted_ = false;
  SearchFindings found_;
};

}  // namespace

std::vector<ColumnInfo> search_columns(const Study& study) {
  std::vector<ColumnInfo> columns;
  for (const SearchVariable& variable : study.variables()) columns.push_back({variable.key, variable.units, ""});
  for (const RandomVariable& random : study.randoms()) columns.push_back({random.key, random.units, ""});
  const std::vector<std::string> keys = numeric_keys(study);
  for (std::size_t k = columns.size(); k < keys.size(); ++k) {
    columns.push_back({keys[k], keys[k] == kTimeStepKey ? "s" : keys[k] == kCellSizeKey ? "m" : "1", ""});
  }
  return columns;
}

Scenario scenario_of_search_inputs(const Study& study, const std::vector<InputValue>& inputs) {
  std::vector<double> values;
  for (const InputValue& input : inputs) values.push_back(std::get<double>(input));
  return study.scenario_with(numeric_keys(study), values);
}

SearchFindings run_searches(const StrategyJudge& judge, EvaluationBroker& broker) {
  return SearchStudy(judge, broker).run();
}

ScenarioSet search_probes(const Study& study, std::size_t count) {
  const std::vector<std::string> keys = numeric_keys(study);
  ProductSample products;
  if (is_sampled_search(study.kind())) {
    products = study_products(study).first(count);
  }
  ScenarioSet set;
  set.count = std::max<std::size_t>(1, products.size());
  set.columns = search_columns(study);
  const auto values_of = [study, keys, products](std::size_t id) {
    std::vector<double> values;
    for (const std::string& key : keys) values.push_back(study.base_value(key).value_or(kAbsent));
    for (std::size_t k = 0; k < products.keys.size(); ++k) {
      values[study.variables().size() + k] = products.at(id)[k];
    }
    return values;
  };
  set.scenario = [study, keys, values_of](std::size_t id) { return study.scenario_with(keys, values_of(id)); };
  set.inputs = [values_of](std::size_t id) {
    const std::vector<double> values = values_of(id);
    return std::vector<InputValue>(values.begin(), values.end());
  };
  return set;
}

std::size_t evaluations_at_most(const Study& study) {
  const std::size_t products = is_sampled_search(study.kind()) ? study.sampling().count : 1;
  const std::size_t searched = study.variables().empty() ? 1 : study.search().budget;
  const std::size_t checks = products == 1 ? 3 : 3 * std::min(kCheckedProducts, products) + products;
  return searched * products + checks;
}

}  // namespace unbruised::studies
