#pragma once

/// @file
/// The inside of a `Model`: everything scenarios of one factor key share, read-only once built.

#include <memory>
#include <optional>
#include <string>

#include "core/body/body_model.hpp"
#include "core/body/modal_basis.hpp"
#include "core/contact/contact_model.hpp"
#include "core/contact/static_rest.hpp"
#include "core/gripper/pad_body.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/scenario/product_frame.hpp"
#include "core/sensor/carried_surface.hpp"
#include "core/simulation/simulation.hpp"
#include "core/simulation/step_clock.hpp"

namespace unbruised {

struct Model::Parts {
  std::string key;  ///< factor_key of every scenario this model is for
  std::optional<WilsonTheta> wilson;
  StepClock clock;  ///< of its steps
  ProductFrame frame = ProductFrame::upright;
  BodyModel body;
  ContactModel contact;
  std::shared_ptr<const ModalBasis> modes;        ///< null: the particles move
  std::optional<ModeSummary> mode_summary;        ///< of those
  std::optional<PadBody> pad;                     ///< where the pads are bodies
  std::optional<SupportRest> rest;                ///< solids that scenarios start with here
  std::optional<CarriedSurface> carried_surface;  ///< lattices
};

}  // namespace unbruised
