#pragma once

/// @file
/// Random numbers that are counted, not drawn: the k-th of a stream is the same whoever asks for it, and when.

#include <cstdint>

namespace unbruised {

struct Bits128 {
  std::uint64_t first = 0;
  std::uint64_t second = 0;
};

/// One block of Philox 4x32-10, low words first (Salmon et al., "Parallel random numbers: as easy as 1, 2, 3",
/// 2011).
Bits128 philox(std::uint64_t seed, std::uint64_t stream, std::uint64_t k);

/// The upper 52 bits, in the middle of their cell: neither 0 nor 1 comes out, and nothing is rounded.
inline double open_unit(std::uint64_t bits) { return (static_cast<double>(bits >> 12U) + 0.5) * 0x1.0p-52; }

/// The k-th standard normal number of a stream (Box and Muller, one of the two).
double standard_normal(std::uint64_t seed, std::uint64_t stream, std::uint64_t k);

}  // namespace unbruised
