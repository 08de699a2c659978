#pragma once

/// @file
/// What core's LanePack was chosen from: other pack types for the same solve kernels
/// (core/lanes/lane_solve_kernels.hpp).

#include <array>
#include <cstddef>

#if __has_include(<xsimd/xsimd.hpp>)
#include <xsimd/xsimd.hpp>
#define UNBRUISED_HAS_XSIMD 1
#else
#define UNBRUISED_HAS_XSIMD 0
#endif

namespace unbruised::benchmarks {

/// A plain array whose loops are marked `omp simd`: no library at all.
template <int Width>
struct OpenMpPack {
  using Number = double;
  static constexpr bool kIsPaired = false;
  static constexpr int size = Width;
  alignas(64) double value[Width];

  OpenMpPack() = default;
  explicit OpenMpPack(double scalar) {
#pragma omp simd
    for (int i = 0; i < Width; ++i) value[i] = scalar;
  }
  static OpenMpPack load(const double* from) {
    OpenMpPack r;
#pragma omp simd
    for (int i = 0; i < Width; ++i) r.value[i] = from[i];
    return r;
  }
  void store(double* to) const {
#pragma omp simd
    for (int i = 0; i < Width; ++i) to[i] = value[i];
  }
  friend OpenMpPack operator*(const OpenMpPack& a, const OpenMpPack& b) {
    OpenMpPack r;
#pragma omp simd
    for (int i = 0; i < Width; ++i) r.value[i] = a.value[i] * b.value[i];
    return r;
  }
  OpenMpPack& operator-=(const OpenMpPack& b) {
#pragma omp simd
    for (int i = 0; i < Width; ++i) value[i] -= b.value[i];
    return *this;
  }
};

#if UNBRUISED_HAS_XSIMD
/// Native batches of xsimd.
template <int Width>
struct XsimdPack {
  using Batch = xsimd::batch<double>;
  using Number = double;
  static constexpr bool kIsPaired = false;
  static constexpr int size = Width;
  static constexpr int kPart = static_cast<int>(Batch::size);
  static constexpr int kParts = Width / kPart;
  static_assert(Width % kPart == 0);
  Batch part[kParts];

  XsimdPack() = default;
  explicit XsimdPack(double scalar) {
    for (auto& p : part) p = Batch(scalar);
  }
  static XsimdPack load(const double* from) {
    XsimdPack r;
    for (int i = 0; i < kParts; ++i) r.part[i] = Batch::load_aligned(from + i * kPart);
    return r;
  }
  void store(double* to) const {
    for (int i = 0; i < kParts; ++i) part[i].store_aligned(to + i * kPart);
  }
  friend XsimdPack operator*(const XsimdPack& a, const XsimdPack& b) {
    XsimdPack r;
    for (int i = 0; i < kParts; ++i) r.part[i] = a.part[i] * b.part[i];
    return r;
  }
  XsimdPack& operator-=(const XsimdPack& b) {
    for (int i = 0; i < kParts; ++i) part[i] = part[i] - b.part[i];
    return *this;
  }
};
#endif

}  // namespace unbruised::benchmarks
