#include "core/scenario/solid.hpp"

#include <algorithm>
#include <cmath>

#include "core/scenario/mesh_solid.hpp"
#include "core/scenario/profile_curve.hpp"
#include "core/scenario/revolution.hpp"
#include "core/scenario/superellipsoid.hpp"

namespace unbruised {
namespace {

bool has_extents(const LatticeParameters& p) {
  return std::ranges::all_of(p.size_m, [](double size) { return size > 0.0 && std::isfinite(size); });
}

bool has_exponents(const LatticeParameters& p) {
  return std::ranges::all_of(p.exponents, [](double e) { return e >= kLeastExponent && e <= kLargestExponent; });
}

}  // namespace

std::shared_ptr<const Solid> solid_of(const LatticeParameters& p) {
  if (!has_extents(p)) return nullptr;
  if (p.shape == Shape::superellipsoid && has_exponents(p)) return std::make_shared<Superellipsoid>(p);
  if (p.shape == Shape::revolution && !profile_fault(p.profile_height, p.profile_radius)) {
    return std::make_shared<Revolution>(p);
  }
  if (p.shape == Shape::mesh && p.mesh) return std::make_shared<MeshSolid>(p);
  return nullptr;
}

}  // namespace unbruised
