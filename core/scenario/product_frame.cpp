#include "core/scenario/product_frame.hpp"

#include <algorithm>

#include "core/scenario/contact_set.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {

ProductFrame product_frame(const Scenario& scenario) {
  if (!shape_extents_m(scenario.product)) return ProductFrame::upright;
  if (contact_set(scenario) != ContactSet::pads_and_support) return ProductFrame::floating;
  if (!has_gripper(scenario)) {
    return starts_in_the_air(scenario.product) ? ProductFrame::floating : ProductFrame::upright;
  }
  const bool turns =
      std::ranges::any_of(scenario.strategy.tilt_rad, [](double component) { return component != 0.0; });
  return turns ? ProductFrame::floating : ProductFrame::upright;
}

}  // namespace unbruised
