#pragma once

/// @file
/// The multiply-add peak of one core: independent chains of the widest native vectors that never leave the
/// registers.

#include <array>
#include <cstddef>
#include <utility>

#include <experimental/simd>

namespace unbruised::benchmarks {

/// A long run of multiply-adds and the number of flops in it.
class FmaPeak {
 public:
  using Vector = std::experimental::native_simd<double>;

  /// Two units times a latency of 4 or 5 cycles need 8 to 10 independent chains. Vectors of 512 bits come with 32
  /// registers, shorter ones with 16, and two hold the constants.
  static constexpr std::size_t kChains = Vector::size() >= 8 ? 16 : 12;
  static constexpr long kRounds = 500'000;
  static constexpr double kFlops = 2.0 * static_cast<double>(kChains * Vector::size()) * kRounds;

  /// Performs `kFlops` flops. @return a value that depends on all of them.
  static double run() { return chains(std::make_index_sequence<kChains>{}); }

 private:
  template <std::size_t... I>
  static double chains(std::index_sequence<I...>) {
    // Read at run time, so that nothing can be computed beforehand. The chains tend to 1: no overflow, no
    // denormals.
    volatile double factor = 1.0 - 1e-6, summand = 1e-6;
    const Vector m(factor), c(summand);
    // Constant indices only (no loop over the chains): an array that is indexed at run time lives in memory.
    std::array<Vector, kChains> x{Vector(static_cast<double>(I) * summand)...};
    for (long round = 0; round < kRounds; ++round) ((x[I] = x[I] * m + c), ...);
    return (std::experimental::reduce(x[I]) + ...);
  }
};

}  // namespace unbruised::benchmarks
