#include "core/scenario/product_frame.hpp"

#include "core/scenario/contact_set.hpp"
#include "core/scenario/palm_stops.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {

ProductFrame product_frame(const Scenario& scenario) {
  if (!shape_extents_m(scenario.product)) return ProductFrame::upright;
  if (contact_set(scenario) != ContactSet::pads_and_support) return ProductFrame::floating;
  if (!has_gripper(scenario)) {
    return starts_in_the_air(scenario.product) ? ProductFrame::floating : ProductFrame::upright;
  }
  return turns_product(scenario) || arm_sways(scenario) || hangs_off_centre(scenario) ? ProductFrame::floating
                                                                                      : ProductFrame::upright;
}

}  // namespace unbruised
