#pragma once

/// @file
/// How large the compliance of particles that may touch is, and how large it may be.

#include <cstddef>

namespace unbruised {

/// Nine numbers for each pair of particles.
constexpr double compliance_bytes(std::size_t particles) {
  return 9.0 * sizeof(double) * static_cast<double>(particles) * static_cast<double>(particles);
}

/// No larger one is built.
inline constexpr double kMostComplianceBytes = 4e9;

}  // namespace unbruised
