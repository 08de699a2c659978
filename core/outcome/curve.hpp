#pragma once

/// @file
/// The record of one scenario that measurements are compared with: what a testing machine writes down.

#include <vector>

namespace unbruised {

/// One entry per time step from the first contact of all fingers on (of a product without a gripper: from the
/// start), in the order of time.
struct Curve {
  std::vector<double> time_s;     ///< since the first contact
  std::vector<double> closure_m;  ///< by which the fingers have come closer; of a network: displacement of the
                                  ///< particle of its first load, along that load
  std::vector<double> force_N;    ///< mean normal force of a finger; of a network: that load
  std::vector<double> slide_N;    ///< mean tangential force of a finger; of a network 0
};

}  // namespace unbruised
