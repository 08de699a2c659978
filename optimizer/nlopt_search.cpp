#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "optimizer/gradient.hpp"
#include "optimizer/search.hpp"

namespace unbruised::optimizer {
namespace {

/// Told instead of an objective that does not exist while none has been seen.
constexpr double kFirstPenalty = 1e6;
/// Told instead of a constraint that is not finite: broken by about its own bound.
constexpr double kConstraintPenalty = 1.0;
/// Of so many evaluations half must be finite.
constexpr std::size_t kRecent = 200;
/// Relative change of the objective below which gradient algorithms stop: the noise of the simulator.
constexpr double kGradientFtol = 1e-9;
/// NLopt may ask again for points that are known; past this many calls per evaluation it goes round in circles.
constexpr int kCallsPerEvaluation = 20;

nlopt_algorithm nlopt_code(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::cobyla:
      return NLOPT_LN_COBYLA;
    case Algorithm::bobyqa:
      return NLOPT_LN_BOBYQA;
    case Algorithm::sbplx:
      return NLOPT_LN_SBPLX;
    case Algorithm::neldermead:
      return NLOPT_LN_NELDERMEAD;
    case Algorithm::direct_l:
      return NLOPT_GN_DIRECT_L;
    case Algorithm::crs2_lm:
      return NLOPT_GN_CRS2_LM;
    case Algorithm::isres:
      return NLOPT_GN_ISRES;
    case Algorithm::esch:
      return NLOPT_GN_ESCH;
    case Algorithm::mlsl:
      return NLOPT_G_MLSL_LDS;
    case Algorithm::auglag:
      return NLOPT_AUGLAG;
    case Algorithm::slsqp:
      return NLOPT_LD_SLSQP;
    case Algorithm::mma:
      return NLOPT_LD_MMA;
    case Algorithm::ccsaq:
      return NLOPT_LD_CCSAQ;
  }
  return NLOPT_LN_COBYLA;
}

struct OptDeleter {
  void operator()(nlopt_opt opt) const { nlopt_destroy(opt); }
};
using Opt = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, OptDeleter>;

double largest_of(const std::vector<double>& constraints) {
  if (constraints.empty()) return 0.0;
  double largest = -std::numeric_limits<double>::infinity();
  for (const double c : constraints) largest = std::max(largest, std::isfinite(c) ? c : kConstraintPenalty);
  return largest;
}

/// One search: what NLopt calls, and what it has seen.
class Search {
 public:
  Search(const Problem& problem, const SearchOptions& options)
      : problem_(problem), options_(options), needs_local_(info_of(options.algorithm).needs_local) {
    if (needs_local_) local_ = options.local.value_or(default_local(problem.space.size()));
    uses_gradient_ = info_of(options.algorithm).uses_gradient || (local_ && info_of(*local_).uses_gradient);
  }

  SearchResult run() {
    const std::string why =
        why_unsuitable(options_.algorithm, options_.local, problem_.space.size(), problem_.constraint_count);
    if (!why.empty()) {
      result_.sentence = why;
      return std::move(result_);
    }
    nlopt_srand(static_cast<unsigned long>(options_.seed));  // of this thread only
    opt_ = configured();
    std::vector<double> x = start();
    double least = 0.0;
    const nlopt_result code = nlopt_optimize(opt_.get(), x.data(), &least);
    if (failure_) std::rethrow_exception(failure_);
    conclude(code);
    return std::move(result_);
  }

 private:
  /// What is known about one point.
  struct Known {
    double objective;
    std::vector<double> constraints;
    std::vector<std::vector<double>> gradient;  ///< of the objective, then of each constraint
  };

  // -- Setting up. -----------------------------------------------------------------------------------------

  [[nodiscard]] unsigned size() const { return static_cast<unsigned>(problem_.space.size()); }

  void limit_steps(nlopt_opt opt, Algorithm algorithm) const {
    const AlgorithmInfo& info = info_of(algorithm);
    if (!info.is_global || algorithm == Algorithm::crs2_lm) nlopt_set_xtol_abs1(opt, options_.tolerance);
    if (info.uses_gradient) nlopt_set_ftol_rel(opt, kGradientFtol);
    if (!info.is_global && !info.uses_gradient) nlopt_set_initial_step1(opt, options_.initial_step);
  }

  Opt configured() {
    Opt opt(nlopt_create(nlopt_code(options_.algorithm), size()));
    nlopt_set_lower_bounds1(opt.get(), 0.0);
    nlopt_set_upper_bounds1(opt.get(), 1.0);
    nlopt_set_min_objective(opt.get(), &Search::objective_callback, this);
    if (problem_.constraint_count > 0) {
      const std::vector<double> exact(problem_.constraint_count, 0.0);
      nlopt_add_inequality_mconstraint(opt.get(), static_cast<unsigned>(problem_.constraint_count),
                                       &Search::constraint_callback, this, exact.data());
    }
    limit_steps(opt.get(), options_.algorithm);
    const double calls = kCallsPerEvaluation * static_cast<double>(options_.evaluations_most);
    nlopt_set_maxeval(opt.get(), static_cast<int>(std::min(calls, 2e9)));
    if (local_) {
      const Opt local(nlopt_create(nlopt_code(*local_), size()));
      limit_steps(local.get(), *local_);
      nlopt_set_local_optimizer(opt.get(), local.get());  // copies it
    }
    return opt;
  }

  [[nodiscard]] std::vector<double> start() const {
    if (options_.start.empty()) return std::vector<double>(problem_.space.size(), 0.5);
    return problem_.space.to_unit(options_.start);
  }

  // -- What NLopt calls. No exception may leave these. --------------------------------------------------------

  static double objective_callback(unsigned n, const double* x, double* gradient, void* self) {
    auto& search = *static_cast<Search*>(self);
    const Known& known = search.at({x, x + n});
    if (gradient != nullptr) std::copy(known.gradient[0].begin(), known.gradient[0].end(), gradient);
    return known.objective;
  }

  static void constraint_callback(unsigned m, double* result, unsigned n, const double* x, double* gradient,
                                  void* self) {
    auto& search = *static_cast<Search*>(self);
    const Known& known = search.at({x, x + n});
    std::copy(known.constraints.begin(), known.constraints.end(), result);
    if (gradient == nullptr) return;
    for (unsigned i = 0; i < m; ++i) {
      std::copy(known.gradient[i + 1].begin(), known.gradient[i + 1].end(), gradient + std::size_t{i} * n);
    }
  }

  /// What is known about a point, asked for where nothing is.
  const Known& at(std::vector<double> x) {
    std::string key(sizeof(double) * x.size(), '\0');
    std::memcpy(key.data(), x.data(), key.size());
    if (const auto found = memo_.find(key); found != memo_.end()) return found->second;
    std::optional<Known> fresh;
    try {
      fresh = learn(x);
    } catch (...) {
      failure_ = std::current_exception();
    }
    if (!fresh) {
      nlopt_force_stop(opt_.get());
      return placeholder();
    }
    return memo_.emplace(std::move(key), std::move(*fresh)).first->second;
  }

  /// Finite numbers for NLopt's last steps before it sees the stop.
  const Known& placeholder() {
    const std::vector<double> zeros(problem_.space.size(), 0.0);
    ending_ = {penalty(),
               std::vector<double>(problem_.constraint_count, kConstraintPenalty),
               std::vector<std::vector<double>>(problem_.constraint_count + 1, zeros)};
    return ending_;
  }

  // -- Asking. ---------------------------------------------------------------------------------------------

  /// Evaluates a point, with a gradient where the algorithm uses one; nothing: the search has to end.
  std::optional<Known> learn(const std::vector<double>& x) {
    if (stop_) return std::nullopt;
    if (std::any_of(x.begin(), x.end(), [](double value) { return !std::isfinite(value); })) {
      return end(Termination::stalled, "the algorithm asked for a point that is not a number");
    }
    const auto points = uses_gradient_
                            ? difference_points(x, options_.gradient_step, options_.central_differences)
                            : std::vector<std::vector<double>>{x};
    if (result_.evaluations + points.size() > options_.evaluations_most) {
      return end(Termination::budget_spent, "the budget of " + std::to_string(options_.evaluations_most) +
                                                " evaluations is spent");
    }
    const auto answers = problem_.evaluate(questions(points));
    if (!answers) return end(Termination::stopped, "the study was stopped");
    result_.evaluations += points.size();
    ++result_.generations;
    std::vector<std::vector<double>> values;
    for (std::size_t i = 0; i < points.size(); ++i) {
      record(points[i], (*answers)[i]);
      values.push_back(finite_values((*answers)[i]));
    }
    if (mostly_failing()) {
      end(Termination::stalled, "more than half of the last " + std::to_string(kRecent) +
                                    " evaluations have no objective");
    }
    Known known{values[0][0], {values[0].begin() + 1, values[0].end()}, {}};
    if (uses_gradient_) known.gradient = difference_quotients(points, values, options_.central_differences);
    return known;
  }

  std::vector<Question> questions(const std::vector<std::vector<double>>& points) const {
    std::vector<Question> asked;
    for (std::size_t i = 0; i < points.size(); ++i) {
      asked.push_back({problem_.space.from_unit(points[i]), result_.generations, i});
    }
    return asked;
  }

  std::nullopt_t end(Termination termination, std::string sentence) {
    if (!stop_) {
      stop_ = termination;
      result_.sentence = std::move(sentence);
    }
    nlopt_force_stop(opt_.get());
    return std::nullopt;
  }

  // -- Remembering. ----------------------------------------------------------------------------------------

  void record(const std::vector<double>& unit, const Evaluation& evaluation) {
    const bool exists = std::isfinite(evaluation.objective);
    recent_.push_back(exists);
    if (recent_.size() > kRecent) recent_.pop_front();
    if (exists) {
      worst_ = seen_ ? std::max(worst_, evaluation.objective) : evaluation.objective;
      seen_ = true;
    }
    const double violation = largest_of(evaluation.constraints);
    const bool feasible = exists && violation <= 0.0;
    const bool better = result_.best.empty() || (feasible && !result_.feasible) ||
                        (feasible && evaluation.objective < result_.at_best.objective) ||
                        (!feasible && !result_.feasible && violation < result_.violation);
    if (!better) return;
    result_.best = problem_.space.from_unit(unit);
    result_.at_best = evaluation;
    result_.feasible = feasible;
    result_.violation = violation;
  }

  /// The objective, then the constraints, all finite.
  std::vector<double> finite_values(const Evaluation& evaluation) const {
    std::vector<double> values = {std::isfinite(evaluation.objective) ? evaluation.objective : penalty()};
    for (const double c : evaluation.constraints) values.push_back(std::isfinite(c) ? c : kConstraintPenalty);
    return values;
  }

  [[nodiscard]] double penalty() const {
    return seen_ ? worst_ + std::max(1.0, std::abs(worst_)) : kFirstPenalty;
  }

  [[nodiscard]] bool mostly_failing() const {
    const auto failed = std::count(recent_.begin(), recent_.end(), false);
    return recent_.size() == kRecent && 2 * static_cast<std::size_t>(failed) > kRecent;
  }

  // -- Ending. ---------------------------------------------------------------------------------------------

  void conclude(nlopt_result code) {
    if (stop_) {
      result_.termination = *stop_;
      return;
    }
    std::tie(result_.termination, result_.sentence) = meaning_of(code);
    if (code == NLOPT_INVALID_ARGS || code == NLOPT_FAILURE) {
      const char* detail = nlopt_get_errmsg(opt_.get());
      if (detail != nullptr) result_.sentence += std::string(": ") + detail;
    }
  }

  static std::pair<Termination, std::string> meaning_of(nlopt_result code) {
    switch (code) {
      case NLOPT_SUCCESS:
        return {Termination::converged, "the algorithm says it is done"};
      case NLOPT_STOPVAL_REACHED:
        return {Termination::converged, "the objective is as small as it can be"};
      case NLOPT_FTOL_REACHED:
        return {Termination::converged, "the objective does not change any more"};
      case NLOPT_XTOL_REACHED:
        return {Termination::converged, "the steps are smaller than the tolerance"};
      case NLOPT_MAXEVAL_REACHED:
        return {Termination::stalled, "the algorithm goes round in circles over known points"};
      case NLOPT_MAXTIME_REACHED:
        return {Termination::budget_spent, "the time is spent"};
      case NLOPT_ROUNDOFF_LIMITED:
        return {Termination::stalled, "round-off keeps the algorithm from getting further"};
      case NLOPT_FORCED_STOP:
        return {Termination::stopped, "the search was stopped"};
      case NLOPT_OUT_OF_MEMORY:
        return {Termination::stalled, "the algorithm ran out of memory"};
      case NLOPT_INVALID_ARGS:
        return {Termination::refused, "the algorithm does not take the problem"};
      default:
        return {Termination::stalled, "the algorithm failed"};
    }
  }

  const Problem& problem_;
  const SearchOptions& options_;
  const bool needs_local_;
  std::optional<Algorithm> local_;
  bool uses_gradient_ = false;
  Opt opt_;
  std::unordered_map<std::string, Known> memo_;
  Known ending_{};
  std::deque<bool> recent_;
  double worst_ = 0.0;
  bool seen_ = false;
  std::optional<Termination> stop_;
  std::exception_ptr failure_;
  SearchResult result_;
};

}  // namespace

SearchResult search(const Problem& problem, const SearchOptions& options) { return Search(problem, options).run(); }

}  // namespace unbruised::optimizer
