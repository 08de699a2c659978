#pragma once

/// @file
/// Lane values in single precision: corrections of what double precision knows already (docs/theory.md, "Solving a
/// step"). Twice as many fit a register, and what they are read with takes half the memory.

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "core/lanes/lane_packs.hpp"

namespace unbruised {

/// `Width` floats, one per scenario.
template <int Width>
struct SinglePack {
  static constexpr int kNative = static_cast<int>(stdx::native_simd<float>::size());
  static constexpr int kRegister = Width < kNative ? Width : kNative;
  using Native = stdx::simd<float, stdx::simd_abi::deduce_t<float, kRegister>>;
  using Number = float;
  static constexpr int size = Width;
  static constexpr int kParts = Width / kRegister;
  static constexpr bool kIsPaired = kParts == 1;
  static_assert(Width % kRegister == 0);
  Native part[kParts];

  SinglePack() = default;
  [[gnu::always_inline]] SinglePack(float value) {  // NOLINT: a scalar is the same value in every lane
    for (auto& p : part) p = value;
  }
  [[gnu::always_inline]] static SinglePack load(const float* from) {
    SinglePack r;
    for (int i = 0; i < kParts; ++i) r.part[i].copy_from(from + i * kRegister, stdx::vector_aligned);
    return r;
  }
  [[gnu::always_inline]] void store(float* to) const {
    for (int i = 0; i < kParts; ++i) part[i].copy_to(to + i * kRegister, stdx::vector_aligned);
  }
  [[gnu::always_inline]] friend SinglePack operator*(const SinglePack& a, const SinglePack& b) {
    SinglePack r;
    for (int i = 0; i < kParts; ++i) r.part[i] = a.part[i] * b.part[i];
    return r;
  }
  [[gnu::always_inline]] SinglePack& operator+=(const SinglePack& b) {
    for (int i = 0; i < kParts; ++i) part[i] = part[i] + b.part[i];
    return *this;
  }
  [[gnu::always_inline]] SinglePack& operator-=(const SinglePack& b) {
    for (int i = 0; i < kParts; ++i) part[i] = part[i] - b.part[i];
    return *this;
  }
};

/// Rows of lane values in single precision, lane innermost.
class SingleArray {
 public:
  SingleArray() = default;
  explicit SingleArray(std::size_t rows) : values_(rows * kLanes, 0.0F) {}
  [[nodiscard]] std::size_t rows() const { return values_.size() / kLanes; }
  [[nodiscard]] float* data() { return values_.data(); }
  [[nodiscard]] float* row(std::size_t i) { return values_.data() + i * kLanes; }
  [[nodiscard]] const float* row(std::size_t i) const { return values_.data() + i * kLanes; }

 private:
  std::vector<float, LaneAllocator<float>> values_;
};

/// As wide as a register of doubles.
using SingleNarrow = SinglePack<NarrowPack::size>;

/// A pack of a row, from double precision and to it.
[[gnu::always_inline]] inline void put_rounded(SingleArray& rows, std::size_t i, const NarrowPack& value,
                                               int first_lane) {
  SingleNarrow pack;
  pack.part[0] = stdx::static_simd_cast<SingleNarrow::Native>(value.part[0]);
  pack.store(rows.row(i) + first_lane);
}
[[gnu::always_inline]] inline NarrowPack get_widened(const SingleArray& rows, std::size_t i, int first_lane) {
  const SingleNarrow pack = SingleNarrow::load(rows.row(i) + first_lane);
  NarrowPack value;
  value.part[0] = stdx::static_simd_cast<NarrowPack::Native>(pack.part[0]);
  return value;
}

/// A row.
[[gnu::always_inline]] inline void put_rounded(SingleArray& rows, std::size_t i, const Lane& value) {
  for (int first = 0; first < kLanes; first += NarrowPack::size) put_rounded(rows, i, narrow(value, first), first);
}
[[gnu::always_inline]] inline Lane get_widened(const SingleArray& rows, std::size_t i) {
  Lane value;
  for (int first = 0; first < kLanes; first += NarrowPack::size) widen(value, get_widened(rows, i, first), first);
  return value;
}

/// Packs of such rows that hold the busy lanes: calls `f(packs)` with whole registers, or with the half row that
/// holds all of them.
template <class F>
void with_single_packs(const Mask& busy, F&& f) {
  using Half = SinglePack<kLanes / 2>;
  using Whole = SinglePack<std::min(kLanes, Half::kNative)>;
  const Packs<Half, kLanes> halves(busy);
  halves.count == 1 ? f(halves) : f(Packs<Whole, kLanes>(busy));
}

}  // namespace unbruised
