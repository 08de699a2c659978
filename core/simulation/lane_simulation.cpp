#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

#include "core/contact/contact_lanes.hpp"
#include "core/gripper/finger_lanes.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_matrix.hpp"
#include "core/lanes/lane_solve.hpp"
#include "core/lanes/part_timer.hpp"
#include "core/motion/handling_cycle.hpp"
#include "core/outcome/damage_limits.hpp"
#include "core/outcome/handling_record.hpp"
#include "core/product/cell_plasticity.hpp"
#include "core/product/rigid_motion.hpp"
#include "core/product/spring_plasticity.hpp"
#include "core/scenario/opening.hpp"
#include "core/simulation/model_parts.hpp"
#include "core/simulation/trace_recorder.hpp"

namespace unbruised {
namespace {

/// Plastic flow is solved again at most this often within a step; deep flow needs some ten.
constexpr int kMaxPlasticRounds = 60;

}  // namespace

int lane_count() { return kLanes; }

/// Cells with more accumulated plastic strain than this count as bruised where no limit is set.
constexpr double kBruisedStrain = 0.01;

/// One lane's scenario and its clock.
struct LaneRun {
  bool busy = false;
  Scenario scenario;
  HandlingCycle cycle;
  HandlingRecord record;
  std::int64_t step = 0;
  bool lift_started = false;
  Trace* trace = nullptr;
  double contact_sweeps = 0;
  double plastic_rounds = 0;
  double initial_energy_J = 0;
  std::array<double, 3> initial_momentum{};
  std::array<double, 3> impulse{};
  std::array<double, 3> outer_force_N{};  ///< on the product as a whole, at the start of the step
};

struct LaneSimulation::Impl {
  explicit Impl(std::shared_ptr<const Model> shared);

  void load(int lane, const Scenario& scenario);
  void step();

  // The parts of a step, in order.
  void command_drives();
  void build_right_hand_side();
  void add_network_loads();
  void solve_step();
  void solve_contacts_and_product(const Mask& lanes);
  void abort_lanes(const Mask& lanes, const char* cause);
  void advance_state();
  void observe_lanes();

  void start_at_rest(int lane, const Scenario& scenario);
  void start_network(int lane, const NetworkParameters& network, const Scenario& scenario);
  [[nodiscard]] StepObservation observation(int lane, double time_s) const;
  [[nodiscard]] double stored_energy(int lane) const;
  [[nodiscard]] double rotation(int lane) const;
  void finish(int lane, double time_s);
  [[nodiscard]] bool is_anchored() const;
  void measure_permanent_set(int lane, Metrics& metrics) const;
  void measure_balances(int lane, double time_s, Metrics& metrics) const;
  void record(int lane, const StepObservation& seen);

  std::shared_ptr<const Model> model;
  const Model::Parts& parts;
  const WilsonTheta& w;

  std::array<LaneRun, kLanes> run;
  Mask running{false};
  std::vector<Finished> finished;

  LaneArray u, v, a, u_theta;         ///< [3n]
  LaneArray viscous, c_viscous, c_v;  ///< a1 u + 2 v + a3 a; C times it; C v
  LaneArray rhs, x, x_reach;          ///< elimination order
  LaneArray base;                     ///< displacement without contact forces at the contact nodes
  std::unique_ptr<CellPlasticity> cells;
  std::unique_ptr<SpringPlasticity> springs;
  ContactLanes contact;
  FingerLanes fingers;

  CarrierMotion now, theta, next;
  DriveCommand command;
  std::array<Lane, 3> gravity{Lane(0.0), Lane(0.0), Lane(0.0)};
  std::array<Lane, 3> mass_u{Lane(0.0), Lane(0.0), Lane(0.0)};  ///< sum m u
  std::array<Lane, 3> mass_a{Lane(0.0), Lane(0.0), Lane(0.0)};  ///< sum m a
  std::array<Lane, 3> turn{Lane(0.0), Lane(0.0), Lane(0.0)};    ///< sum m r x u
  std::array<Lane, 3> palm_force{Lane(0.0), Lane(0.0),
                                 Lane(0.0)};  ///< of both pads on the product, at the start of the step
  Lane damping_power{0.0}, damped{0.0}, palm_work{0.0}, gravity_work{0.0}, positive_work{0.0};
  Lane sweeps{0.0}, rounds{0.0};
  Lane yield_stress{1.0};  ///< of the product; 1 where it has none and the ratio is not asked for
  StaticRest rest;         ///< of the last gravity and support asked for
  std::array<double, 2> rest_key{-1.0, -1.0};

  bool timing = false;
  PartTimer timer{false};  ///< one for all parts: every moment of a step is counted once
  PartTimes times;
};

namespace {

double smallest_extent(const Model::Parts& parts) {
  std::array<double, 3> low = parts.position_m.front(), high = low;
  for (const auto& p : parts.position_m) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  // Of a network every contact is near: there are few of them, and no body to measure closeness with.
  if (!parts.lattice) return 1e6;
  return std::min({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

/// Place, velocity and acceleration along one axis of one lane.
void set_motion(AxisMotion& motion, int lane, const std::array<double, 3>& values) {
  motion.place_m.set(lane, values[0]);
  motion.velocity_m_s.set(lane, values[1]);
  motion.acceleration_m_s2.set(lane, values[2]);
}

}  // namespace

LaneSimulation::Impl::Impl(std::shared_ptr<const Model> shared)
    : model(std::move(shared)),
      parts(model->parts()),
      w(*parts.wilson),
      contact(parts.contact, smallest_extent(parts)) {
  const std::size_t freedoms = 3 * parts.particle_count;
  for (LaneArray* array : {&u, &v, &a, &u_theta, &viscous, &c_viscous, &c_v}) *array = LaneArray(freedoms);
  for (LaneArray* array : {&rhs, &x, &x_reach}) *array = LaneArray(static_cast<std::size_t>(parts.factor.size));
  base = LaneArray(3 * parts.contact.node_count());
  if (parts.lattice) {
    cells = std::make_unique<CellPlasticity>(*parts.lattice, *parts.cell);
  } else {
    springs = std::make_unique<SpringPlasticity>(parts.springs, parts.particle_count);
  }
}

void LaneSimulation::Impl::load(int lane, const Scenario& scenario) {
  LaneRun& r = run[static_cast<std::size_t>(lane)];
  if (r.busy) throw std::logic_error("LaneSimulation::load: the lane is busy");
  if (factor_key(scenario) != parts.key) {
    throw std::logic_error("LaneSimulation::load: the scenario has another factor key than the model");
  }
  r = LaneRun{};
  r.busy = true;
  r.scenario = scenario;
  r.cycle = HandlingCycle(scenario);
  r.record = HandlingRecord(scenario);
  for (LaneArray* array : {&u, &v, &a, &u_theta}) array->clear_lane(lane);
  for (std::size_t i = 0; i < 3; ++i) {
    gravity[i].set(lane, scenario.cell.gravity_m_s2[i]);
    palm_force[i].set(lane, 0.0);
    set_motion(now.palm[i], lane, {});
    set_motion(now.cell[i], lane, {});
  }
  for (Lane* sum : {&damping_power, &damped, &palm_work, &gravity_work, &positive_work}) sum->set(lane, 0.0);
  // The approach begins in steady motion, but for a grip that is ramped up from rest.
  fingers.load(lane, scenario.gripper,
               scenario.strategy.ramp_from_start ? 0.0 : scenario.strategy.approach_speed_m_s);
  contact.load(lane, scenario, parts.lattice ? parts.lattice->center_m : parts.center_of_mass_m);
  if (const auto* lattice = std::get_if<LatticeParameters>(&scenario.product)) {
    cells->load(lane, *lattice);
    yield_stress.set(lane, lattice->yield_stress_Pa.value_or(1.0));
    start_at_rest(lane, scenario);
  } else {
    springs->load(lane);
    start_network(lane, std::get<NetworkParameters>(scenario.product), scenario);
  }
  contact.set_anchor_to_place(lane, u);
  for (std::size_t i = 0; i < 3; ++i) {
    double sum_u = 0.0;
    for (std::size_t p = 0; p < parts.particle_count; ++p) {
      sum_u += parts.mass_kg[p] * u.at(3 * p + i, lane);
      r.initial_momentum[i] += parts.mass_kg[p] * v.at(3 * p + i, lane);
      r.outer_force_N[i] += parts.mass_kg[p] * a.at(3 * p + i, lane);
    }
    mass_u[i].set(lane, sum_u);
  }
  running.set(lane, true);
  r.initial_energy_J = stored_energy(lane);
  double kinetic = 0.0;
  for (std::size_t i = 0; i < 3 * parts.particle_count; ++i) {
    kinetic += 0.5 * parts.mass_kg[i / 3] * v.at(i, lane) * v.at(i, lane);
  }
  if (scenario.gripper) kinetic += fingers.kinetic_energy()[lane];
  positive_work.set(lane, kinetic);
}

void LaneSimulation::Impl::start_at_rest(int lane, const Scenario& scenario) {
  const auto& lattice = std::get<LatticeParameters>(scenario.product);
  const CellParameters& cell = scenario.cell;
  const double down = -cell.gravity_m_s2[2];
  const bool rests = cell.support && down > 0.0;
  if (rests) {
    const std::array<double, 2> key = {down, cell.support_modulus_Pa / cell.support_thickness_m};
    if (key != rest_key) {
      rest = parts.statics->rest_on_support(parts.contact, key[0], key[1]);
      rest_key = key;
    }
    for (std::size_t i = 0; i < rest.displacement_m.size(); ++i) u.at(i, lane) = rest.displacement_m[i];
    for (std::size_t c = 0; c < rest.normal_force_N.size(); ++c) {
      if (rest.normal_force_N[c] > 0.0)
        contact.set_support_force(lane, static_cast<int>(c), rest.normal_force_N[c], rest.penetration_m[c]);
    }
  }
  for (std::size_t i = 0; i < 3 * parts.particle_count; ++i) {
    const std::size_t axis = i % 3;
    v.at(i, lane) = lattice.initial_velocity_m_s[axis];
    a.at(i, lane) = rests && axis == 2 ? 0.0 : cell.gravity_m_s2[axis];
  }
}

void LaneSimulation::Impl::start_network(int lane, const NetworkParameters& network, const Scenario& scenario) {
  for (std::size_t p = 0; p < parts.particle_count; ++p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (parts.fixed[p][axis]) continue;
      u.at(3 * p + axis, lane) = network.particle[p].initial_displacement_m[axis];
      v.at(3 * p + axis, lane) = network.particle[p].initial_velocity_m_s[axis];
    }
  }
  const std::vector<double> load = network_load_N(network, 0.0);
  if (scenario.simulation.initial_acceleration == InitialAcceleration::zero) return;
  // M a = f - C v - K u.
  std::vector<double> displacement(3 * parts.particle_count), velocity(displacement.size());
  std::vector<double> elastic(displacement.size()), damping(displacement.size());
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    displacement[i] = u.at(i, lane);
    velocity[i] = v.at(i, lane);
  }
  multiply(parts.K, std::span<const double>(displacement), std::span<double>(elastic));
  multiply(parts.C, std::span<const double>(velocity), std::span<double>(damping));
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    if (parts.slot[i] < 0) continue;
    const double mass = parts.mass_kg[i / 3];
    const double force = load[i] + parts.rest_force_N[i] - elastic[i] - damping[i];
    a.at(i, lane) = force / mass + scenario.cell.gravity_m_s2[i % 3];
  }
}

void LaneSimulation::Impl::step() {
  finished.clear();
  if (none(running)) return;
  timer = PartTimer(timing);
  command_drives();
  build_right_hand_side();
  timer.lap(times.right_hand_side_s);
  solve_step();
  advance_state();
  observe_lanes();
  timer.lap(times.update_s);
}

void LaneSimulation::Impl::command_drives() {
  for (int lane = 0; lane < kLanes; ++lane) {
    const LaneRun& r = run[static_cast<std::size_t>(lane)];
    if (!r.busy) continue;
    const double t = static_cast<double>(r.step) * w.dt;
    const double t_theta = t + w.theta * w.dt;
    const double t_next = static_cast<double>(r.step + 1) * w.dt;
    const PalmState palm_theta = r.cycle.palm(t_theta);
    const PalmState palm_next = r.cycle.palm(t_next);
    for (std::size_t i = 0; i < 3; ++i) {
      set_motion(theta.palm[i], lane,
                 {palm_theta.position_m[i], palm_theta.velocity_m_s[i], palm_theta.acceleration_m_s2[i]});
      set_motion(next.palm[i], lane,
                 {palm_next.position_m[i], palm_next.velocity_m_s[i], palm_next.acceleration_m_s2[i]});
    }
    // The plane under the product is another one once the product is lifted; neither of them moves.
    set_motion(theta.cell[2], lane, {r.cycle.support_height_m(t_theta), 0.0, 0.0});
    set_motion(next.cell[2], lane, {r.cycle.support_height_m(t_next), 0.0, 0.0});
    if (!r.scenario.gripper) continue;
    command.palm_acceleration_x_m_s2.set(lane, palm_theta.acceleration_m_s2[0]);
    command.force_limit_N.set(lane, r.cycle.force_limit_N(t_theta));
    double speed = r.cycle.set_speed_m_s(t_theta);
    // End stops: inwards at the end of the stroke, outwards where the fingers started.
    const double way = std::max(fingers.way(0)[lane], fingers.way(1)[lane]);
    if (speed > 0.0 && way >= r.scenario.gripper->stroke_m) speed = 0.0;
    if (speed < 0.0 && way <= 0.0) speed = 0.0;
    command.set_speed_m_s.set(lane, speed);
  }
  fingers.begin_step(w, command);
}

void LaneSimulation::Impl::build_right_hand_side() {
  const std::size_t freedoms = 3 * parts.particle_count;
  for (std::size_t i = 0; i < freedoms; ++i) viscous.put(i, w.viscous(u.get(i), v.get(i), a.get(i)));
  const bool proportional = parts.C.value.empty();
  multiply_two(proportional ? parts.K : parts.C, viscous, v, c_viscous, c_v);
  const Lane factor(proportional ? parts.relaxation_time_s : 1.0);
  Lane power(0.0);
  for (std::size_t i = 0; i < freedoms; ++i) {
    const int slot = parts.slot[i];
    if (slot < 0) continue;
    const Lane mass(parts.mass_kg[i / 3]);
    const Lane vi = v.get(i);
    power += factor * vi * c_v.get(i);
    rhs.put(static_cast<std::size_t>(slot),
            mass * (w.inertial(u.get(i), vi, a.get(i)) + gravity[i % 3]) + factor * c_viscous.get(i));
  }
  // v'Cv by the trapezoid rule over time.
  for (int lane = 0; lane < kLanes; ++lane) {
    if (run[static_cast<std::size_t>(lane)].busy && run[static_cast<std::size_t>(lane)].step == 0) {
      damping_power.set(lane, power[lane]);
      damped.set(lane, -0.5 * w.dt * power[lane]);
    }
  }
  damped += select(running, Lane(w.dt) * power, Lane(0.0));
  damping_power = power;
  if (!parts.rest_force_N.empty()) add_network_loads();
}

void LaneSimulation::Impl::add_network_loads() {
  for (std::size_t i = 0; i < parts.rest_force_N.size(); ++i) {
    const int slot = parts.slot[i];
    if (slot >= 0)
      rhs.put(static_cast<std::size_t>(slot),
              rhs.get(static_cast<std::size_t>(slot)) + Lane(parts.rest_force_N[i]));
  }
  for (int lane = 0; lane < kLanes; ++lane) {
    LaneRun& r = run[static_cast<std::size_t>(lane)];
    if (!r.busy) continue;
    const auto& network = std::get<NetworkParameters>(r.scenario.product);
    if (network.load.empty()) continue;
    const double t = static_cast<double>(r.step) * w.dt;
    const std::vector<double> at_t = network_load_N(network, t);
    const std::vector<double> at_next =
        network_load_N(network, static_cast<double>(r.step + 1) * w.dt, JumpSide::left);
    for (std::size_t i = 0; i < at_t.size(); ++i) {
      const int slot = parts.slot[i];
      if (slot < 0) continue;
      rhs.at(static_cast<std::size_t>(slot), lane) += at_t[i] + w.theta * (at_next[i] - at_t[i]);
    }
  }
}

void LaneSimulation::Impl::solve_step() {
  Mask pending = running;
  rounds = Lane(0.0);
  sweeps = Lane(0.0);
  if (cells) cells->begin_step();
  timer.lap(times.plasticity_s);
  for (int round = 0; round < kMaxPlasticRounds; ++round) {
    solve_contacts_and_product(pending);
    if (cells) {
      pending = cells->update(u_theta, pending);
    } else if (springs->exists()) {
      pending = springs->update(u_theta, pending);
    } else {
      pending = Mask(false);
    }
    timer.lap(times.plasticity_s);
    if (none(pending)) return;
    rounds += select(pending, Lane(1.0), Lane(0.0));
  }
  abort_lanes(pending, "plastic flow did not converge within a step");
}

void LaneSimulation::Impl::abort_lanes(const Mask& lanes, const char* cause) {
  if (none(lanes)) return;
  for (int lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    LaneRun& r = run[static_cast<std::size_t>(lane)];
    r.record.abort(Outcome::diverged, cause, static_cast<double>(r.step) * w.dt);
  }
}

void LaneSimulation::Impl::solve_contacts_and_product(const Mask& lanes) {
  const bool first_round = none(rounds > Lane(0.0));
  const LaneArray* plastic = cells ? &cells->load_theta() : (springs->exists() ? &springs->load_theta() : nullptr);
  for (std::size_t i = 0; i < 3 * parts.particle_count; ++i) {
    const int slot = parts.slot[i];
    if (slot < 0) continue;
    const auto at = static_cast<std::size_t>(slot);
    x.put(at, plastic != nullptr ? rhs.get(at) + plastic->get(i) : rhs.get(at));
  }
  solve_forward(parts.factor, x.data());
  const ContactModel& touch = parts.contact;
  if (touch.node_count() > 0) {
    // Backwards on the reach of the contact freedoms only: their displacement without contact forces.
    for (int s : touch.reach) {
      const Supernode& node = parts.factor.supernode[s];
      std::copy_n(x.row(static_cast<std::size_t>(node.first_column)), node.column_count * kLanes,
                  x_reach.row(static_cast<std::size_t>(node.first_column)));
    }
    solve_backward(parts.factor, touch.reach, x_reach.data());
    for (std::size_t i = 0; i < 3 * touch.node_count(); ++i) {
      const int slot = parts.slot[3 * static_cast<std::size_t>(touch.node[i / 3]) + i % 3];
      base.put(i, slot >= 0 ? x_reach.get(static_cast<std::size_t>(slot)) : Lane(0.0));
    }
    timer.lap(times.solve_s);
    if (first_round) {
      contact.begin_step(w, u, v, a, now, theta, fingers, base, lanes);
    } else {
      contact.rebase(base, lanes);
    }
    if (!contact.idle()) {
      sweeps += contact.solve(fingers, lanes);
      abort_lanes(contact.unsolved(), "the contact forces did not converge within a step");
      timer.lap(times.contact_s);
      for (int s : touch.reach) {
        const Supernode& node = parts.factor.supernode[s];
        std::fill_n(x_reach.row(static_cast<std::size_t>(node.first_column)), node.column_count * kLanes, 0.0);
      }
      for (int node : contact.active_nodes()) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const int slot = parts.slot[3 * static_cast<std::size_t>(touch.node[node]) + axis];
          if (slot >= 0) {
            x_reach.put(static_cast<std::size_t>(slot),
                        contact.node_force().get(3 * static_cast<std::size_t>(node) + axis));
          }
        }
      }
      solve_forward(parts.factor, touch.reach, x_reach.data());
      for (int s : touch.reach) {
        const Supernode& node = parts.factor.supernode[s];
        const auto first = static_cast<std::size_t>(node.first_column);
        for (std::size_t c = first; c < first + static_cast<std::size_t>(node.column_count); ++c) {
          x.put(c, x.get(c) + x_reach.get(c));
        }
      }
    } else {
      timer.lap(times.contact_s);
    }
  }
  solve_backward(parts.factor, x.data());
  for (std::size_t i = 0; i < 3 * parts.particle_count; ++i) {
    const int slot = parts.slot[i];
    if (slot >= 0) u_theta.put(i, select(lanes, x.get(static_cast<std::size_t>(slot)), u_theta.get(i)));
  }
  timer.lap(times.solve_s);
}

void LaneSimulation::Impl::advance_state() {
  std::array<Lane, 3> old_mass_u = mass_u;
  for (std::size_t i = 0; i < 3; ++i) mass_u[i] = mass_a[i] = turn[i] = Lane(0.0);
  for (std::size_t p = 0; p < parts.particle_count; ++p) {
    const Lane mass(parts.mass_kg[p]);
    Lane moved[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t i = 3 * p + axis;
      Lane ui = u.get(i), vi = v.get(i), ai = a.get(i);
      const Lane old_u = ui, old_v = vi, old_a = ai;
      w.advance(u_theta.get(i), ui, vi, ai);
      ui = select(running, ui, old_u);
      ai = select(running, ai, old_a);
      if (parts.slot[i] < 0) {
        ui = ai = Lane(0.0);
        vi = Lane(0.0);
      }
      u.put(i, ui);
      v.put(i, select(running, vi, old_v));
      a.put(i, ai);
      moved[axis] = mass * ui;
      mass_u[axis] += moved[axis];
      mass_a[axis] += mass * ai;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
      turn[axis] += Lane(parts.position_m[p][j] - parts.center_of_mass_m[j]) * moved[k] -
                    Lane(parts.position_m[p][k] - parts.center_of_mass_m[k]) * moved[j];
    }
  }
  const std::array<Lane, 2> pads = contact.pad_force_theta();
  fingers.advance(w, pads, running);
  contact.end_step(w, u_theta, u, parts.position_m, next, running);
  if (cells) {
    cells->end_step(w, running);
  } else {
    springs->end_step(w, running);
  }
  // Work of gravity and of the palm; forces are linear over the step.
  Lane step_gravity(0.0), step_palm(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    step_gravity += gravity[i] * (mass_u[i] - old_mass_u[i]);
    Lane force(0.0);
    for (int pad = 0; pad < 2; ++pad) {
      const SurfaceTally& tally = contact.tally()[static_cast<std::size_t>(pad)];
      force += i == 0 ? Lane(normal_sign(pad)) * tally.normal : tally.tangent[i - 1];
    }
    step_palm += Lane(0.5) * (palm_force[i] + force) * (next.palm[i].place_m - now.palm[i].place_m);
    palm_force[i] = force;
  }
  gravity_work += select(running, step_gravity, Lane(0.0));
  palm_work += select(running, step_palm, Lane(0.0));
  positive_work += select(running, max(step_gravity, Lane(0.0)) + max(step_palm, Lane(0.0)), Lane(0.0));
  now = next;
}

double LaneSimulation::Impl::rotation(int lane) const {
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    double angle = 0.0;
    for (std::size_t j = 0; j < 3; ++j) angle += parts.inverse_inertia[3 * i + j] * turn[j][lane];
    square += angle * angle;
  }
  return std::sqrt(square);
}

StepObservation LaneSimulation::Impl::observation(int lane, double time_s) const {
  const LaneRun& r = run[static_cast<std::size_t>(lane)];
  StepObservation now_seen;
  now_seen.time_s = time_s;
  now_seen.register_time_s = time_s + (w.theta - 1.0) * w.dt;
  for (std::size_t i = 0; i < 3; ++i) {
    now_seen.center_motion_m[i] = mass_u[i][lane] / parts.total_mass_kg;
    now_seen.center_acceleration_m_s2[i] = mass_a[i][lane] / parts.total_mass_kg;
    now_seen.palm_m[i] = now.palm[i].place_m[lane];
  }
  if (cells) {
    now_seen.plastic_strain = cells->largest_plastic_strain()[lane];
    now_seen.absorbed_energy_J = cells->plastic_work()[lane];
  } else {
    now_seen.plastic_strain = springs->largest_plastic_strain()[lane];
    now_seen.absorbed_energy_J = springs->plastic_work()[lane];
  }
  if (!r.scenario.gripper) return now_seen;
  for (std::size_t f = 0; f < 2; ++f) {
    const SurfaceTally& tally = contact.tally()[f];
    FingerObservation& finger = now_seen.finger[f];
    finger.normal_N = tally.normal[lane];
    finger.tangent_N = {tally.tangent[0][lane], tally.tangent[1][lane]};
    finger.closed_contacts = tally.closed[lane];
    finger.sliding_contacts = tally.sliding[lane];
    finger.travel_sum_m = tally.travel[lane];
    for (std::size_t i = 0; i < 3; ++i) now_seen.torque_N_m[i] += tally.torque[i][lane];
  }
  now_seen.patch_pressure_Pa = contact.patch_pressure()[lane];
  const double closing = fingers.way(0)[lane] + fingers.way(1)[lane];
  now_seen.compression_m = closing - 2.0 * approach_gap_m(r.scenario);
  now_seen.end_of_stroke = std::max(fingers.way(0)[lane], fingers.way(1)[lane]) >= r.scenario.gripper->stroke_m;
  return now_seen;
}

void LaneSimulation::Impl::observe_lanes() {
  const std::array<Lane, 2> yield_ratio = {contact.yield_ratio(0, yield_stress),
                                           contact.yield_ratio(1, yield_stress)};
  ++times.steps;
  for (int lane = 0; lane < kLanes; ++lane) {
    LaneRun& r = run[static_cast<std::size_t>(lane)];
    if (!r.busy) continue;
    ++times.lane_steps;
    const double start = static_cast<double>(r.step) * w.dt;
    ++r.step;
    const double time = static_cast<double>(r.step) * w.dt;
    r.contact_sweeps += sweeps[lane];
    r.plastic_rounds += rounds[lane];
    if (r.scenario.gripper) {
      const double touch = contact.first_touch()[lane];
      if (touch <= 1.0) r.cycle.contact_made(start + touch * w.theta * w.dt);
      if (!r.lift_started && time >= r.cycle.lift_start_s()) {
        r.lift_started = true;
        contact.reset_travel(lane);
      }
    }
    StepObservation seen = observation(lane, time);
    for (std::size_t f = 0; f < 2; ++f) seen.finger[f].yield_ratio = yield_ratio[f][lane];
    // Impulse of everything outside the product over the step; forces are linear in time.
    for (std::size_t i = 0; i < 3; ++i) {
      double force = gravity[i][lane] * parts.total_mass_kg;
      for (int surface = 0; surface < kSurfaceCount; ++surface) {
        force += contact.surface_force(surface, lane)[i];
      }
      r.impulse[i] += 0.5 * w.dt * (r.outer_force_N[i] + force);
      r.outer_force_N[i] = force;
    }
    bool goes_on = r.record.observe(seen, r.cycle);
    const double size =
        mass_u[0][lane] + mass_u[1][lane] + mass_u[2][lane] + mass_a[0][lane] + mass_a[1][lane] + mass_a[2][lane];
    if (!std::isfinite(size) || (cells && !std::isfinite(cells->largest_strain()[lane]))) {
      r.record.abort(Outcome::diverged, "the motion is not finite", time);
    } else if (cells && cells->largest_strain()[lane] > r.scenario.simulation.max_strain) {
      r.record.abort(Outcome::out_of_range, "a cell's strain > simulation.max_strain", time);
    } else if (cells && rotation(lane) > r.scenario.simulation.max_rotation_rad) {
      r.record.abort(Outcome::out_of_range, "the product's rotation > simulation.max_rotation_rad", time);
    }
    if (r.trace != nullptr) {
      contact.record_events(lane, start, w, r.trace->events);
      record(lane, seen);
    }
    goes_on = goes_on && !r.record.aborted();
    if (!goes_on || time >= r.cycle.end_s() - 1e-9 * w.dt) finish(lane, time);
  }
}

double LaneSimulation::Impl::stored_energy(int lane) const {
  const std::size_t freedoms = 3 * parts.particle_count;
  std::vector<double> displacement(freedoms), force(freedoms);
  for (std::size_t i = 0; i < freedoms; ++i) displacement[i] = u.at(i, lane);
  multiply(parts.K, std::span<const double>(displacement), std::span<double>(force));
  const std::vector<double> plastic = cells ? cells->plastic_load_N(lane) : springs->plastic_load_N(lane);
  double energy = 0.0;
  for (std::size_t i = 0; i < freedoms; ++i) {
    energy += 0.5 * parts.mass_kg[i / 3] * v.at(i, lane) * v.at(i, lane);
    energy += displacement[i] * (0.5 * force[i] - plastic[i]);
    if (!parts.rest_force_N.empty()) energy -= displacement[i] * parts.rest_force_N[i];
  }
  energy += cells ? cells->self_energy(lane) + cells->hardening_energy()[lane]
                  : springs->self_energy(lane) + springs->hardening_energy()[lane];
  return energy + contact.stored_energy()[lane] +
         (run[static_cast<std::size_t>(lane)].scenario.gripper ? fingers.kinetic_energy()[lane] : 0.0);
}

bool LaneSimulation::Impl::is_anchored() const {
  return std::any_of(parts.fixed.begin(), parts.fixed.end(), [](const auto& f) { return f[0] || f[1] || f[2]; });
}

void LaneSimulation::Impl::measure_permanent_set(int lane, Metrics& metrics) const {
  metrics[Metric::permanent_set_max_m] = metrics[Metric::permanent_set_rms_m] = 0.0;
  if (cells) {
    const auto& limits = run[static_cast<std::size_t>(lane)].scenario.limits;
    metrics[Metric::bruised_volume_m3] = cells->volume_above(lane, limits.plastic_strain.value_or(kBruisedStrain));
  }
  const Lane& plastic = cells ? cells->largest_plastic_strain() : springs->largest_plastic_strain();
  if (!(plastic[lane] > 0.0)) return;
  std::vector<double> shape =
      parts.statics->free_shape(cells ? cells->plastic_load_N(lane) : springs->plastic_load_N(lane));
  if (!is_anchored()) remove_rigid_motion(parts.position_m, shape);
  double largest = 0.0, sum = 0.0;
  for (std::size_t p = 0; p < parts.particle_count; ++p) {
    const double square =
        shape[3 * p] * shape[3 * p] + shape[3 * p + 1] * shape[3 * p + 1] + shape[3 * p + 2] * shape[3 * p + 2];
    largest = std::max(largest, square);
    sum += square;
  }
  metrics[Metric::permanent_set_max_m] = std::sqrt(largest);
  metrics[Metric::permanent_set_rms_m] = std::sqrt(sum / static_cast<double>(parts.particle_count));
}

void LaneSimulation::Impl::measure_balances(int lane, double time_s, Metrics& metrics) const {
  const LaneRun& r = run[static_cast<std::size_t>(lane)];
  double gravity_size = 0.0, mismatch = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    double momentum = 0.0;
    for (std::size_t p = 0; p < parts.particle_count; ++p) momentum += parts.mass_kg[p] * v.at(3 * p + i, lane);
    const double error = momentum - r.initial_momentum[i] - r.impulse[i];
    mismatch += error * error;
    gravity_size += gravity[i][lane] * gravity[i][lane];
  }
  if (!is_anchored() && gravity_size > 0.0 && parts.lattice) {
    metrics[Metric::impulse_balance_error] =
        std::sqrt(mismatch) / (parts.total_mass_kg * std::sqrt(gravity_size) * time_s);
  }
  const bool driven = r.scenario.gripper.has_value();
  const double plastic = cells ? cells->plastic_work()[lane] - cells->hardening_energy()[lane]
                               : springs->plastic_work()[lane] - springs->hardening_energy()[lane];
  const double dissipated = damped[lane] + 0.5 * w.dt * damping_power[lane] + contact.dissipated()[lane] +
                            plastic + (driven ? fingers.dissipated()[lane] : 0.0);
  const double work = gravity_work[lane] + palm_work[lane] + (driven ? fingers.work()[lane] : 0.0);
  const double put_in = positive_work[lane] + (driven ? fingers.positive_work()[lane] : 0.0);
  metrics[Metric::energy_input_J] = put_in;
  const bool loaded = !parts.lattice && !std::get<NetworkParameters>(r.scenario.product).load.empty();
  if (put_in > 0.0 && !loaded) {
    metrics[Metric::energy_balance_error] =
        (stored_energy(lane) - r.initial_energy_J + dissipated - work) / put_in;
  }
}

void LaneSimulation::Impl::finish(int lane, double time_s) {
  LaneRun& r = run[static_cast<std::size_t>(lane)];
  Metrics& metrics = r.record.metrics;
  metrics[Metric::step_count] = static_cast<double>(r.step);
  metrics[Metric::contact_iterations] = r.contact_sweeps;
  metrics[Metric::plasticity_iterations] = r.plastic_rounds;
  if (!r.record.aborted()) measure_permanent_set(lane, metrics);
  if (!r.record.diverged()) measure_balances(lane, time_s, metrics);
  finished.push_back({lane, r.record.finish(r.cycle, time_s)});
  r.busy = false;
  r.trace = nullptr;
  running.set(lane, false);
}

void LaneSimulation::Impl::record(int lane, const StepObservation& seen) {
  LaneRun& r = run[static_cast<std::size_t>(lane)];
  const double every = r.scenario.simulation.trace_interval_s.value_or(w.dt);
  const auto stride = std::max<std::int64_t>(1, std::llround(every / w.dt));
  if (r.step % stride != 0) return;
  TraceRow row;
  row.time_s = static_cast<double>(r.step) * w.dt;
  row.lane = lane;
  row.gripper = r.scenario.gripper.has_value();
  row.yields = can_yield(r.scenario);
  for (int surface = 0; surface < kSurfaceCount; ++surface) {
    row.surface_force_N[static_cast<std::size_t>(surface)] = contact.surface_force(surface, lane);
    row.closed[static_cast<std::size_t>(surface)] =
        contact.tally()[static_cast<std::size_t>(surface)].closed[lane];
    row.sliding[static_cast<std::size_t>(surface)] =
        contact.tally()[static_cast<std::size_t>(surface)].sliding[lane];
  }
  for (int f = 0; f < 2; ++f) {
    row.finger_way_m[static_cast<std::size_t>(f)] = fingers.way(f)[lane];
    row.finger_speed_m_s[static_cast<std::size_t>(f)] = fingers.speed(f)[lane];
    const FingerObservation& finger = seen.finger[static_cast<std::size_t>(f)];
    row.yield_ratio[static_cast<std::size_t>(f)] = finger.yield_ratio;
    if (r.lift_started && finger.closed_contacts > 0) {
      row.slip_m[static_cast<std::size_t>(f)] = finger.travel_sum_m / finger.closed_contacts;
    }
  }
  row.phase = r.cycle.phase(row.time_s);
  row.patch_pressure_Pa = seen.patch_pressure_Pa;
  row.absorbed_energy_J = seen.absorbed_energy_J;
  for (std::size_t i = 0; i < 3; ++i) row.palm_m[i] = now.palm[i].place_m[lane];
  row.plastic_strain = cells ? cells->largest_plastic_strain()[lane] : springs->largest_plastic_strain()[lane];
  row.stored_energy_J = stored_energy(lane);
  row.contact_energy_J = contact.stored_energy()[lane];
  append_row(row, u, v, a, *r.trace);
}

LaneSimulation::LaneSimulation(std::shared_ptr<const Model> model)
    : impl_(std::make_unique<Impl>(std::move(model))) {}
LaneSimulation::~LaneSimulation() = default;
void LaneSimulation::load(int lane, const Scenario& scenario) { impl_->load(lane, scenario); }
bool LaneSimulation::busy(int lane) const { return impl_->run[static_cast<std::size_t>(lane)].busy; }
int LaneSimulation::busy_count() const {
  return static_cast<int>(
      std::count_if(impl_->run.begin(), impl_->run.end(), [](const LaneRun& r) { return r.busy; }));
}
void LaneSimulation::step() { impl_->step(); }
const std::vector<LaneSimulation::Finished>& LaneSimulation::finished() const { return impl_->finished; }
void LaneSimulation::enable_timing() { impl_->timing = true; }
const LaneSimulation::PartTimes& LaneSimulation::part_times() const { return impl_->times; }

void LaneSimulation::record_trace(int lane, Trace& trace) {
  Impl& impl = *impl_;
  start_trace(impl.parts.position_m, impl.run[static_cast<std::size_t>(lane)].scenario, trace);
  impl.run[static_cast<std::size_t>(lane)].trace = &trace;
  impl.record(lane, {});
}

ScenarioResult simulate(const std::shared_ptr<const Model>& model, const Scenario& scenario, Trace* trace) {
  LaneSimulation simulation(model);
  simulation.load(0, scenario);
  if (trace != nullptr) simulation.record_trace(0, *trace);
  while (simulation.busy(0)) simulation.step();
  return simulation.finished().front().result;
}

}  // namespace unbruised
