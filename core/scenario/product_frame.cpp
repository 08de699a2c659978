#include "core/scenario/product_frame.hpp"

#include <algorithm>

#include "core/scenario/product.hpp"

namespace unbruised {

ProductFrame product_frame(const Scenario& scenario) {
  if (!shape_extents_m(scenario.product)) return ProductFrame::upright;
  const std::array<double, 3> turn =
      has_gripper(scenario) ? scenario.strategy.tilt_rad : initial_spin_rad_s(scenario.product);
  const bool turns = std::ranges::any_of(turn, [](double component) { return component != 0.0; });
  return turns ? ProductFrame::floating : ProductFrame::upright;
}

}  // namespace unbruised
