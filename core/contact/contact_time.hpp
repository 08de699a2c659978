#pragma once

/// @file
/// How long the contacts of a scenario last, from closed forms: what a time step has to resolve.

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// A contact that closes and opens again within fewer steps is not resolved (docs/contact.md).
inline constexpr double kStepsPerContact = 20.0;

/// Half a period of a finger on the springs between it and the product's middle plane, pi sqrt(m_finger / k): pad
/// layer and product in series. Flat faces: E A / t each. Curved products: Hertz, k = 2 E* sqrt(R d), and the
/// layer under the contact circle pi R d, at the larger of grip and impact force; for an impact that is 0.77 of
/// the time that Hertz gives, on the safe side. [s]; infinite without a gripper.
double finger_contact_time_s(const Scenario& scenario);

/// The same for a product that hits the support: its mass on its lower half and the support's layer, at the larger
/// of weight and impact force; of a network all its mass on all its touching particles' layers. [s]; infinite
/// where nothing hits it: the product is put down at rest, or there is no support.
double support_contact_time_s(const Scenario& scenario);

/// The shorter of the two.
double contact_time_s(const Scenario& scenario);

}  // namespace unbruised
