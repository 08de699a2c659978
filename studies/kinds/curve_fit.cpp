#include "studies/kinds/curve_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "optimizer/gradient.hpp"
#include "optimizer/search.hpp"
#include "studies/kinds/profile_intervals.hpp"
#include "studies/statistics/least_squares.hpp"
#include "studies/statistics/scores.hpp"

namespace unbruised::studies {
namespace {

/// Steps, and the parts of a step that are tried at once.
constexpr std::size_t kGaussNewtonMost = 6;
constexpr std::array kStepParts = {1.0, 0.5, 0.25};
/// A fit has settled when its steps are this part of the search's tolerance.
constexpr double kSettled = 1e-2;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double along(double x0, double y0, double x1, double y1, double x) {
  return x1 > x0 ? y0 + (y1 - y0) * (x - x0) / (x1 - x0) : y1;
}

optimizer::SearchSpace space_of(const std::vector<SearchVariable>& keys) {
  std::vector<optimizer::Variable> variables;
  for (const SearchVariable& key : keys) variables.push_back({key.key, key.units, key.from, key.to, key.scale});
  return optimizer::SearchSpace(std::move(variables));
}

/// A place of the fit's scale in the key's own unit.
double value_of(const SearchVariable& key, double unit) {
  if (key.scale == optimizer::Scale::log) return key.from * std::pow(key.to / key.from, unit);
  return key.from + unit * (key.to - key.from);
}

double mean_square(const std::vector<double>& residuals) {
  if (residuals.empty()) return kNaN;
  double sum = 0.0;
  for (const double r : residuals) sum += r * r;
  return sum / static_cast<double>(residuals.size());
}

class Fit {
 public:
  Fit(const std::vector<SearchVariable>& keys, const CalibrateSettings& settings, const MeasuredCurve& measured,
      const AskCurves& ask)
      : keys_(keys), settings_(settings), measured_(measured), ask_(ask), space_(space_of(keys)) {
    double squares = 0.0;
    for (const double y : measured.y) squares += y * y;
    scale_ = std::sqrt(squares / static_cast<double>(measured.y.size()));
  }

  std::optional<SpecimenFit> run() {
    fit_.specimen = measured_.specimen;
    if (!scale_objective() || !search()) return std::nullopt;
    if (!fit_.is_fitted) return std::move(fit_);
    if (!settle() || !add_intervals()) return std::nullopt;
    return std::move(fit_);
  }

 private:
  /// The residuals at points of the fit's scale, as parts of the measured curve's size; empty where there is no
  /// curve.
  std::optional<std::vector<std::vector<double>>> residuals_at(const UnitPoints& units) {
    std::vector<std::vector<double>> points;
    for (const std::vector<double>& unit : units) points.push_back(space_.from_unit(unit));
    fit_.scenarios += points.size();
    const auto curves = ask_(points);
    if (!curves) return std::nullopt;
    std::vector<std::vector<double>> all;
    for (const Curve& curve : *curves) {
      std::vector<double> residuals = values_at(curve, settings_.test, measured_.x);
      for (std::size_t i = 0; i < residuals.size(); ++i) residuals[i] = (residuals[i] - measured_.y[i]) / scale_;
      all.push_back(std::move(residuals));
    }
    return all;
  }

  /// Solvers begin with steps as long as the gradient: the mean square is told in units of its largest curvature
  /// at the start, 2 / points of the derivatives' largest singular value squared. @return false: stopped
  bool scale_objective() {
    fit_.unit = space_.to_unit(start());
    const auto linear = linearised();
    if (!linear) return false;
    const double largest = linear->singular_values.front();
    if (largest > 0.0) curvature_ = 2.0 * largest * largest / static_cast<double>(measured_.x.size());
    return true;
  }

  bool search() {
    optimizer::Problem problem{.space = space_, .constraint_count = 0, .evaluate = {}};
    bool is_stopped = false;
    problem.evaluate = [&](const std::vector<optimizer::Question>& questions)
        -> std::optional<std::vector<optimizer::Evaluation>> {
      UnitPoints units;
      for (const optimizer::Question& question : questions) units.push_back(space_.to_unit(question.point));
      const auto residuals = residuals_at(units);
      is_stopped = !residuals;
      if (is_stopped) return std::nullopt;
      std::vector<optimizer::Evaluation> answers;
      for (const std::vector<double>& r : *residuals)
        answers.push_back({.objective = mean_square(r) / curvature_, .constraints = {}});
      return answers;
    };
    optimizer::SearchOptions options;
    options.algorithm = optimizer::Algorithm::slsqp;
    options.start = start();
    options.evaluations_most = settings_.budget;
    options.tolerance = settings_.tolerance;
    options.gradient_step = kCurveDifference;
    options.central_differences = true;
    const optimizer::SearchResult found = optimizer::search(problem, options);
    if (is_stopped) return false;
    fit_.is_fitted = !found.best.empty() && std::isfinite(found.at_best.objective);
    if (fit_.is_fitted) fit_.unit = space_.to_unit(found.best);
    return true;
  }

  [[nodiscard]] std::vector<double> start() const {
    std::vector<double> start;
    for (const SearchVariable& key : keys_) start.push_back(key.start.value_or(value_of(key, 0.5)));
    return start;
  }

  /// Gauss and Newton's steps to where they get small. @return false: stopped
  bool settle() {
    for (std::size_t step = 0;; ++step) {
      const auto linear = linearised();
      if (!linear) return false;
      take_errors(*linear);
      const double most = std::abs(*std::max_element(
          linear->step.begin(), linear->step.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
      if (!(most > kSettled * settings_.tolerance) || step == kGaussNewtonMost) return true;
      const auto moved = step_to(linear->step);
      if (!moved) return false;
      if (!*moved) return true;
    }
  }

  /// Residuals and derivatives at the best point.
  std::optional<LinearFit> linearised() {
    const auto points = optimizer::difference_points(fit_.unit, kCurveDifference, optimizer::Differences::central);
    auto residuals = residuals_at(points);
    if (!residuals) return std::nullopt;
    const bool all_there =
        std::none_of(residuals->begin(), residuals->end(), [](const std::vector<double>& r) { return r.empty(); });
    if (all_there) {
      J_ = optimizer::difference_quotients(points, *residuals, optimizer::Differences::central);
    } else {
      J_.assign(measured_.x.size(), std::vector<double>(keys_.size(), 0.0));
    }
    residuals_ = std::move(residuals->front());
    if (residuals_.empty()) residuals_.assign(measured_.x.size(), kNaN);
    return linear_fit(J_, residuals_);
  }

  /// Takes the step where it lowers the sum of squares, else half of it and half of that. @return did it move?
  std::optional<bool> step_to(const std::vector<double>& step) {
    UnitPoints points;
    for (const double part : kStepParts) {
      points.push_back(fit_.unit);
      for (std::size_t k = 0; k < step.size(); ++k) {
        points.back()[k] = std::clamp(points.back()[k] + part * step[k], 0.0, 1.0);
      }
    }
    const auto residuals = residuals_at(points);
    if (!residuals) return std::nullopt;
    const double now = mean_square(residuals_);
    std::size_t best = points.size();
    double least = now;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double found = mean_square((*residuals)[i]);
      if (!(found < least)) continue;
      least = found;
      best = i;
    }
    if (best == points.size()) return false;
    fit_.unit = points[best];
    return true;
  }

  void take_errors(const LinearFit& linear) {
    fit_.unit_error = linear.standard_error;
    fit_.singular_values = linear.singular_values;
    fit_.weakest = linear.weakest;
    const double least = linear.singular_values.back();
    const double deviation = std::sqrt(linear.residual_variance);
    fit_.weakest_error = least > 0.0 ? deviation / least : std::numeric_limits<double>::infinity();
    fit_.rms_residual = scale_ * std::sqrt(mean_square(residuals_));
    fit_.simulated.clear();
    for (std::size_t i = 0; i < residuals_.size(); ++i) {
      fit_.simulated.push_back(measured_.y[i] + scale_ * residuals_[i]);
    }
  }

  /// Student's t of the residuals' scatter tells how far the sum of squares may grow. @return false: stopped
  bool add_intervals() {
    const auto freedom = static_cast<double>(measured_.x.size() - keys_.size());
    const double t = student_score(freedom, settings_.confidence);
    const double least = static_cast<double>(residuals_.size()) * mean_square(residuals_);
    const auto intervals = profile_intervals({fit_.unit, residuals_, J_}, least * (1.0 + t * t / freedom),
                                             [&](const UnitPoints& units) { return residuals_at(units); });
    if (!intervals) return false;
    fit_.intervals = *intervals;
    for (std::size_t k = 0; k < keys_.size(); ++k) {
      fit_.values.push_back(value_of(keys_[k], fit_.unit[k]));
      fit_.low.push_back(value_of(keys_[k], fit_.intervals[k].low.unit));
      fit_.high.push_back(value_of(keys_[k], fit_.intervals[k].high.unit));
    }
    return true;
  }

  const std::vector<SearchVariable>& keys_;
  const CalibrateSettings& settings_;
  const MeasuredCurve& measured_;
  const AskCurves& ask_;
  const optimizer::SearchSpace space_;
  double scale_ = 1.0;
  double curvature_ = 1.0;
  std::vector<double> residuals_;       ///< at the best point
  std::vector<std::vector<double>> J_;  ///< their derivatives, [point][key]
  SpecimenFit fit_;
};

}  // namespace

std::vector<double> values_at(const Curve& curve, CurveTest test, std::span<const double> x) {
  const bool over_closure = test == CurveTest::press;
  const std::vector<double>& over = over_closure ? curve.closure_m : curve.time_s;
  const std::vector<double>& measured = test == CurveTest::creep   ? curve.closure_m
                                        : test == CurveTest::slide ? curve.slide_N
                                                                   : curve.force_N;
  if (over.empty()) return {};
  std::vector<double> out;
  std::size_t i = 0;
  double x0 = 0.0, y0 = over.front() > 0.0 ? 0.0 : measured.front();
  for (const double wanted : x) {
    while (i < over.size() && over[i] < wanted) {
      if (over[i] > x0 || i == 0) {
        x0 = std::max(0.0, over[i]);
        y0 = measured[i];
      }
      ++i;
    }
    if (i < over.size()) {
      out.push_back(along(x0, y0, over[i], measured[i], wanted));
    } else {
      out.push_back(over_closure && x0 > 0.0 ? y0 * wanted / x0 : y0);
    }
  }
  return out;
}

std::size_t fit_scenarios_at_most(std::size_t keys, std::size_t budget) {
  const std::size_t of_a_gradient = 2 * keys + 1;
  return budget + (kGaussNewtonMost + 2) * of_a_gradient + kGaussNewtonMost * kStepParts.size() +
         profile_scenarios_at_most(keys);
}

std::optional<SpecimenFit> fit_specimen(const std::vector<SearchVariable>& keys, const CalibrateSettings& settings,
                                        const MeasuredCurve& measured, const AskCurves& ask) {
  return Fit(keys, settings, measured, ask).run();
}

}  // namespace unbruised::studies
