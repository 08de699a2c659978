#include "core/simulation/balances.hpp"

#include <cmath>

#include "core/lanes/lane_rotation.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

/// Of the work of lifting the product by its smallest extent; a product at rest moves by rounding (1e-14).
constexpr double kLeastInputShare = 1e-9;

/// What the pads do to the product, along the axes of the palm; the moment about the centre of the pads.
struct PadLoad {
  LaneVector force, moment;

  /// The same along x, y, z. @param P of the palm
  void turn(const LaneMatrix& P) {
    force = P * force;
    moment = P * moment;
  }
};

/// Of the particles about their centre of mass [kg m2/s].
std::array<double, 3> angular_momentum(const BodyModel& body, const BodyState& state) {
  std::array<double, 3> center_m{}, sum{};
  for (std::size_t i = 0; i < 3 * body.particle_count; ++i) {
    center_m[i % 3] += body.mass_kg[i / 3] * (body.position_m[i / 3][i % 3] + state.displacement_m[i]);
  }
  for (double& place : center_m) place /= body.total_mass_kg;
  for (std::size_t p = 0; p < body.particle_count; ++p) {
    std::array<double, 3> y{}, v{};
    for (std::size_t d = 0; d < 3; ++d) {
      y[d] = body.position_m[p][d] + state.displacement_m[3 * p + d] - center_m[d];
      v[d] = state.velocity_m_s[3 * p + d];
    }
    const std::array<double, 3> moment = cross(y, v);
    for (std::size_t d = 0; d < 3; ++d) sum[d] += body.mass_kg[p] * moment[d];
  }
  return sum;
}

PadLoad pad_load(const LaneView& view) {
  PadLoad load;
  for (const int surface : view.model.contact.surface) {
    if (!is_pad(surface)) continue;
    const SurfaceTally& tally = view.contact.tally()[static_cast<std::size_t>(surface)];
    const LaneVector force = view.contact.carrier_force(surface);
    for (std::size_t i = 0; i < 3; ++i) {
      load.force[i] += force[i];
      load.moment[i] += tally.torque[i];
    }
  }
  return load;
}

}  // namespace

void Balances::load(int lane, const LaneView& view, const Scenario& scenario) {
  for (Lane& force : palm_force_) force.set(lane, 0.0);
  for (LaneVector& surface : cell_force_) {
    for (Lane& force : surface.at) force.set(lane, 0.0);
  }
  for (Lane& moment : palm_moment_.at) moment.set(lane, 0.0);
  for (Lane* sum : {&palm_work_, &belt_work_, &gravity_work_}) sum->set(lane, 0.0);
  const auto at = static_cast<std::size_t>(lane);
  impulse_[at] = Impulse{};
  impulse_[at].initial_momentum = view.body.momentum(lane);
  for (std::size_t i = 0; i < 3; ++i) impulse_[at].outer_force_N[i] = view.body.mass_a()[i][lane];
  if (const FrameLanes* frame = view.body.frame()) open_angular_account(lane, *frame);
  initial_energy_J_[at] = view.stored_energy(lane, scenario).total;
  double kinetic = view.body.kinetic_energy_J(lane);
  if (has_gripper(scenario)) kinetic += view.gripper.energy()[lane];
  if (view.pads) kinetic += view.pads->energy_J(lane, view.gripper);
  positive_work_.set(lane, kinetic);
}

void Balances::archive(LaneArchive& lane) {
  const auto at = static_cast<std::size_t>(lane.lane());
  lane.object(impulse_[at]);
  lane.object(angular_impulse_[at]);
  lane(initial_energy_J_[at], palm_force_, palm_moment_.at);
  for (LaneVector& force : cell_force_) lane(force.at);
  lane(palm_work_, belt_work_, gravity_work_, positive_work_);
}

void Balances::leave_support(int lane) {
  for (Lane& force : cell_force_[kSupport].at) force.set(lane, 0.0);
}

void Balances::book_step(const LaneView& view, const std::array<Lane, 3>& old_mass_u, const CarrierMotion& before,
                         const CarrierMotion& after, const Mask& running) {
  Lane gravity(0.0), palm(0.0), belt(0.0);
  PadLoad load = pad_load(view);
  if (view.body.frame() != nullptr) {
    const LaneRotation turned = rotation_by(after.palm_rotation_rad);
    load.turn(turned.matrix());
    const LaneVector turn_rad = small_rotation_rad(turned * rotation_by(Lane(-1.0) * before.palm_rotation_rad));
    palm += Lane(0.5) * dot(palm_moment_ + load.moment, turn_rad);
    palm_moment_ = load.moment;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    gravity += view.body.gravity()[i] * (view.body.mass_u()[i] - old_mass_u[i]);
    palm += Lane(0.5) * (palm_force_[i] + load.force[i]) * (after.palm[i].place_m - before.palm[i].place_m);
    palm_force_[i] = load.force[i];
  }
  for (const int surface : view.model.contact.surface) {
    if (is_pad(surface)) continue;
    const auto at = static_cast<std::size_t>(surface);
    const std::array<Lane, 3> force = view.contact.tally()[at].force(surface);
    for (std::size_t i = 0; i < 3; ++i) {
      const Lane way = carrier_of(surface, after)[i].place_m - carrier_of(surface, before)[i].place_m;
      belt += Lane(0.5) * (cell_force_[at][i] + force[i]) * way;
      cell_force_[at][i] = force[i];
    }
  }
  gravity_work_ += select(running, gravity, Lane(0.0));
  palm_work_ += select(running, palm, Lane(0.0));
  belt_work_ += select(running, belt, Lane(0.0));
  positive_work_ +=
      select(running, max(gravity, Lane(0.0)) + max(palm, Lane(0.0)) + max(belt, Lane(0.0)), Lane(0.0));
}

void Balances::book_impulse(int lane, const LaneView& view) {
  Impulse& account = impulse_[static_cast<std::size_t>(lane)];
  for (std::size_t i = 0; i < 3; ++i) {
    double force = view.body.gravity()[i][lane] * view.model.body.total_mass_kg;
    if (const FrameLanes* frame = view.body.frame()) {
      force += frame->outer_force_N()[i][lane];
    } else {
      for (const int surface : view.model.contact.surface) force += view.contact.surface_force(surface, lane)[i];
    }
    account.impulse[i] += 0.5 * view.model.wilson->dt * (account.outer_force_N[i] + force);
    account.outer_force_N[i] = force;
  }
  if (const FrameLanes* frame = view.body.frame()) book_angular_impulse(lane, view.model.wilson->dt, *frame);
}

void Balances::open_angular_account(int lane, const FrameLanes& frame) {
  AngularImpulse& account = angular_impulse_[static_cast<std::size_t>(lane)];
  account = AngularImpulse{};
  account.initial_momentum = of_lane(frame.angular_momentum_kg_m2_s(), lane);
  account.outer_moment_N_m = of_lane(frame.outer_moment_N_m(), lane);
  account.size = length(account.initial_momentum);
}

void Balances::book_angular_impulse(int lane, double step_s, const FrameLanes& frame) {
  AngularImpulse& account = angular_impulse_[static_cast<std::size_t>(lane)];
  const std::array<double, 3> moment_N_m = of_lane(frame.outer_moment_N_m(), lane);
  std::array<double, 3> gained{};
  for (std::size_t i = 0; i < 3; ++i) {
    gained[i] = 0.5 * step_s * (account.outer_moment_N_m[i] + moment_N_m[i]);
    account.impulse[i] += gained[i];
  }
  account.size += length(gained);
  account.outer_moment_N_m = moment_N_m;
}

void Balances::measure_angular_impulse(int lane, const LaneView& view, Metrics& metrics) const {
  const AngularImpulse& account = angular_impulse_[static_cast<std::size_t>(lane)];
  if (!(account.size > 0.0)) return;
  const std::array<double, 3> momentum = angular_momentum(view.model.body, view.body.state(lane));
  std::array<double, 3> error{};
  for (std::size_t i = 0; i < 3; ++i) error[i] = momentum[i] - account.initial_momentum[i] - account.impulse[i];
  metrics[Metric::angular_impulse_balance_error] = length(error) / account.size;
}

double Balances::impulse_mismatch(int lane, const LaneView& view) const {
  const Impulse& account = impulse_[static_cast<std::size_t>(lane)];
  const std::array<double, 3> momentum = view.body.momentum(lane);
  double mismatch = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double error = momentum[i] - account.initial_momentum[i] - account.impulse[i];
    mismatch += error * error;
  }
  return std::sqrt(mismatch);
}

Dissipated Balances::dissipated(int lane, const LaneView& view, const Scenario& scenario) {
  const LayerLosses& layers = view.contact.losses();
  double gripper = has_gripper(scenario) ? view.gripper.dissipated()[lane] : 0.0;
  if (view.pads) gripper += view.pads->damped_J(lane);
  return {.damping = view.body.damped_J(lane) + view.material.relaxed_J(lane, view.body.u()),
          .plastic_flow = view.material.plastic_work()[lane] - view.material.hardening_energy()[lane],
          .layer_viscosity = layers.viscous[lane],
          .friction = layers.friction[lane],
          .layers_left = layers.left[lane],
          .gripper = gripper,
          .mount = view.mounts.dissipated()[lane]};
}

WorkDone Balances::work_done(int lane, const LaneView& view, const Scenario& scenario) const {
  double drives = has_gripper(scenario) ? view.gripper.work()[lane] : 0.0;
  if (view.pads) drives += view.pads->work()[lane];
  return {.gravity = gravity_work_[lane],
          .palm = palm_work_[lane],
          .surfaces = belt_work_[lane],
          .drives = drives,
          .mount = view.mounts.work()[lane]};
}

void Balances::measure(int lane, double time_s, const LaneView& view, const Scenario& scenario,
                       Metrics& metrics) const {
  const BodyModel& product = view.model.body;
  double gravity_size = 0.0;
  for (const Lane& g : view.body.gravity()) gravity_size += g[lane] * g[lane];
  if (!product.is_anchored() && gravity_size > 0.0 && product.is_solid) {
    metrics[Metric::impulse_balance_error] =
        impulse_mismatch(lane, view) / (product.total_mass_kg * std::sqrt(gravity_size) * time_s);
  }
  if (view.body.frame() != nullptr) measure_angular_impulse(lane, view, metrics);
  const Dissipated lost = dissipated(lane, view, scenario);
  const WorkDone done = work_done(lane, view, scenario);
  // The layers' loss is one sum here: its causes are rounded by themselves.
  const double lost_J =
      lost.damping + view.contact.dissipated()[lane] + lost.plastic_flow + lost.mount + lost.gripper;
  const double work_J = done.gravity + done.palm + done.surfaces + done.mount + done.drives;
  double put_in = positive_work_[lane] + view.mounts.positive_work()[lane] +
                  (has_gripper(scenario) ? view.gripper.positive_work()[lane] : 0.0);
  if (view.pads) put_in += view.pads->positive_work()[lane];
  metrics[Metric::energy_input_J] = put_in;
  // Work of loads is not booked. Where next to nothing is put in there is nothing to compare with.
  const double weight_N = product.total_mass_kg * std::sqrt(gravity_size);
  if (!(put_in > kLeastInputShare * weight_N * product.smallest_extent_m()) || has_loads(scenario.product)) return;
  const double stored =
      view.stored_energy(lane, scenario).total - initial_energy_J_[static_cast<std::size_t>(lane)];
  metrics[Metric::energy_balance_error] = (stored + lost_J - work_J) / put_in;
}

}  // namespace unbruised
