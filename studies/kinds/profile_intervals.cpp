#include "studies/kinds/profile_intervals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "optimizer/gradient.hpp"
#include "studies/statistics/profile.hpp"

namespace unbruised::studies {
namespace {

using optimizer::Differences;

/// A growth of the sum of squares this close to the wanted one is a fortieth of the interval's half width; the
/// step from there is of second order.
constexpr double kGrowthTold = 0.05;
/// Of curves of size one: the solver's own noise.
constexpr double kNoise = 1e-14;

/// One end of one key's interval, on its way.
struct End {
  std::size_t key = 0;
  Side side = Side::low;
  std::vector<double> at;
  IntervalEnd found{.unit = 0.0, .kind = EndKind::unsettled};
  bool is_done = false;
};

std::vector<double> moved(std::vector<double> unit, const std::vector<double>& step) {
  for (std::size_t k = 0; k < unit.size(); ++k) unit[k] = std::clamp(unit[k] + step[k], 0.0, 1.0);
  return unit;
}

class Ends {
 public:
  Ends(const BestPoint& best, double allowed) : allowed_(allowed) {
    const double least =
        std::inner_product(best.residuals.begin(), best.residuals.end(), best.residuals.begin(), 0.0);
    growth_ = allowed - least;
    for (std::size_t key = 0; key < best.unit.size(); ++key) {
      for (const Side side : {Side::low, Side::high}) {
        const ProfileStep first = profile_step(best.derivatives, best.residuals, key, allowed, side);
        ends_.push_back({.key = key, .side = side, .at = moved(best.unit, first.step)});
      }
    }
  }

  [[nodiscard]] UnitPoints points() const {
    UnitPoints all;
    for (const End& end : ends_) {
      if (end.is_done) continue;
      const UnitPoints own = optimizer::difference_points(end.at, kCurveDifference, Differences::central);
      all.insert(all.end(), own.begin(), own.end());
    }
    return all;
  }

  /// @param residuals at `points()`
  void take(std::vector<std::vector<double>> residuals) {
    auto next = residuals.begin();
    for (End& end : ends_) {
      if (end.is_done) continue;
      const UnitPoints points = optimizer::difference_points(end.at, kCurveDifference, Differences::central);
      const auto last = next + static_cast<std::ptrdiff_t>(points.size());
      advance(end, points, {std::make_move_iterator(next), std::make_move_iterator(last)});
      next = last;
    }
  }

  [[nodiscard]] std::vector<KeyInterval> intervals() const {
    std::vector<KeyInterval> all(ends_.size() / 2);
    for (const End& end : ends_) {
      (end.side == Side::low ? all[end.key].low : all[end.key].high) = end.found;
    }
    return all;
  }

 private:
  void advance(End& end, const UnitPoints& points, const std::vector<std::vector<double>>& residuals) const {
    end.found = {.unit = end.at[end.key], .kind = EndKind::unsettled};
    end.is_done = std::any_of(residuals.begin(), residuals.end(), [](const auto& r) { return r.empty(); });
    if (end.is_done) return;
    const auto J = optimizer::difference_quotients(points, residuals, Differences::central);
    const ProfileStep step = profile_step(J, residuals.front(), end.key, allowed_, end.side);
    const double wall = end.side == Side::low ? 0.0 : 1.0;
    const bool is_told = std::abs(step.squares - allowed_) <= kGrowthTold * growth_ + kNoise;
    const bool is_at_wall = end.at[end.key] == wall && step.squares <= allowed_;
    end.at = moved(std::move(end.at), step.step);
    end.found.unit = end.at[end.key];
    end.is_done = is_told || is_at_wall;
    if (is_at_wall) {
      end.found.kind = EndKind::range;
    } else if (is_told) {
      end.found.kind = EndKind::found;
    }
  }

  double allowed_;
  double growth_ = 0.0;
  std::vector<End> ends_;
};

}  // namespace

std::size_t profile_scenarios_at_most(std::size_t keys) { return kProfileRoundsMost * 2 * keys * (2 * keys + 1); }

std::optional<std::vector<KeyInterval>> profile_intervals(const BestPoint& best, double allowed,
                                                          const AskResiduals& ask) {
  Ends ends(best, allowed);
  for (std::size_t round = 0; round < kProfileRoundsMost; ++round) {
    const UnitPoints points = ends.points();
    if (points.empty()) break;
    auto residuals = ask(points);
    if (!residuals) return std::nullopt;
    ends.take(*std::move(residuals));
  }
  return ends.intervals();
}

}  // namespace unbruised::studies
