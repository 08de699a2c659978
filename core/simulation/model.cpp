#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "core/scenario/body_modes.hpp"
#include "core/scenario/contact_set.hpp"
#include "core/scenario/factor_key.hpp"
#include "core/scenario/pad_lattice.hpp"
#include "core/scenario/product.hpp"
#include "core/simulation/model_parts.hpp"

namespace unbruised {
namespace {

ModelSize size_of(const LatticeParameters& parameters, const ContactChoice& choice) {
  const Lattice lattice = build_lattice(parameters);
  const std::size_t particles = lattice.position_m.size();
  const ContactModel contact = lattice_contact(parameters, lattice, choice);
  return {particles, 3 * particles, contact.candidate.size(), contact.node_count()};
}

ModelSize size_of(const NetworkParameters& network, const ContactChoice&) {
  ModelSize size{.particle_count = network.particle.size(),
                 .freedom_count = 0,
                 .contact_candidate_count = 0,
                 .contact_node_count = 0};
  for (const NetworkParticle& particle : network.particle) {
    for (bool fixed : particle.fixed) size.freedom_count += fixed ? 0 : 1;
    size.contact_candidate_count += particle.contact_stiffness_N_m > 0.0 ? 1 : 0;
    size.contact_node_count = size.contact_candidate_count;
  }
  return size;
}

/// A product that may roll turns as its true shape does.
MassSpread mass_spread(const Scenario& scenario) {
  return contact_set(scenario) == ContactSet::pads_and_support ? MassSpread::cells : MassSpread::true_shape;
}

/// Pads that are bodies, and their faces where the product stands before them.
bool add_pads(const Scenario& scenario, Model::Parts& parts, std::string& error) {
  if (!has_lattice_pads(scenario)) return true;
  parts.pad = build_pad(*parallel_jaw(scenario), *parts.wilson, error);
  if (!parts.pad) return false;
  const std::array<double, 3>& center_m = parts.body.center_m();
  parts.contact.pads =
      pad_faces(parts.contact, *parts.pad, *parts.wilson,
                {center_m[1] + scenario.cell.grip_offset_m, center_m[2] + scenario.cell.grip_height_m});
  return true;
}

/// Of the product's smallest extent: contact nodes that are no farther behind the pole count as near it. 1 mm of a
/// kiwi of 5 cm, which a pad presses to that depth at some 10 N.
constexpr double kNearPole = 0.02;

/// What the modes leave out where a surface meets the product first.
double share_left_out_at(int surface, const Model::Parts& parts) {
  const auto outward_m = [&](const ContactCandidate& c) { return -normal_sign(surface) * c.surface_m; };
  double pole_m = -std::numeric_limits<double>::infinity();
  for (const ContactCandidate& c : parts.contact.candidate) {
    if (c.surface == surface) pole_m = std::max(pole_m, outward_m(c));
  }
  std::vector<int> near;
  for (const ContactCandidate& c : parts.contact.candidate) {
    const double behind_m = pole_m - outward_m(c);
    if (c.surface == surface && behind_m < kNearPole * parts.body.smallest_extent_m())
      near.push_back(c.contact_node);
  }
  if (near.empty()) return 0.0;
  return share_left_out(*parts.modes, near, static_cast<std::size_t>(normal_axis(surface)));
}

ModeSummary summary_of(const Model::Parts& parts) {
  const ModeShapes& modes = parts.modes->modes;
  ModeSummary summary{.deforming = modes.mode_count() - kRigidModes};
  summary.fastest_Hz = std::sqrt(modes.square_1_s2[modes.mode_count() - 1]) / (2.0 * std::numbers::pi);
  const bool has_pads = is_pad(parts.contact.surface.front());
  for (const int surface : parts.contact.surface) {
    if (is_pad(surface) != has_pads) continue;
    summary.left_out_share = std::max(summary.left_out_share, share_left_out_at(surface, parts));
  }
  return summary;
}

/// @param shorter the same for shorter steps, whose modes serve these too; null: they are made
void touch_by_modes(const Scenario& scenario, std::size_t modes, const Model::Parts* shorter,
                    Model::Parts& parts) {
  parts.contact = contact_candidates(scenario, parts.body);
  parts.modes =
      shorter != nullptr
          ? shorter->modes
          : std::make_shared<const ModalBasis>(modal_basis(parts.body, modes, parts.contact.node, parts.frame));
  give_compliance({modal_compliance(*parts.modes, parts.body, *parts.wilson), {}, {}}, parts.body, *parts.wilson,
                  parts.contact);
  parts.mode_summary = shorter != nullptr ? shorter->mode_summary : summary_of(parts);
}

}  // namespace

Model::Model() : parts_(std::make_unique<Parts>()) {}
Model::~Model() = default;

std::shared_ptr<const Model> Model::build(const Scenario& scenario, std::string& error) {
  return build(scenario, error, 1, nullptr);
}

std::shared_ptr<const Model> Model::build(const Scenario& scenario, std::string& error, int ticks,
                                          const Parts* shorter) {
  std::shared_ptr<Model> model(new Model());
  Parts& parts = *model->parts_;
  parts.key = factor_key(scenario);
  parts.frame = product_frame(scenario);
  const SimulationParameters& simulation = scenario.simulation;
  parts.clock = {simulation.time_step_s, ticks, simulation.theta};
  parts.wilson.emplace(parts.clock.step_s(), simulation.theta);
  const int modes = mode_count(scenario);
  try {
    std::optional<BodyModel> body = build_body(scenario.product, *parts.wilson, error, mass_spread(scenario),
                                               shorter != nullptr ? shorter->body.statics : nullptr,
                                               modes > 0 ? BodyUse::by_modes : BodyUse::by_particles);
    if (!body) return nullptr;
    parts.body = std::move(*body);
    if (modes > 0) {
      touch_by_modes(scenario, static_cast<std::size_t>(modes), shorter, parts);
    } else {
      parts.contact = product_contact(scenario, parts.body, *parts.wilson);
    }
    if (!add_pads(scenario, parts, error)) return nullptr;
    if (!parts.body.factor.single_value.empty()) parts.body.factor.keep_rounded_values_only();
  } catch (const std::invalid_argument& refused) {
    error = refused.what();
    return nullptr;
  }
  const auto shape = true_shape(scenario.product);
  if (shape && parts.body.lattice) parts.carried_surface.emplace(*shape, *parts.body.lattice);
  if (parts.body.is_solid && shorter == nullptr) parts.rest.emplace(*parts.body.statics, parts.contact);
  return model;
}

std::shared_ptr<const Model> Model::with_ticks(int ticks, const Scenario& scenario) const {
  std::string error;
  std::shared_ptr<const Model> longer = build(scenario, error, ticks, parts_.get());
  if (!longer) throw std::runtime_error("the model cannot be built for longer steps: " + error);
  return longer;
}

std::size_t Model::particle_count() const { return parts_->body.particle_count; }
std::size_t Model::freedom_count() const {
  return parts_->modes ? parts_->modes->modes.count() : static_cast<std::size_t>(parts_->body.factor.size);
}
std::size_t Model::contact_candidate_count() const { return parts_->contact.candidate.size(); }
std::size_t Model::factor_entry_count() const { return parts_->body.factor.entry_count; }
const std::optional<ModeSummary>& Model::modes() const { return parts_->mode_summary; }
double Model::max_frequency_Hz() const { return parts_->body.max_frequency_Hz; }

ModelSize model_size(const Scenario& scenario) {
  const ContactChoice choice = contact_choice(scenario);
  return std::visit([&](const auto& kind) { return size_of(kind, choice); }, scenario.product);
}

}  // namespace unbruised
