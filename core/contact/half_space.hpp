#pragma once

/// @file
/// Stress inside an elastic half-space z > 0 that is pressed and dragged on its surface: point loads in closed
/// form, the patch of Hertz by quadrature (Johnson, Contact Mechanics, 1985, 3.2, 3.6 and 4.2; tension is
/// positive).

#include <array>

namespace unbruised {

/// xx, yy, zz, xy, xz, yz.
using Stress = std::array<double, 6>;

double von_mises(const Stress& stress);

/// A place relative to the point of the load; z > 0.
struct HalfSpacePlace {
  double x = 0.0, y = 0.0, z = 0.0;
};

/// Boussinesq: of a unit force into the body, per area.
Stress normal_point_load(const HalfSpacePlace& place, double poisson_ratio);
/// Cerruti: of a unit force along x on the surface.
Stress tangential_point_load(const HalfSpacePlace& place, double poisson_ratio);

/// An elliptical patch with the pressure p0 sqrt(1 - x^2/a^2 - y^2/b^2).
struct EllipticPatch {
  double semi_x = 1.0, semi_y = 1.0;
  double poisson_ratio = 0.3;
};
/// Points of the quadrature: along a ray from above the place to the patch's edge, and around it (beside the
/// patch: from its middle).
struct PatchQuadrature {
  int radial = 16, angular = 24;
};
/// Stress over p0 of the pressure, and of a traction along x that is everywhere as large as the pressure.
struct PatchStress {
  Stress normal{}, tangential{};
};
/// By quadrature: 16 x 24 points know both to 1e-3 of p0 from a tenth of the patch's radius down. @param place
/// relative to the middle of the patch, z > 0
PatchStress patch_stress(const HalfSpacePlace& place, const EllipticPatch& patch,
                         const PatchQuadrature& quadrature = {});

/// Largest von Mises stress on the axis of the patch / p0: of a circle 0.62 at half a radius for nu = 0.3.
double peak_stress_below(const EllipticPatch& patch);

}  // namespace unbruised
