#pragma once

/// @file
/// Which part of a row of lane values a kernel works on: lanes cost what the registers they stand in cost, so that
/// registers without a busy lane are left out. No lane's arithmetic depends on that.

#include <algorithm>

#include "core/lanes/lane_vector.hpp"

namespace unbruised {

/// Two registers of a row: with six rows twelve accumulators, which AVX2 still holds in registers; and one.
using WidePack = LanePack<std::min(kLanes, 2 * static_cast<int>(Lane::Native::size()))>;
using NarrowPack = LanePack<static_cast<int>(Lane::Native::size())>;

inline constexpr int kNarrowPacks = kLanes / NarrowPack::size;
using PackVector = VectorOf<NarrowPack>;
using PackMatrix = MatrixOf<NarrowPack>;
using PackMask = MaskPack<NarrowPack::size>;

/// Which pack starts at a lane.
constexpr std::size_t pack_at(int first_lane) { return static_cast<std::size_t>(first_lane / NarrowPack::size); }

/// Any pack of a lane value that starts at a lane, and back.
template <class P>
[[gnu::always_inline]] inline P pack_of(const Lane& value, int first_lane) {
  P pack;
  for (int i = 0; i < P::kParts; ++i) pack.part[i] = value.part[pack_at(first_lane) + static_cast<std::size_t>(i)];
  return pack;
}
template <class P>
[[gnu::always_inline]] inline void put_pack_of(Lane& value, const P& pack, int first_lane) {
  for (int i = 0; i < P::kParts; ++i) value.part[pack_at(first_lane) + static_cast<std::size_t>(i)] = pack.part[i];
}

/// The pack of a lane value that starts at a lane.
[[gnu::always_inline]] inline NarrowPack narrow(const Lane& value, int first_lane) {
  return pack_of<NarrowPack>(value, first_lane);
}
[[gnu::always_inline]] inline PackMask narrow(const Mask& value, int first_lane) {
  PackMask pack;
  pack.part[0] = value.part[pack_at(first_lane)];
  return pack;
}
[[gnu::always_inline]] inline PackVector narrow(const LaneVector& value, int first_lane) {
  return {{narrow(value[0], first_lane), narrow(value[1], first_lane), narrow(value[2], first_lane)}};
}
[[gnu::always_inline]] inline PackMatrix narrow(const LaneMatrix& value, int first_lane) {
  PackMatrix pack;
  for (std::size_t i = 0; i < 9; ++i) pack.at[i] = narrow(value.at[i], first_lane);
  return pack;
}

/// Puts a pack back where it stands in a lane value.
[[gnu::always_inline]] inline void widen(Lane& value, const NarrowPack& pack, int first_lane) {
  put_pack_of(value, pack, first_lane);
}
template <class Lanes, class Pack>
[[gnu::always_inline]] inline void widen(Lanes& value, const Pack& pack, int first_lane) {
  for (std::size_t i = 0; i < value.at.size(); ++i) widen(value.at[i], pack.at[i], first_lane);
}

/// A pack of a row.
[[gnu::always_inline]] inline NarrowPack get_pack(const LaneArray& rows, std::size_t i, int first_lane) {
  return NarrowPack::load(rows.row(i) + first_lane);
}
[[gnu::always_inline]] inline void put_pack(LaneArray& rows, std::size_t i, const NarrowPack& value,
                                            int first_lane) {
  value.store(rows.row(i) + first_lane);
}

/// The three rows of a particle, a pack of each.
[[gnu::always_inline]] inline PackVector get_vector(const LaneArray& rows, std::size_t particle, int first_lane) {
  PackVector value;
  for (std::size_t i = 0; i < 3; ++i) value[i] = get_pack(rows, 3 * particle + i, first_lane);
  return value;
}
[[gnu::always_inline]] inline void put_vector(LaneArray& rows, std::size_t particle, const PackVector& value,
                                              int first_lane) {
  for (std::size_t i = 0; i < 3; ++i) put_pack(rows, 3 * particle + i, value[i], first_lane);
}

/// Packs of a row of `Lanes` values that kernels go through.
template <class P, int Lanes>
struct Packs {
  static_assert(Lanes % P::size == 0);
  static constexpr int kMost = Lanes / P::size;
  int count = kMost;
  int first_lane[kMost];

  /// All of them.
  Packs() {
    for (int i = 0; i < kMost; ++i) first_lane[i] = i * P::size;
  }
  /// Those with a busy lane.
  explicit Packs(const Mask& busy) : count(0) {
    static_assert(Lanes == kLanes);
    for (int first = 0; first < Lanes; first += P::size) {
      bool any = false;
      for (int lane = first; lane < first + P::size; ++lane) any = any || busy[lane];
      if (any) first_lane[count++] = first;
    }
  }
  /// Calls `f(first lane)` for each.
  template <class F>
  void each(F&& f) const {
    for (int i = 0; i < count; ++i) f(first_lane[i]);
  }
};

using NarrowPacks = Packs<NarrowPack, kLanes>;

/// Packs that hold the busy lanes.
struct BusyPacks {
  explicit BusyPacks(const Mask& busy) : wide(busy), narrow(busy) {}
  Packs<WidePack, kLanes> wide;
  NarrowPacks narrow;

  /// Calls `f(packs)` with wide ones, or with the one narrow one that holds all busy lanes.
  template <class F>
  void with(F&& f) const {
    narrow.count == 1 ? f(narrow) : f(wide);
  }
};

/// The same for lanes that are asked for once.
template <class F>
void with_packs(const Mask& busy, F&& f) {
  BusyPacks(busy).with(f);
}

}  // namespace unbruised
