#include <stdexcept>

#include "core/scenario/factor_key.hpp"
#include "core/simulation/model_parts.hpp"

namespace unbruised {

Model::Model() : parts_(std::make_unique<Parts>()) {}
Model::~Model() = default;

std::shared_ptr<const Model> Model::build(const Scenario& scenario, std::string& error) {
  std::shared_ptr<Model> model(new Model());
  Parts& parts = *model->parts_;
  parts.key = factor_key(scenario);
  parts.wilson.emplace(scenario.simulation.time_step_s, scenario.simulation.theta);
  try {
    std::optional<BodyModel> body = build_body(scenario.product, *parts.wilson, error);
    if (!body) return nullptr;
    parts.body = std::move(*body);
  } catch (const std::invalid_argument& refused) {
    error = refused.what();
    return nullptr;
  }
  parts.contact = product_contact(scenario.product, parts.body, scenario.simulation.pressure_patch_m);
  if (parts.body.lattice) parts.rest.emplace(*parts.body.statics, parts.contact);
  return model;
}

std::size_t Model::particle_count() const { return parts_->body.particle_count; }
std::size_t Model::freedom_count() const { return static_cast<std::size_t>(parts_->body.factor.size); }
std::size_t Model::contact_candidate_count() const { return parts_->contact.candidate.size(); }
std::size_t Model::factor_entry_count() const { return parts_->body.factor.entry_count; }
double Model::max_frequency_Hz() const { return parts_->body.max_frequency_Hz; }

ModelSize model_size(const Scenario& scenario) {
  ModelSize size;
  if (const auto* parameters = std::get_if<LatticeParameters>(&scenario.product)) {
    const Lattice lattice = build_lattice(*parameters);
    size.particle_count = lattice.position_m.size();
    size.freedom_count = 3 * size.particle_count;
    size.contact_candidate_count =
        lattice_contact(*parameters, lattice, scenario.simulation.pressure_patch_m).candidate.size();
    return size;
  }
  const auto& network = std::get<NetworkParameters>(scenario.product);
  size.particle_count = network.particle.size();
  for (const NetworkParticle& particle : network.particle) {
    for (bool fixed : particle.fixed) size.freedom_count += fixed ? 0 : 1;
    size.contact_candidate_count += particle.contact_stiffness_N_m > 0.0 ? 1 : 0;
  }
  return size;
}

}  // namespace unbruised
