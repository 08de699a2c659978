#pragma once

/// @file
/// How long the contacts of a scenario last, from closed forms: what a time step has to resolve.

#include <limits>

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

/// Where a flat pad meets a flat face, the surface is stopped before the product behind it: a whole period of the
/// particles under the pad (with the finger, in relative motion) on the layer, 2 pi sqrt(m / (k A)), in which 20
/// steps give the peak within 2 %, of viscous layers within 7 % (docs/contact.md). [s]; infinite where faces are
/// curved, or where that peak decides nothing: damage is not considered, or the larger of grip force, the least
/// that carries the weight and the finger's own impact is above it.
double finger_surface_time_s(const Scenario& scenario);

/// The same for a flat base that hits the support, against the larger of weight and the product's own impact.
double support_surface_time_s(const Scenario& scenario);

/// What a contact time is of.
enum class ContactPart { finger, support, finger_surface, support_surface };

struct ShortestContact {
  double time_s = std::numeric_limits<double>::infinity();
  ContactPart part = ContactPart::finger;
};

/// The shortest of the four.
ShortestContact shortest_contact(const Scenario& scenario);
double contact_time_s(const Scenario& scenario);

}  // namespace unbruised
