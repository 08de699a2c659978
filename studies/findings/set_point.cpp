#include "studies/findings/set_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

constexpr std::string_view kNotForThisGripper = "not for this gripper";
constexpr std::string_view kTooNarrowForIt = "too narrow for this gripper";

/// Part of the margin that a rounder number may cost.
constexpr double kRoundingCost = 0.2;
/// Grids finer than this part of the force are not what a person types.
constexpr double kFinestPart = 1e-4;
/// Multiples are compared with the ends with this relative room for rounding errors of the arithmetic.
constexpr double kRoundoff = 1e-12;

/// Settings, from least to greatest.
struct Settings {
  double least_N = 0.0;
  double greatest_N = 0.0;
  [[nodiscard]] bool contains(double force_N) const {
    return force_N >= least_N * (1.0 - kRoundoff) && force_N <= greatest_N * (1.0 + kRoundoff);
  }
};

/// The settings whose force lies in the window wherever within the accuracy it is.
Settings safe_settings(const SafeForces& window, double accuracy) {
  return {window.least_N / (1.0 - accuracy), window.greatest_N / (1.0 + accuracy)};
}

/// The multiple of `grid` that is nearest to `wanted` in ratio; multiples of 1/n are made by division, so that 2.4
/// is the number that reads 2.4.
double nearest_multiple(double wanted, double grid) {
  const double inverse = 1.0 / grid;
  const bool fine = grid < 1.0 && std::abs(inverse - std::round(inverse)) < 1e-9 * inverse;
  const auto multiple = [&](double count) { return fine ? count / std::round(inverse) : count * grid; };
  const double below = multiple(std::floor(wanted / grid));
  const double above = multiple(std::floor(wanted / grid) + 1.0);
  if (below <= 0.0) return above;
  return wanted / below <= above / wanted ? below : above;
}

/// The nearest number of the coarsest grid that lies inside `allowed`; grids are 5, 2, 1 times powers of ten times
/// `unit`, never finer than `finest`.
std::optional<double> roundest(double wanted, const Settings& allowed, double unit, double finest) {
  const double top = std::pow(10.0, std::ceil(std::log10(wanted / unit)));
  for (double decade = top; decade * unit >= 0.1 * finest; decade /= 10.0) {
    for (const double leading : {5.0, 2.0, 1.0}) {
      const double grid = leading * (decade < 1.0 ? 1.0 / std::round(1.0 / decade) : std::round(decade)) * unit;
      if (grid < finest * (1.0 - kRoundoff)) return std::nullopt;
      const double number = nearest_multiple(wanted, grid);
      if (allowed.contains(number)) return number;
    }
  }
  return std::nullopt;
}

/// `value` in units of its last digit, rounded by `whole`, of a number with `digits` significant digits.
double rounded(double value, int digits, double (*whole)(double)) {
  if (!(value > 0.0)) return 0.0;
  const int exponent = static_cast<int>(std::floor(std::log10(value))) + 1 - digits;
  const double scale = std::pow(10.0, std::abs(exponent));
  const double count = whole(exponent < 0 ? value * scale : value / scale);
  return exponent < 0 ? count / scale : count * scale;
}
double whole_below(double value) { return std::floor(value * (1.0 + kRoundoff)); }
double whole_above(double value) { return std::ceil(value * (1.0 - kRoundoff)); }

/// Down to two significant digits: what a person is told may be used up.
double rounded_down(double value) { return rounded(value, 2, whole_below); }

/// The ends of a window for a sentence, in three digits and never wider than they are known.
std::string least_text(double force_N) { return short_number(rounded(force_N, 3, whole_above)); }
std::string greatest_text(double force_N) { return short_number(rounded(force_N, 3, whole_below)); }

SetPoint none(std::initializer_list<std::string_view> reason) {
  return {.exists = false, .force_N = kAbsent, .tolerance_N = kAbsent, .sentence = joined(reason)};
}

/// Why no setting serves; empty: some do, steps aside.
std::optional<SetPoint> refused(const SafeForces& window, const ForceSetting& gripper, const Settings& safe) {
  const std::string from = least_text(window.least_N);
  const std::string to = greatest_text(window.greatest_N);
  if (window.greatest_N < gripper.min_N) {
    return none({kNotForThisGripper, ": it cannot hold less than ", short_number(gripper.min_N),
                 " N, and the product is marked from ", to, " N on"});
  }
  if (window.least_N > gripper.max_N) {
    return none({kNotForThisGripper, ": it cannot hold more than ", short_number(gripper.max_N),
                 " N, and the product is held from ", from, " N on only"});
  }
  if (safe.least_N > safe.greatest_N) {
    return none({kTooNarrowForIt, ": its force is off by up to ", percent(gripper.accuracy),
                 " either way, and the window is [", from, ", ", to, "] N"});
  }
  if (safe.greatest_N < gripper.min_N || safe.least_N > gripper.max_N) {
    return none({kNotForThisGripper, ": it holds ", short_number(gripper.min_N), " to ",
                 short_number(gripper.max_N), " N, and with its accuracy of ", percent(gripper.accuracy),
                 " only settings of ", least_text(safe.least_N), " to ", greatest_text(safe.greatest_N),
                 " N are safe"});
  }
  return std::nullopt;
}

std::string sentence_of(double force_N, double tolerance_N, double accuracy) {
  const std::string set = joined({"set ", short_number(force_N), " N"});
  const std::string_view own = accuracy > 0.0 ? " (beyond the gripper's own accuracy)" : "";
  if (tolerance_N <= 0.0) return joined({set, ", exactly: no room is left either way", own});
  return joined({set, ", may be off by ", short_number(tolerance_N), " N either way", own});
}

}  // namespace

bool blames_gripper(std::string_view sentence) {
  return sentence.starts_with(kNotForThisGripper) || sentence.starts_with(kTooNarrowForIt);
}

ForceSetting force_setting(const ParallelJawParameters& gripper) {
  return {.min_N = gripper.min_force_N,
          .max_N = gripper.max_force_N,
          .accuracy = gripper.force_accuracy,
          .step_N = gripper.force_step_N};
}

SetPoint set_point(const SafeForces& window, const ForceSetting& gripper) {
  if (!window.exists) return none({"no window"});
  if (std::isnan(window.greatest_N)) {
    return none({"damage is not judged, so nothing says how hard the product may be gripped; it is held from ",
                 least_text(window.least_N), " N on"});
  }
  const Settings safe = safe_settings(window, gripper.accuracy);
  if (auto reason = refused(window, gripper, safe)) return *reason;
  const Settings settable{std::max(safe.least_N, gripper.min_N), std::min(safe.greatest_N, gripper.max_N)};
  const double balanced = std::sqrt(safe.least_N * safe.greatest_N);
  const double wanted = std::clamp(balanced, settable.least_N, settable.greatest_N);
  const double room = std::pow(safe.greatest_N / safe.least_N, 0.5 * kRoundingCost);
  const Settings cheap{std::max(settable.least_N, wanted / room), std::min(settable.greatest_N, wanted * room)};
  const double unit = gripper.step_N > 0.0 ? gripper.step_N : 1.0;
  const double finest = gripper.step_N > 0.0 ? gripper.step_N : kFinestPart * wanted;
  std::optional<double> force_N = roundest(wanted, cheap, unit, finest);
  if (!force_N) force_N = roundest(wanted, settable, unit, finest);
  if (!force_N && gripper.step_N == 0.0) force_N = wanted;
  if (!force_N) {
    return none({kNotForThisGripper, ": no multiple of its step of ", short_number(gripper.step_N),
                 " N lies between ", short_number(settable.least_N), " and ", short_number(settable.greatest_N),
                 " N"});
  }
  const double tolerance_N = rounded_down(std::min(*force_N - safe.least_N, safe.greatest_N - *force_N));
  return {.exists = true,
          .force_N = *force_N,
          .tolerance_N = tolerance_N,
          .sentence = sentence_of(*force_N, tolerance_N, gripper.accuracy)};
}

}  // namespace unbruised::studies
