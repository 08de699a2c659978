#include "core/body/correction.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <utility>

#include "core/algebra/lane_matrix.hpp"
#include "core/door/require.hpp"

namespace unbruised {

Correction::Correction(const BodyModel& body, const WilsonTheta& wilson, const Touchable& touchable)
    : body_(body),
      w_(wilson),
      touchable_(touchable.particle.begin(), touchable.particle.end()),
      columns_(touchable.columns),
      solve_(body),
      predicted_(3 * body.particle_count),
      held_(3 * touchable_.size()),
      change_(3 * touchable_.size()),
      all_touchable_(touchable_.size()) {
  std::iota(all_touchable_.begin(), all_touchable_.end(), 0);
  require(!body.factor.single_value.empty(), "Correction: the factor of the body has no rounded values");
  if (!has_columns()) return;
  require(columns_->rows() == solve_.rows().rows() && columns_->columns() == change_.rows(),
          "Correction: columns of another body");
  rounded_change_ = SingleArray(change_.rows());
}

void Correction::archive(LaneArchive& lane) {
  lane(held_);
  if (!lane.arrives()) return;
  std::vector<int> all;
  for (std::size_t i = 0; i < touchable_.size(); ++i) {
    bool any = std::ranges::binary_search(held_on_, static_cast<int>(i));
    for (std::size_t axis = 0; axis < 3; ++axis) any = any || held_.at(3 * i + axis, lane.lane()) != 0.0;
    if (any) all.push_back(static_cast<int>(i));
  }
  held_on_ = std::move(all);
}

void Correction::start(const LaneArray& left, const LaneArray* load, const Mask& running) {
  running_ = running;
  const NarrowPacks busy(running);
  std::array<PackVector, kNarrowPacks> sum_of;
  const auto loaded = [&](std::size_t i, std::size_t at, int first) {
    const NarrowPack force = get_pack(left, at, first);
    return load != nullptr ? force + get_pack(*load, i, first) : force;
  };
  for (std::size_t i = 0; i < 3 * body_.particle_count; ++i) {
    if (body_.slot[i] < 0) continue;
    const auto at = static_cast<std::size_t>(body_.slot[i]);
    busy.each([&](int first) {
      const NarrowPack force = loaded(i, at, first);
      put_rounded(solve_.rows(), at, force, first);
      sum_of[pack_at(first)][i % 3] += force;
    });
  }
  for (const int index : held_on_) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t i = 3 * static_cast<std::size_t>(touchable_[static_cast<std::size_t>(index)]) + axis;
      if (body_.slot[i] < 0) continue;
      const auto at = static_cast<std::size_t>(body_.slot[i]), row = 3 * static_cast<std::size_t>(index) + axis;
      busy.each([&](int first) {
        const NarrowPack held = get_pack(held_, row, first);
        put_rounded(solve_.rows(), at, loaded(i, at, first) + held, first);
        sum_of[pack_at(first)][axis] += held;
      });
    }
  }
  busy.each([&](int first) { widen(unbalanced_N_, sum_of[pack_at(first)], first); });
  solve_.forward(running);
  if (has_columns()) solve_.backward(running);
}

void Correction::look_without_contact(const Touchable& touchable, LaneArray& base) {
  look_under_held(touchable, base);
  if (held_on_.empty()) return;
  subtract_product(touchable.compliance, touchable_.size(), all_touchable_, held_on_, held_, running_, base);
}

void Correction::look_under_held(const Touchable& touchable, LaneArray& base) {
  const SingleArray& solution = has_columns() ? solve_.rows() : solve_.look(touchable.reach, running_);
  const NarrowPacks busy(running_);
  for (std::size_t i = 0; i < base.rows(); ++i) {
    const std::size_t freedom = 3 * static_cast<std::size_t>(touchable.particle[i / 3]) + i % 3;
    if (body_.slot[freedom] < 0) {
      base.put(i, Lane(0.0));
      continue;
    }
    const auto at = static_cast<std::size_t>(body_.slot[freedom]);
    busy.each([&](int first) {
      put_pack(base, i, get_pack(predicted_, freedom, first) + get_widened(solution, at, first), first);
    });
  }
}

void Correction::take_contact(std::span<const int> particles, std::span<const int> active,
                              const LaneArray& force) {
  require(std::ranges::equal(particles, touchable_), "Correction: contact forces on other particles");
  if (active.empty() && held_on_.empty()) return;
  changed_on_.clear();
  std::ranges::set_union(active, held_on_, std::back_inserter(changed_on_));
  for (const int index : changed_on_) {
    const bool acts = std::ranges::binary_search(active, index);
    for (std::size_t row = 3 * static_cast<std::size_t>(index), end = row + 3; row < end; ++row) {
      const Lane now = acts ? force.get(row) : Lane(0.0), change = now - held_.get(row);
      change_.put(row, change);
      held_.put(row, now);
      unbalanced_N_[row % 3] += change;
    }
  }
  held_on_.assign(active.begin(), active.end());
  has_columns() ? add_answer_to_change() : solve_.join(particles, changed_on_, change_, running_);
}

void Correction::add_answer_to_change() {
  changed_rows_.clear();
  for (const int index : changed_on_) {
    for (int row = 3 * index; row < 3 * index + 3; ++row) {
      const Lane change = change_.get(static_cast<std::size_t>(row));
      if (none(running_ & !(change == Lane(0.0)))) continue;
      changed_rows_.push_back(row);
      put_rounded(rounded_change_, static_cast<std::size_t>(row), change);
    }
  }
  add_product(*columns_, changed_rows_, rounded_change_, running_, solve_.rows());
}

void Correction::finish() {
  if (!has_columns()) solve_.backward(running_);
  if (!body_.is_anchored()) shift_ = missing_shift();
}

LaneVector Correction::missing_shift() const {
  std::array<PackVector, kNarrowPacks> moved_of;
  const NarrowPacks busy(running_);
  for (std::size_t p = 0; p < body_.particle_count; ++p) {
    const NarrowPack mass(body_.mass_kg[p]);
    busy.each([&](int first) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(body_.slot[3 * p + i]);
        moved_of[pack_at(first)][i] += mass * get_widened(solve_.rows(), at, first);
      }
    });
  }
  LaneVector moved;
  busy.each([&](int first) { widen(moved, moved_of[pack_at(first)], first); });
  LaneVector shift;
  for (std::size_t i = 0; i < 3; ++i) {
    shift[i] = (Lane(1.0 / w_.a0) * unbalanced_N_[i] - moved[i]) * Lane(1.0 / body_.total_mass_kg);
  }
  return shift;
}

}  // namespace unbruised
