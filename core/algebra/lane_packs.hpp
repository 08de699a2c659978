#pragma once

/// @file
/// Which part of a row of lane values a kernel works on: lanes cost what the registers they stand in cost, so that
/// registers without a busy lane are left out. No lane's arithmetic depends on that.

#include <algorithm>

#include "core/lanes/lane.hpp"

namespace unbruised {

/// Two registers of a row: with six rows twelve accumulators, which AVX2 still holds in registers; and one.
using WidePack = LanePack<std::min(kLanes, 2 * static_cast<int>(Lane::Native::size()))>;
using NarrowPack = LanePack<static_cast<int>(Lane::Native::size())>;

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

/// Packs that hold the busy lanes.
struct BusyPacks {
  explicit BusyPacks(const Mask& busy) : wide(busy), narrow(busy) {}
  Packs<WidePack, kLanes> wide;
  Packs<NarrowPack, kLanes> narrow;

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
