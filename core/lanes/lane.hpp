#pragma once

/// @file
/// The lane type: one value per scenario of a lockstep batch, with the usual operators, and masks with names.
///
/// A batch is `kLanes` scenarios wide and a lane value is a few native registers of std::experimental::simd, which
/// comes with libstdc++. benchmarks/lane_solve measures that choice and the width against OpenMP simd loops and
/// xsimd.

#include <array>
#include <cmath>
#include <cstddef>
#include <new>
#include <vector>

#include <experimental/simd>

namespace unbruised {

/// Scenarios per batch. 16 doubles are two 512-bit registers: enough independent work to hide the latency of a
/// multiply-add, and twelve accumulators of a solve panel still fit the register file.
inline constexpr int kLanes = 16;

inline constexpr std::size_t kLaneAlignment = 64;

/// Is there a lane of that number?
constexpr bool is_lane(int lane) { return lane >= 0 && lane < kLanes; }

namespace stdx = std::experimental;

// Operations are inlined in every build: as calls they would be what a build with sanitizers spends its time on,
// and a linker could give kernels that fuse multiply-adds the copy of a file that does not.

template <int Width>
struct LanePack;

/// True or false per scenario.
template <int Width>
struct MaskPack {
  using Native = stdx::native_simd_mask<double>;
  static constexpr int kParts = Width / static_cast<int>(Native::size());
  Native part[kParts];

  MaskPack() = default;
  [[gnu::always_inline]] explicit MaskPack(bool value) {
    for (auto& p : part) p = Native(value);
  }
  [[gnu::always_inline]] bool operator[](int lane) const {
    return part[lane / static_cast<int>(Native::size())][static_cast<std::size_t>(lane) % Native::size()];
  }
  [[gnu::always_inline]] void set(int lane, bool value) {
    part[lane / static_cast<int>(Native::size())][static_cast<std::size_t>(lane) % Native::size()] = value;
  }
  [[gnu::always_inline]] friend MaskPack operator&(const MaskPack& a, const MaskPack& b) {
    MaskPack r;
    for (int i = 0; i < kParts; ++i) r.part[i] = a.part[i] && b.part[i];
    return r;
  }
  [[gnu::always_inline]] friend MaskPack operator|(const MaskPack& a, const MaskPack& b) {
    MaskPack r;
    for (int i = 0; i < kParts; ++i) r.part[i] = a.part[i] || b.part[i];
    return r;
  }
  [[gnu::always_inline]] friend MaskPack operator!(const MaskPack& a) {
    MaskPack r;
    for (int i = 0; i < kParts; ++i) r.part[i] = !a.part[i];
    return r;
  }
};

/// `Width` doubles, one per scenario.
template <int Width>
struct LanePack {
  using Native = stdx::native_simd<double>;
  using Number = double;
  static constexpr bool kIsPaired = false;  ///< solve kernels take one panel at a time
  static constexpr int size = Width;
  static constexpr int kParts = Width / static_cast<int>(Native::size());
  static_assert(Width % static_cast<int>(Native::size()) == 0);
  Native part[kParts];

  LanePack() = default;
  [[gnu::always_inline]] LanePack(double value) {  // NOLINT: a scalar is the same value in every lane
    for (auto& p : part) p = value;
  }
  [[gnu::always_inline]] static LanePack load(const double* from) {
    LanePack r;
    for (int i = 0; i < kParts; ++i) r.part[i].copy_from(from + i * Native::size(), stdx::vector_aligned);
    return r;
  }
  [[gnu::always_inline]] void store(double* to) const {
    for (int i = 0; i < kParts; ++i) part[i].copy_to(to + i * Native::size(), stdx::vector_aligned);
  }
  [[gnu::always_inline]] double operator[](int lane) const {
    return part[lane / static_cast<int>(Native::size())][static_cast<std::size_t>(lane) % Native::size()];
  }
  [[gnu::always_inline]] void set(int lane, double value) {
    part[lane / static_cast<int>(Native::size())][static_cast<std::size_t>(lane) % Native::size()] = value;
  }

#define UNBRUISED_LANE_OPERATOR(op)                                                          \
  [[gnu::always_inline]] friend LanePack operator op(const LanePack& a, const LanePack& b) { \
    LanePack r;                                                                              \
    for (int i = 0; i < kParts; ++i) r.part[i] = a.part[i] op b.part[i];                     \
    return r;                                                                                \
  }                                                                                          \
  [[gnu::always_inline]] LanePack& operator op##=(const LanePack& b) {                       \
    for (int i = 0; i < kParts; ++i) part[i] = part[i] op b.part[i];                         \
    return *this;                                                                            \
  }
  UNBRUISED_LANE_OPERATOR(+)
  UNBRUISED_LANE_OPERATOR(-)
  UNBRUISED_LANE_OPERATOR(*)
  UNBRUISED_LANE_OPERATOR(/)
#undef UNBRUISED_LANE_OPERATOR

#define UNBRUISED_LANE_COMPARISON(op)                                                               \
  [[gnu::always_inline]] friend MaskPack<Width> operator op(const LanePack& a, const LanePack& b) { \
    MaskPack<Width> r;                                                                              \
    for (int i = 0; i < kParts; ++i) r.part[i] = a.part[i] op b.part[i];                            \
    return r;                                                                                       \
  }
  UNBRUISED_LANE_COMPARISON(<)
  UNBRUISED_LANE_COMPARISON(>)
  UNBRUISED_LANE_COMPARISON(<=)
  UNBRUISED_LANE_COMPARISON(>=)
  UNBRUISED_LANE_COMPARISON(==)
#undef UNBRUISED_LANE_COMPARISON

  [[gnu::always_inline]] friend LanePack operator-(const LanePack& a) {
    LanePack r;
    for (int i = 0; i < kParts; ++i) r.part[i] = -a.part[i];
    return r;
  }
};

template <int Width>
[[gnu::always_inline]] inline LanePack<Width> select(const MaskPack<Width>& mask, const LanePack<Width>& yes,
                                                     const LanePack<Width>& no) {
  LanePack<Width> r = no;
  for (int i = 0; i < LanePack<Width>::kParts; ++i) stdx::where(mask.part[i], r.part[i]) = yes.part[i];
  return r;
}
template <int Width>
[[gnu::always_inline]] inline LanePack<Width> max(const LanePack<Width>& a, const LanePack<Width>& b) {
  LanePack<Width> r;
  for (int i = 0; i < LanePack<Width>::kParts; ++i) r.part[i] = stdx::max(a.part[i], b.part[i]);
  return r;
}
template <int Width>
[[gnu::always_inline]] inline LanePack<Width> min(const LanePack<Width>& a, const LanePack<Width>& b) {
  LanePack<Width> r;
  for (int i = 0; i < LanePack<Width>::kParts; ++i) r.part[i] = stdx::min(a.part[i], b.part[i]);
  return r;
}
template <int Width>
[[gnu::always_inline]] inline LanePack<Width> abs(const LanePack<Width>& a) {
  LanePack<Width> r;
  for (int i = 0; i < LanePack<Width>::kParts; ++i) r.part[i] = stdx::abs(a.part[i]);
  return r;
}
template <int Width>
[[gnu::always_inline]] inline LanePack<Width> sqrt(const LanePack<Width>& a) {
  LanePack<Width> r;
  for (int i = 0; i < LanePack<Width>::kParts; ++i) r.part[i] = stdx::sqrt(a.part[i]);
  return r;
}
template <int Width>
[[gnu::always_inline]] inline bool any(const MaskPack<Width>& mask) {
  for (const auto& p : mask.part) {
    if (stdx::any_of(p)) return true;
  }
  return false;
}
template <int Width>
[[gnu::always_inline]] inline bool none(const MaskPack<Width>& mask) {
  return !any(mask);
}

using Lane = LanePack<kLanes>;
using Mask = MaskPack<kLanes>;

[[gnu::always_inline]] inline Lane load(const double* from) { return Lane::load(from); }
[[gnu::always_inline]] inline void store(double* to, const Lane& value) { value.store(to); }

/// The positive part.
[[gnu::always_inline]] inline Lane max0(const Lane& x) { return max(x, Lane(0.0)); }

/// Memory aligned for lanes.
template <class T>
struct LaneAllocator {
  using value_type = T;
  LaneAllocator() = default;
  template <class U>
  LaneAllocator(const LaneAllocator<U>&) {}  // NOLINT: implicit by the allocator requirements
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t(kLaneAlignment)));
  }
  void deallocate(T* memory, std::size_t) { ::operator delete(memory, std::align_val_t(kLaneAlignment)); }
  bool operator==(const LaneAllocator&) const { return true; }
};

/// Rows of lane values: `rows` x kLanes doubles, lane innermost.
class LaneArray {
 public:
  LaneArray() = default;
  explicit LaneArray(std::size_t rows) : values_(rows * kLanes, 0.0) {}
  [[nodiscard]] std::size_t rows() const { return values_.size() / kLanes; }
  [[nodiscard]] double* data() { return values_.data(); }
  [[nodiscard]] const double* data() const { return values_.data(); }
  [[nodiscard]] double* row(std::size_t i) { return values_.data() + i * kLanes; }
  [[nodiscard]] const double* row(std::size_t i) const { return values_.data() + i * kLanes; }
  [[nodiscard]] Lane get(std::size_t i) const { return load(row(i)); }
  void put(std::size_t i, const Lane& value) { store(row(i), value); }
  double& at(std::size_t i, int lane) { return values_[i * kLanes + static_cast<std::size_t>(lane)]; }
  [[nodiscard]] double at(std::size_t i, int lane) const {
    return values_[i * kLanes + static_cast<std::size_t>(lane)];
  }
  void fill(double value) { values_.assign(values_.size(), value); }
  void clear_lane(int lane) {
    for (std::size_t i = 0; i < rows(); ++i) at(i, lane) = 0.0;
  }

 private:
  std::vector<double, LaneAllocator<double>> values_;
};

/// Rows of masks.
class MaskArray {
 public:
  MaskArray() = default;
  explicit MaskArray(std::size_t rows) : masks_(rows, Mask(false)) {}
  [[nodiscard]] std::size_t rows() const { return masks_.size(); }
  [[nodiscard]] const Mask& get(std::size_t i) const { return masks_[i]; }
  void put(std::size_t i, const Mask& mask) { masks_[i] = mask; }
  [[nodiscard]] bool at(std::size_t i, int lane) const { return masks_[i][lane]; }
  void clear_lane(int lane) {
    for (Mask& mask : masks_) mask.set(lane, false);
  }

 private:
  std::vector<Mask, LaneAllocator<Mask>> masks_;
};

}  // namespace unbruised
