#include "optimizer/nlopt_search.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <nlopt.h>

#include "optimizer/ledger.hpp"

namespace unbruised::optimizer {
namespace {

/// Gradient algorithms stop when the objective changes by less than this part of itself: the noise of the
/// simulator.
constexpr double kGradientFtol = 1e-9;
/// NLopt's own limit of evaluations, as a multiple of the budget: known points that are asked for again (half of
/// all, by ESCH) count there but cost nothing. The ledger keeps the budget; this is for an algorithm that would
/// not heed the stop.
constexpr double kAskedAgain = 20.0;
/// BOBYQA needs room for two first steps between the bounds.
constexpr double kBobyqaStepMost = 0.5;

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
  throw std::invalid_argument("no such algorithm");
}

struct OptDeleter {
  void operator()(nlopt_opt opt) const { nlopt_destroy(opt); }
};
using Opt = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, OptDeleter>;

/// NLopt's settings fail for lack of memory, or because we ask for nonsense.
void expect(nlopt_result code) {
  if (code == NLOPT_OUT_OF_MEMORY) throw std::bad_alloc();
  if (code < 0) throw std::logic_error("NLopt does not take a setting");
}

Opt created(Algorithm algorithm, std::size_t variable_count) {
  Opt opt(nlopt_create(nlopt_code(algorithm), static_cast<unsigned>(variable_count)));
  if (!opt) throw std::bad_alloc();
  return opt;
}

/// When an algorithm is done, and how it begins; global ones go on until the budget is spent.
void set_steps(nlopt_opt opt, Algorithm algorithm, const SearchOptions& options) {
  const AlgorithmInfo& info = info_of(algorithm);
  if (info.is_global) return;
  expect(nlopt_set_xtol_abs1(opt, options.tolerance));
  if (info.uses_gradient) {
    expect(nlopt_set_ftol_rel(opt, kGradientFtol));
  } else if (!info.needs_local) {
    const double most = algorithm == Algorithm::bobyqa ? kBobyqaStepMost : 1.0;
    expect(nlopt_set_initial_step1(opt, std::min(options.initial_step, most)));
  }
}

void check_at_the_door(const Problem& problem, const SearchOptions& options) {
  const auto must = [](bool holds, const char* rule) {
    if (!holds) throw std::invalid_argument(rule);
  };
  const auto is_finite = [](double value) { return std::isfinite(value); };
  must(problem.evaluate != nullptr, "a search needs an evaluator");
  must(options.start.empty() || options.start.size() == problem.space.size(),
       "start: one value for each variable");
  must(std::all_of(options.start.begin(), options.start.end(), is_finite), "start: must be finite");
  must(options.evaluations_most > 0, "evaluations_most: must be > 0");
  must(options.tolerance > 0.0 && options.tolerance < 1.0, "tolerance: must be > 0, < 1");
  must(options.initial_step > 0.0 && options.initial_step <= 1.0, "initial_step: must be > 0, <= 1");
  must(options.constraint_margin >= 0.0 && std::isfinite(options.constraint_margin),
       "constraint_margin: must be >= 0");
  must(options.gradient_step > 0.0 && options.gradient_step <= 0.25, "gradient_step: must be > 0, <= 0.25");
}

/// One search: NLopt on one side, the ledger on the other.
class Search {
 public:
  Search(const Problem& problem, const SearchOptions& options)
      : problem_(problem), options_(options), local_(local_of()), ledger_(problem, options, wanted()) {}

  SearchResult run() {
    seed();
    opt_ = configured();
    std::vector<double> begin = start();
    nlopt_result code = optimized(begin);
    while (begins_again() && has_moved(begin)) {
      begin = ledger_.best_unit();
      code = optimized(begin);
    }
    return concluded(code);
  }

 private:
  [[nodiscard]] std::optional<Algorithm> local_of() const {
    if (!info_of(options_.algorithm).needs_local) return std::nullopt;
    return options_.local.value_or(default_local(problem_.space.size()));
  }

  [[nodiscard]] Wanted wanted() const {
    const bool uses_gradient = info_of(local_.value_or(options_.algorithm)).uses_gradient;
    return uses_gradient ? Wanted::values_and_gradients : Wanted::values;
  }

  /// NLopt's generator belongs to the thread and takes 32 bits.
  void seed() const {
    nlopt_srand(static_cast<unsigned long>((options_.seed ^ (options_.seed >> 32U)) & 0xffffffffU));
  }

  Opt configured() {
    const std::size_t n = problem_.space.size();
    Opt opt = created(options_.algorithm, n);
    expect(nlopt_set_lower_bounds1(opt.get(), 0.0));
    expect(nlopt_set_upper_bounds1(opt.get(), 1.0));
    expect(nlopt_set_min_objective(opt.get(), &Search::objective_callback, this));
    if (problem_.constraint_count > 0) {
      const std::vector<double> exact(problem_.constraint_count, 0.0);
      expect(nlopt_add_inequality_mconstraint(opt.get(), static_cast<unsigned>(problem_.constraint_count),
                                              &Search::constraint_callback, this, exact.data()));
    }
    set_steps(opt.get(), options_.algorithm, options_);
    const double calls = kAskedAgain * static_cast<double>(options_.evaluations_most);
    expect(nlopt_set_maxeval(opt.get(), static_cast<int>(std::min(calls, 2e9))));
    if (local_) {
      const Opt local = created(*local_, n);
      set_steps(local.get(), *local_, options_);
      expect(nlopt_set_local_optimizer(opt.get(), local.get()));  // copies it
    }
    return opt;
  }

  [[nodiscard]] std::vector<double> start() const {
    if (options_.start.empty()) return std::vector<double>(problem_.space.size(), 0.5);
    return problem_.space.to_unit(options_.start);
  }

  nlopt_result optimized(std::vector<double> x) {
    double least = 0.0;
    const nlopt_result code = nlopt_optimize(opt_.get(), x.data(), &least);
    if (failure_) std::rethrow_exception(failure_);
    return code;
  }

  /// Gradient algorithms compare two iterates in a row, which are close after cautious steps too: MMA and CCSAQ,
  /// begun where constraints are broken, end far from any minimum about every third time (known_minima_test.cpp).
  [[nodiscard]] bool begins_again() const {
    return info_of(options_.algorithm).uses_gradient && !ledger_.has_ended();
  }

  [[nodiscard]] bool has_moved(const std::vector<double>& begin) const {
    const std::vector<double>& best = ledger_.best_unit();
    for (std::size_t k = 0; k < begin.size(); ++k) {
      if (std::abs(best[k] - begin[k]) > options_.tolerance) return true;
    }
    return false;
  }

  // -- What NLopt calls. No exception may pass its C frames. ---------------------------------------------------

  static double objective_callback(unsigned n, const double* x, double* gradient, void* self) {
    const Answer& answer = static_cast<Search*>(self)->at({x, n});
    if (gradient != nullptr) std::copy(answer.gradient[0].begin(), answer.gradient[0].end(), gradient);
    return answer.objective;
  }

  static void constraint_callback(unsigned m, double* result, unsigned n, const double* x, double* gradient,
                                  void* self) {
    const Answer& answer = static_cast<Search*>(self)->at({x, n});
    std::copy(answer.constraints.begin(), answer.constraints.end(), result);
    if (gradient == nullptr) return;
    for (std::size_t i = 0; i < m; ++i) {
      std::copy(answer.gradient[i + 1].begin(), answer.gradient[i + 1].end(), gradient + i * n);
    }
  }

  const Answer& at(std::span<const double> x) noexcept {
    const Answer* answer = &ledger_.last_words();
    try {
      answer = &ledger_.at(x);
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
    }
    if (failure_ || ledger_.has_ended()) nlopt_force_stop(opt_.get());
    return *answer;
  }

  // -- Ending. ---------------------------------------------------------------------------------------------

  [[nodiscard]] SearchResult concluded(nlopt_result code) const {
    SearchResult result = ledger_.result();
    if (ledger_.has_ended()) return result;
    const Ending ending = ending_of(code);
    result.termination = ending.termination;
    result.sentence = ending.sentence;
    const char* detail = code < 0 ? nlopt_get_errmsg(opt_.get()) : nullptr;
    if (detail != nullptr) result.sentence += std::string(": ") + detail;
    return result;
  }

  const Problem& problem_;
  const SearchOptions& options_;
  const std::optional<Algorithm> local_;
  Ledger ledger_;
  Opt opt_;
  std::exception_ptr failure_;
};

}  // namespace

Ending ending_of(int nlopt_result) {
  switch (nlopt_result) {
    case NLOPT_SUCCESS:
      return {Termination::converged, "the algorithm says it is done"};
    case NLOPT_STOPVAL_REACHED:
      return {Termination::converged, "the objective is as small as a number can be"};
    case NLOPT_FTOL_REACHED:
      return {Termination::converged, "the objective does not change any more"};
    case NLOPT_XTOL_REACHED:
      return {Termination::converged, "the steps are smaller than the tolerance"};
    case NLOPT_MAXEVAL_REACHED:
      return {Termination::budget_spent, "the algorithm's own limit of evaluations is reached"};
    case NLOPT_MAXTIME_REACHED:
      return {Termination::budget_spent, "the algorithm's own limit of time is reached"};
    case NLOPT_OUT_OF_MEMORY:
      return {Termination::stalled, "the algorithm ran out of memory"};
    case NLOPT_ROUNDOFF_LIMITED:
      return {Termination::stalled, "round-off or noise keeps the algorithm from getting further"};
    case NLOPT_FORCED_STOP:
      return {Termination::stopped, "the search was stopped"};
    case NLOPT_INVALID_ARGS:
      return {Termination::refused, "the algorithm does not take the problem"};
    default:
      return {Termination::stalled, "the algorithm failed"};
  }
}

SearchResult search(const Problem& problem, const SearchOptions& options) {
  check_at_the_door(problem, options);
  SearchResult refused;
  refused.sentence =
      why_unsuitable(options.algorithm, options.local, problem.space.size(), problem.constraint_count);
  if (!refused.sentence.empty()) return refused;
  return Search(problem, options).run();
}

}  // namespace unbruised::optimizer
