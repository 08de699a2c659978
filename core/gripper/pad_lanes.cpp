#include "core/gripper/pad_lanes.hpp"

#include <numeric>
#include <span>

#include "core/algebra/block_matrix.hpp"

namespace unbruised {

PadLanes::PadLanes(const PadBody& pad, const WilsonTheta& wilson)
    : pad_model_(pad), w_(wilson), pad_{Pad(pad, wilson), Pad(pad, wilson)} {
  whole_face_.resize(pad.face.size());
  std::iota(whole_face_.begin(), whole_face_.end(), 0);
  on_fingers_.mass_kg = Lane(pad.felt_mass_kg);
}

void PadLanes::load(int lane, const std::array<double, 3>& outer_m_s2, double opened_m) {
  const BodyModel& model = pad_model_.body;
  const std::size_t freedoms = 3 * model.particle_count;
  for (int f = 0; f < kJawFingers; ++f) {
    Pad& pad = pad_[static_cast<std::size_t>(f)];
    const std::array<double, 3> outer = {normal_sign(f) * outer_m_s2[0], outer_m_s2[1], outer_m_s2[2]};
    std::vector<double> load(freedoms);
    for (std::size_t i = 0; i < freedoms; ++i) load[i] = model.mass_kg[i / 3] * outer[i % 3];
    BodyState state{
        model.statics->free_shape(load), std::vector<double>(freedoms), std::vector<double>(freedoms), {}};
    pad.body.load(lane, state, outer);
    for (std::size_t i = 0; i < 3; ++i) pad.outer[i].set(lane, outer[i]);
  }
  const double thickness_m = model.position_m.back()[0] - model.position_m.front()[0];
  opened_.set(lane, opened_m + 0.5 * thickness_m);
  for (Lane* sum : {&work_, &positive_work_}) sum->set(lane, 0.0);
}

void PadLanes::archive(LaneArchive& lane) {
  for (Pad& pad : pad_) {
    pad.body.archive(lane);
    lane(pad.outer.at);
  }
  lane(work_, positive_work_);
}

LaneVector PadLanes::middle_m(int pad, const GripperLanes& gripper) const {
  return {{Lane(normal_sign(pad)) * (gripper.way(pad) - opened_), Lane(0.0), Lane(0.0)}};
}

void PadLanes::begin_step(const GripperLanes& gripper, const std::array<LaneVector, kJawFingers>& outer_m_s2,
                          const Mask& running) {
  const Lane mass(pad_model_.body.total_mass_kg);
  for (int f = 0; f < kJawFingers; ++f) {
    const auto at = static_cast<std::size_t>(f);
    Pad& pad = pad_[at];
    pad.way = gripper.way(f);
    pad.mass_u = pad.body.mass_u();
    pad.outer_theta = outer_m_s2[at];
    pad.outer_theta[0] *= Lane(normal_sign(f));
    const Lane carried = w_.inertial(gripper.way(f), gripper.speed(f), gripper.acceleration(f));
    pad.body.set_gravity({pad.outer_theta[0] + carried, pad.outer_theta[1], pad.outer_theta[2]});
    pad.body.begin_step(running);
    pad.body.start_solve(nullptr);
    pad.body.solve_without_contact({pad_model_.face, pad_model_.compliance.reach, pad_model_.compliance.block},
                                   pad.free);
    on_fingers_.force_N[at] = Lane(w_.a0) * pad.body.weighted_load(pad_model_.lag) - pad.body.inertial_sum(0) -
                              mass * (carried + pad.outer_theta[0]);
  }
}

void PadLanes::advance(int f, const LaneArray* face_force_N, const Lane& way_theta_m, const Mask& running) {
  BodyLanes& body = pad_[static_cast<std::size_t>(f)].body;
  if (face_force_N != nullptr) {
    body.add_contact(pad_model_.face, whole_face_, *face_force_N);
  }
  body.finish_solve(running);
  body.add_motion(pad_model_.lag, Lane(-w_.a0) * way_theta_m, running);
  body.advance(running);
}

void PadLanes::book_step(const GripperLanes& gripper, const Mask& running) {
  const Lane mass(pad_model_.body.total_mass_kg);
  for (int f = 0; f < kJawFingers; ++f) {
    Pad& pad = pad_[static_cast<std::size_t>(f)];
    Lane done(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
      const Lane after = w_.at_end(pad.outer[i], pad.outer_theta[i]);
      Lane moved = pad.body.mass_u()[i] - pad.mass_u[i];
      if (i == 0) moved += mass * (gripper.way(f) - pad.way);
      done += Lane(0.5) * (pad.outer[i] + after) * moved;
      pad.outer[i] = select(running, after, pad.outer[i]);
    }
    work_ += select(running, done, Lane(0.0));
    positive_work_ += select(running, max0(done), Lane(0.0));
  }
}

double PadLanes::energy_J(int lane, const GripperLanes& gripper) const {
  const BodyModel& model = pad_model_.body;
  const std::size_t freedoms = 3 * model.particle_count;
  std::vector<double> displacement(freedoms), force(freedoms);
  double energy = 0.0;
  for (int f = 0; f < kJawFingers; ++f) {
    const BodyLanes& body = pad_[static_cast<std::size_t>(f)].body;
    for (std::size_t i = 0; i < freedoms; ++i) displacement[i] = body.u().at(i, lane);
    multiply(model.K, std::span<const double>(displacement), std::span<double>(force));
    for (std::size_t i = 0; i < freedoms; ++i) {
      const double speed = body.v().at(i, lane) + (i % 3 == 0 ? gripper.speed(f)[lane] : 0.0);
      energy += 0.5 * (model.mass_kg[i / 3] * speed * speed + displacement[i] * force[i]);
    }
  }
  return energy;
}

double PadLanes::damped_J(int lane) const {
  double sum = 0.0;
  for (const Pad& pad : pad_) sum += pad.body.damped_J(lane);
  return sum;
}

}  // namespace unbruised
