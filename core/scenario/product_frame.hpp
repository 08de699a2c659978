#pragma once

/// @file
/// Which products can turn far: in whose axes their motion is computed.

#include "core/scenario/scenario.hpp"

namespace unbruised {

enum class ProductFrame {
  upright,   ///< the axes of the cell: rotations of the product are small
  floating,  ///< axes that turn with the product (core/frame)
};

/// A solid that spins without a gripper, is tilted or turned by one, hangs on an arm that sways, or off-centre in
/// its pads, or may meet the cell with more than its bottom is followed by a floating frame; every other product
/// is upright.
ProductFrame product_frame(const Scenario& scenario);

}  // namespace unbruised
