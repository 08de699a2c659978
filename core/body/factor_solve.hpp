#pragma once

/// @file
/// A right-hand side of all lanes on its way through the factor of a body: forward, a look at what it comes to at
/// some particles, forces that join it, backward.

#include <algorithm>
#include <span>
#include <vector>

#include "core/algebra/lane_solve.hpp"
#include "core/algebra/supernodes.hpp"
#include "core/body/body_model.hpp"
#include "core/lanes/lane_packs.hpp"
#include "core/lanes/single_lanes.hpp"

namespace unbruised {

/// A pack of a row in the precision of the rows.
[[gnu::always_inline]] inline void put_row(LaneArray& rows, std::size_t i, const NarrowPack& value,
                                           int first_lane) {
  put_pack(rows, i, value, first_lane);
}
[[gnu::always_inline]] inline void put_row(SingleArray& rows, std::size_t i, const NarrowPack& value,
                                           int first_lane) {
  put_rounded(rows, i, value, first_lane);
}

/// @tparam Rows LaneArray, or SingleArray with a factor whose values are rounded
template <class Rows>
class FactorSolve {
 public:
  /// @param body has to outlive this
  explicit FactorSolve(const BodyModel& body)
      : body_(body),
        reach_(body.factor),
        x_(static_cast<std::size_t>(body.factor.size)),
        aside_(static_cast<std::size_t>(body.factor.size)) {}

  /// In elimination order: the right-hand side, and the solution after `backward`.
  [[nodiscard]] Rows& rows() { return x_; }
  [[nodiscard]] const Rows& rows() const { return x_; }

  void forward(const Mask& lanes) { solve_forward(body_.factor, x_.data(), lanes); }
  void backward(const Mask& lanes) { solve_backward(body_.factor, x_.data(), lanes); }

  /// What it comes to without what joins later. @param reach supernodes: others' rows mean nothing
  const Rows& look(std::span<const int> reach, const Mask& lanes) {
    each_row(reach, [&](std::size_t row) { std::copy_n(x_.row(row), kLanes, aside_.row(row)); });
    solve_backward(body_.factor, reach, aside_.data(), lanes);
    return aside_;
  }

  /// Forces join after `forward`. @param active indices into `particles` and blocks of `force`
  void join(std::span<const int> particles, std::span<const int> active, const LaneArray& force,
            const Mask& lanes) {
    const std::vector<int>& reach = reach_of(particles, active);
    const NarrowPacks busy(lanes);
    const NarrowPack nothing(0.0);
    each_row(reach, [&](std::size_t row) { busy.each([&](int first) { put_row(aside_, row, nothing, first); }); });
    for (const int index : active) {
      const auto i = static_cast<std::size_t>(index);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const int slot = body_.slot[3 * static_cast<std::size_t>(particles[i]) + axis];
        if (slot < 0) continue;
        busy.each([&](int first) {
          put_row(aside_, static_cast<std::size_t>(slot), get_pack(force, 3 * i + axis, first), first);
        });
      }
    }
    solve_forward(body_.factor, reach, aside_.data(), lanes);
    each_row(reach, [&](std::size_t row) {
      auto* const to = x_.row(row);
      const auto* const from = aside_.row(row);
      for (int lane = 0; lane < kLanes; ++lane) to[lane] += from[lane];
    });
  }

 private:
  template <class Act>
  void each_row(std::span<const int> reach, Act&& act) const {
    for (const int s : reach) {
      const Supernode& node = body_.factor.supernode[static_cast<std::size_t>(s)];
      const auto first = static_cast<std::size_t>(node.first_column);
      for (std::size_t row = first; row < first + static_cast<std::size_t>(node.column_count); ++row) act(row);
    }
  }

  /// The supernodes that forces on the active ones touch; the same are active for many steps.
  const std::vector<int>& reach_of(std::span<const int> particles, std::span<const int> active) {
    if (std::ranges::equal(active, active_)) return active_reach_;
    std::vector<int> positions;
    for (const int index : active) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto particle = static_cast<std::size_t>(particles[static_cast<std::size_t>(index)]);
        const int slot = body_.slot[3 * particle + axis];
        if (slot >= 0) positions.push_back(slot);
      }
    }
    active_.assign(active.begin(), active.end());
    active_reach_ = reach_.of(positions);
    return active_reach_;
  }

  const BodyModel& body_;
  Reach reach_;
  Rows x_, aside_;
  std::vector<int> active_, active_reach_;  ///< of the last forces
};

}  // namespace unbruised
