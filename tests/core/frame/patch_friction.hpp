#pragma once

/// @file
/// What dry friction of a patch of pressure carries, force and moment together.

#include <cmath>
#include <vector>

namespace unbruised::testing {

/// A particle of a patch: from the middle of the pad, and its share of the force.
struct PatchPlace {
  double y_m, z_m, share;
};

/// T / (mu N) at which a patch begins to turn that carries T along y at the arm d: from the point on z about which
/// a rigid body turns against it, so that friction everywhere is mu N across the way to it.
inline double share_at_arm(const std::vector<PatchPlace>& places, double arm_m) {
  struct Sums {
    double force = 0.0, moment_m = 0.0;
  };
  const auto friction_about = [&](double center_m) {
    Sums sums;
    for (const PatchPlace& place : places) {
      const double arm = place.z_m - center_m, radius = std::hypot(place.y_m, arm);
      sums.force += place.share * arm / radius;
      sums.moment_m += place.share * (place.y_m * place.y_m + place.z_m * arm) / radius;
    }
    return sums;
  };
  // From sliding, the point far away, to turning about the middle.
  double far_m = -1e3, near_m = -1e-6;
  for (int round = 0; round < 100; ++round) {
    const double middle_m = -std::sqrt(far_m * near_m);
    const Sums sums = friction_about(middle_m);
    (sums.moment_m > sums.force * arm_m ? near_m : far_m) = middle_m;
  }
  return friction_about(far_m).force;
}

/// An evenly pressed square.
inline std::vector<PatchPlace> even_square(double side_m) {
  constexpr int kPlaces = 200;  // along a side
  std::vector<PatchPlace> places;
  for (int i = 0; i < kPlaces * kPlaces; ++i) {
    places.push_back({side_m * ((i % kPlaces + 0.5) / kPlaces - 0.5),
                      side_m * ((i / kPlaces + 0.5) / kPlaces - 0.5), 1.0 / (kPlaces * kPlaces)});
  }
  return places;
}

}  // namespace unbruised::testing
