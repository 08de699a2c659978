#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/lanes/part_timer.hpp"
#include "core/scenario/product.hpp"
#include "core/simulation/balances.hpp"
#include "core/simulation/initial_state.hpp"
#include "core/simulation/lane_drives.hpp"
#include "core/simulation/lane_run.hpp"
#include "core/simulation/lane_view.hpp"

namespace unbruised {
namespace {

/// Plastic flow is solved again at most this often within a step; deep flow needs some ten.
constexpr int kMaxPlasticRounds = 60;

}  // namespace

int lane_count() { return kLanes; }

struct LaneSimulation::Impl {
  explicit Impl(std::shared_ptr<const Model> shared);

  void load(int lane, const Scenario& scenario);
  void step();

  // The parts of a step, in order.
  void follow_plans();
  void add_loads();
  void solve_step();
  void solve_contacts_and_product(const Mask& lanes);
  void advance_state();
  void observe_lanes();

  void abort_lanes(const Mask& lanes, const char* cause);
  void tell_cycle(int lane, double start_s, double time_s);
  void check_validity(int lane, double time_s);
  void observe_lane(int lane, const std::array<Lane, kFingerCount>& yield_ratio);
  void finish(int lane, double time_s);
  void record(int lane, const StepObservation& seen);
  [[nodiscard]] LaneRun& run_of(int lane) {
    if (lane < 0 || lane >= kLanes) throw std::logic_error("LaneSimulation: there is no such lane");
    return run[static_cast<std::size_t>(lane)];
  }

  std::shared_ptr<const Model> model;
  const Model::Parts& parts;
  const WilsonTheta& w;

  std::array<LaneRun, kLanes> run;
  Mask running{false};
  std::vector<Finished> finished;

  InitialStates initial;
  BodyLanes body;
  std::unique_ptr<Material> material;
  ContactLanes contact;
  FingerLanes fingers;
  CarrierMotion now, theta, next;
  DriveCommand command;
  Balances balances;
  LaneView view;

  LaneArray base;  ///< displacement without contact forces at the contact nodes
  Lane sweeps{0.0}, rounds{0.0};
  Lane yield_stress{1.0};  ///< of the product; 1 where it has none and the ratio is not asked for

  bool timing = false;
  PartTimer timer{false};  ///< one for all parts: every moment of a step is counted once
  PartTimes times;
};

LaneSimulation::Impl::Impl(std::shared_ptr<const Model> shared)
    : model(std::move(shared)),
      parts(model->parts()),
      w(*parts.wilson),
      initial(parts),
      body(parts.body, w),
      material(make_material(parts.body)),
      contact(parts.contact, parts.body, w),
      view{parts, body, *material, contact, fingers, now},
      base(3 * parts.contact.node_count()) {}

void LaneSimulation::Impl::load(int lane, const Scenario& scenario) {
  LaneRun& r = run_of(lane);
  if (r.busy) throw std::logic_error("LaneSimulation::load: the lane is busy");
  if (factor_key(scenario) != parts.key) {
    throw std::logic_error("LaneSimulation::load: the scenario has another factor key than the model");
  }
  r = LaneRun{};
  r.busy = true;
  r.scenario = scenario;
  r.cycle = HandlingCycle(scenario);
  r.record = HandlingRecord(scenario);
  for (std::size_t i = 0; i < 3; ++i) {
    set_motion(now.palm[i], lane, {});
    set_motion(now.cell[i], lane, {});
  }
  // The approach begins in steady motion, but for a grip that is ramped up from rest.
  fingers.load(lane, parallel_jaw(scenario),
               scenario.strategy.ramp_from_start ? 0.0 : scenario.strategy.approach_speed_m_s,
               r.cycle.plan().force_limit_N(0.0));
  contact.load(lane, scenario);
  material->load(lane, scenario);
  yield_stress.set(lane, yield_stress_Pa(scenario.product).value_or(1.0));
  const InitialState state = initial.of(scenario, material->plastic_load_N(lane));
  body.load(lane, state.body, scenario.cell.gravity_m_s2);
  if (state.rest != nullptr) contact.set_rest(lane, *state.rest);
  contact.set_anchors(lane, body.u());
  running.set(lane, true);
  balances.load(lane, view, scenario);
}

void LaneSimulation::Impl::step() {
  finished.clear();
  if (none(running)) return;
  timer = PartTimer(timing);
  follow_plans();
  fingers.begin_step(w, command);
  body.begin_step(running);
  add_loads();
  timer.lap(times.right_hand_side_s);
  solve_step();
  advance_state();
  observe_lanes();
  timer.lap(times.update_s);
}

void LaneSimulation::Impl::follow_plans() {
  for (int lane = 0; lane < kLanes; ++lane) {
    const LaneRun& r = run_of(lane);
    if (!r.busy) continue;
    set_carriers(lane, r.cycle.plan(), r.theta_time_s(w), theta);
    set_carriers(lane, r.cycle.plan(), r.end_time_s(w), next);
    if (!has_gripper(r.scenario)) continue;
    command_drives(lane, r.cycle.plan(), r.theta_time_s(w), fingers, theta, command);
  }
}

void LaneSimulation::Impl::add_loads() {
  for (int lane = 0; lane < kLanes; ++lane) {
    const LaneRun& r = run_of(lane);
    const ProductParameters& product = r.scenario.product;
    if (!r.busy || !has_loads(product)) continue;
    const std::vector<double> at_t = written_load_N(product, parts.body, r.time_s(w));
    const std::vector<double> at_next = written_load_N(product, parts.body, r.end_time_s(w), JumpSide::left);
    for (std::size_t i = 0; i < at_t.size(); ++i) {
      body.add_force(lane, i, at_t[i] + w.theta * (at_next[i] - at_t[i]));
    }
  }
}

void LaneSimulation::Impl::solve_step() {
  Mask pending = running;
  rounds = Lane(0.0);
  sweeps = Lane(0.0);
  material->begin_step();
  timer.lap(times.plasticity_s);
  for (int round = 0; round < kMaxPlasticRounds; ++round) {
    solve_contacts_and_product(pending);
    pending = material->update(body.u_theta(), pending);
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
    LaneRun& r = run_of(lane);
    r.record.abort(Outcome::diverged, cause, r.time_s(w));
  }
}

void LaneSimulation::Impl::solve_contacts_and_product(const Mask& lanes) {
  const bool first_round = none(rounds > Lane(0.0));
  const ContactModel& touch = parts.contact;
  body.start_solve(material->load_theta());
  if (touch.node_count() > 0) {
    body.solve_without_contact(touch.reach, touch.node, base);
    timer.lap(times.solve_s);
    if (first_round) {
      contact.begin_step({body.u(), body.v(), body.a(), base, now, theta, fingers}, lanes);
    } else {
      contact.rebase(base, lanes);
    }
    if (!contact.idle()) {
      sweeps += contact.solve(fingers, lanes);
      abort_lanes(contact.sweep().unsolved(), "the contact forces did not converge within a step");
    }
    timer.lap(times.contact_s);
    if (!contact.idle()) {
      body.add_contact(touch.reach, touch.node, contact.sweep().active_nodes(), contact.sweep().node_force());
    }
  }
  body.finish_solve(lanes);
  timer.lap(times.solve_s);
}

void LaneSimulation::Impl::advance_state() {
  const std::array<Lane, 3> old_mass_u = body.mass_u();
  body.advance(running);
  fingers.advance(w, contact.sweep().pad_force(), running);
  contact.end_step({body.u_theta(), body.u(), theta, next}, running);
  material->end_step(w, running);
  balances.book_step(view, old_mass_u, now, next, running);
  now = next;
}

void LaneSimulation::Impl::observe_lanes() {
  std::array<Lane, kFingerCount> yield_ratio;
  for (int f = 0; f < kFingerCount; ++f) yield_ratio[f] = contact.yield_ratio(f, yield_stress);
  ++times.steps;
  for (int lane = 0; lane < kLanes; ++lane) {
    if (run_of(lane).busy) observe_lane(lane, yield_ratio);
  }
}

void LaneSimulation::Impl::observe_lane(int lane, const std::array<Lane, kFingerCount>& yield_ratio) {
  LaneRun& r = run_of(lane);
  ++times.lane_steps;
  const double start = r.time_s(w);
  ++r.step;
  const double time = r.time_s(w);
  r.contact_sweeps += sweeps[lane];
  r.plastic_rounds += rounds[lane];
  tell_cycle(lane, start, time);
  StepObservation seen = view.observe(lane, r.scenario, time);
  for (std::size_t f = 0; f < kFingerCount; ++f) seen.finger[f].yield_ratio = yield_ratio[f][lane];
  balances.book_impulse(lane, view);
  bool goes_on = r.record.observe(seen, r.cycle);
  check_validity(lane, time);
  if (r.trace != nullptr) {
    contact.record_events(lane, start, r.trace->events);
    record(lane, seen);
  }
  goes_on = goes_on && !r.record.aborted();
  if (!goes_on || time >= r.cycle.plan().end_s() - 1e-9 * w.dt) finish(lane, time);
}

/// Tells the cycle what the step showed; anchors travel from the start of the lift on.
void LaneSimulation::Impl::tell_cycle(int lane, double start_s, double time_s) {
  std::optional<double> touch_s;
  if (const double touch = contact.first_touch()[lane]; touch <= 1.0) touch_s = start_s + touch * w.theta * w.dt;
  if (run_of(lane).cycle.observe(time_s, touch_s) == CycleEvent::lift_started) contact.forget_travel(lane);
}

/// Ends runs whose numbers are not finite or whose deformation linear strain does not describe.
void LaneSimulation::Impl::check_validity(int lane, double time_s) {
  LaneRun& r = run_of(lane);
  double size = 0.0;
  for (const auto* sums : {&body.mass_u(), &body.mass_a()}) {
    for (const Lane& sum : *sums) size += sum[lane];
  }
  const double strain = material->largest_strain()[lane];
  if (!std::isfinite(size) || !std::isfinite(strain)) {
    r.record.abort(Outcome::diverged, "the motion is not finite", time_s);
  } else if (strain > r.scenario.simulation.max_strain) {
    r.record.abort(Outcome::out_of_range, "a cell's strain > simulation.max_strain", time_s);
  } else if (parts.body.is_solid && body.rotation_rad(lane) > r.scenario.simulation.max_rotation_rad) {
    r.record.abort(Outcome::out_of_range, "the product's rotation > simulation.max_rotation_rad", time_s);
  }
}

void LaneSimulation::Impl::finish(int lane, double time_s) {
  LaneRun& r = run_of(lane);
  Metrics& metrics = r.record.metrics;
  metrics[Metric::step_count] = static_cast<double>(r.step);
  metrics[Metric::contact_iterations] = r.contact_sweeps;
  metrics[Metric::plasticity_iterations] = r.plastic_rounds;
  if (!r.record.aborted()) view.measure_permanent_set(lane, r.scenario.limits, metrics);
  if (!r.record.diverged()) balances.measure(lane, time_s, view, r.scenario, metrics);
  finished.push_back({lane, r.record.finish(r.cycle, time_s)});
  r.busy = false;
  r.trace = nullptr;
  running.set(lane, false);
}

void LaneSimulation::Impl::record(int lane, const StepObservation& seen) {
  LaneRun& r = run_of(lane);
  const double every = r.scenario.simulation.trace_interval_s.value_or(w.dt);
  const auto stride = std::max<std::int64_t>(1, std::llround(every / w.dt));
  if (r.step % stride != 0) return;
  TraceRow row = view.trace_row(lane, r.scenario, r.time_s(w));
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const FingerObservation& finger = seen.finger[f];
    row.yield_ratio[f] = finger.yield_ratio;
    if (r.cycle.lift_started() && finger.closed_contacts > 0)
      row.slip_m[f] = finger.travel_sum_m / finger.closed_contacts;
  }
  row.phase = r.cycle.phase(row.time_s);
  row.patch_pressure_Pa = seen.patch_pressure_Pa;
  row.absorbed_energy_J = seen.absorbed_energy_J;
  append_row(row, body.u(), body.v(), body.a(), *r.trace);
}

LaneSimulation::LaneSimulation(std::shared_ptr<const Model> model)
    : impl_(std::make_unique<Impl>(std::move(model))) {}
LaneSimulation::~LaneSimulation() = default;
void LaneSimulation::load(int lane, const Scenario& scenario) { impl_->load(lane, scenario); }
bool LaneSimulation::busy(int lane) const { return impl_->run_of(lane).busy; }
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
  LaneRun& run = impl.run_of(lane);
  if (!run.busy || run.step != 0) throw std::logic_error("LaneSimulation::record_trace: not right after load");
  start_trace(impl.parts.body.position_m, run.scenario, trace);
  run.trace = &trace;
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
