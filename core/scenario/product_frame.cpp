#include "core/scenario/product_frame.hpp"

#include <algorithm>

#include "core/scenario/product.hpp"

namespace unbruised {

ProductFrame product_frame(const Scenario& scenario) {
  if (has_gripper(scenario) || scenario.cell.support) return ProductFrame::upright;
  const std::array<double, 3> spin = initial_spin_rad_s(scenario.product);
  const bool spins = std::ranges::any_of(spin, [](double rate) { return rate != 0.0; });
  return spins ? ProductFrame::floating : ProductFrame::upright;
}

}  // namespace unbruised
