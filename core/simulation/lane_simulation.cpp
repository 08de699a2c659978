#include <algorithm>
#include <cmath>

#include "core/body/body_lanes.hpp"
#include "core/body/modal_lanes.hpp"
#include "core/lanes/flush_subnormals.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/vectors.hpp"
#include "core/simulation/curve_recorder.hpp"
#include "core/simulation/lane_drives.hpp"
#include "core/simulation/lane_mounts.hpp"
#include "core/simulation/lane_simulation_impl.hpp"
#include "core/simulation/replay_recorder.hpp"
#include "core/simulation/step_levels.hpp"
#include "core/simulation/trace_recorder.hpp"

namespace unbruised {
namespace {

/// Plastic flow is solved again at most this often within a step; deep flow needs some ten.
constexpr int kMaxPlasticRounds = 60;

std::unique_ptr<BodyMotion> make_motion(const Model::Parts& parts) {
  if (parts.modes) return std::make_unique<ModalLanes>(parts.body, *parts.modes, *parts.wilson);
  return std::make_unique<BodyLanes>(parts.body, *parts.wilson, parts.frame, parts.contact.touchable());
}

std::unique_ptr<Material> make_material(const Model::Parts& parts, const BodyMotion& motion) {
  if (!parts.modes) return unbruised::make_material(parts.body, *parts.wilson, parts.frame);
  const auto& modal = static_cast<const ModalLanes&>(motion);
  return make_elastic_material(parts.body.particle_count,
                               MeasuredElsewhere{modal.largest_strain(), modal.largest_cell_rotation()});
}

}  // namespace

int lane_count() { return kLanes; }

LaneSimulation::Impl::Impl(std::shared_ptr<const Model> shared)
    : model(std::move(shared)),
      parts(model->parts()),
      w(*parts.wilson),
      clock(parts.clock),
      initial(parts),
      own_body(make_motion(parts)),
      body(*own_body),
      material(make_material(parts, body)),
      contact(parts.contact, parts.body, w, parts.frame),
      view{parts, body, *material, contact, gripper, mounts, now, yield_ratio, pads},
      base(3 * parts.contact.node_count()) {
  yield_ratio.fill(Lane(0.0));
  if (parts.pad) pads.emplace(*parts.pad, w);
  const auto listed = static_cast<std::size_t>(std::ranges::count_if(parts.contact.surface, is_of_cell_list));
  for (CarrierMotion* motion : {&now, &theta, &next}) motion->listed.resize(listed);
}

void LaneSimulation::Impl::step() {
  finished.clear();
  if (none(running)) return;
  contact.forget_events();
  timer = PartTimer(timing);
  follow_plans();
  if (pads) {
    const bool turns = parts.frame == ProductFrame::floating;
    pads->begin_step(gripper, pad_accelerations(theta, body.gravity(), *pads, gripper, turns), running);
  }
  gripper.begin_step(w, command, pads ? &pads->on_fingers() : nullptr);
  if (mounts.any()) mounts.begin_step(w);
  material->begin_step(body.u());
  body.begin_step(running, material->remembered());
  material->book_power(body.rate(), body.stiffness_rate(), running);
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
    const SupportPlane plane = choose_support(lane);
    set_carriers(lane, r.cycle.plan(), r.theta_time_s(clock), plane, theta);
    set_carriers(lane, r.cycle.plan(), r.end_time_s(clock), plane, next);
    set_listed_surfaces(lane, r.scenario.cell, r.theta_time_s(clock), theta);
    set_listed_surfaces(lane, r.scenario.cell, r.end_time_s(clock), next);
    command_mount(lane, r.scenario, theta, next, mounts);
    if (!has_gripper(r.scenario)) continue;
    command_drives(lane, r, clock, gripper, theta, command);
  }
}

/// The plane under a lifted product is another one from the end of the lift on, once the product hangs clear of
/// the first and above the second: neither of them rises or sinks, and none appears within a product. Without a
/// lift the first one ends there. @return the plane in the coming step
SupportPlane LaneSimulation::Impl::choose_support(int lane) {
  LaneRun& r = run_of(lane);
  const MotionPlan& plan = r.cycle.plan();
  const SupportPlane planned = plan.support_plane(r.end_time_s(clock));
  if (planned == r.plane) return planned;
  const bool is_lifted = r.scenario.cell.lift_height_m > 0.0;
  const bool stands = contact.tally()[kSupport].closed[lane] > 0.0;
  const double height_m = plan.support(planned, r.time_s(clock)).position_m[2];
  const bool has_target = r.scenario.cell.target_plane;
  const bool below = has_target && contact.lowest_place_m(kSupport, body.u())[lane] < height_m;
  if (is_lifted && (stands || below)) return r.plane;
  contact.leave(kSupport, lane);
  if (!has_target) contact.take_support_away(lane);
  balances.leave_support(lane);
  r.plane = planned;
  set_support(lane, plan, r.time_s(clock), planned, now);
  return planned;
}

void LaneSimulation::Impl::add_loads() {
  for (int lane = 0; lane < kLanes; ++lane) {
    const LaneRun& r = run_of(lane);
    const ProductParameters& product = r.scenario.product;
    if (!r.busy || !has_loads(product)) continue;
    const std::vector<double> at_t = written_load_N(product, parts.body, r.time_s(clock));
    const std::vector<double> at_next = written_load_N(product, parts.body, r.end_time_s(clock), JumpSide::left);
    std::vector<double> at_theta(at_t.size());
    for (std::size_t i = 0; i < at_t.size(); ++i) at_theta[i] = at_t[i] + w.theta * (at_next[i] - at_t[i]);
    body.add_forces(lane, at_theta);
  }
}

void LaneSimulation::Impl::solve_step() {
  Mask pending = running;
  rounds = Lane(0.0);
  sweeps = Lane(0.0);
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
    r.outcome->abort(cause, r.time_s(clock));
  }
}

void LaneSimulation::Impl::solve_contacts_and_product(const Mask& lanes) {
  const bool first_round = none(rounds > Lane(0.0));
  const ContactModel& touch = parts.contact;
  LaneVector moment;
  body.start_solve(material->load_theta(), touch.place.empty() ? nullptr : &moment);
  if (touch.node_count() > 0) {
    const HeldForces held = body.solve_under_held(touch.touchable(), base);
    timer.lap(times.solve_s);
    if (first_round) {
      contact.begin_step({body.u(),
                          body.v(),
                          body.a(),
                          {base, moment, held},
                          now,
                          theta,
                          gripper,
                          body.frame(),
                          mount(),
                          padded()},
                         lanes);
    } else {
      contact.rebase({base, moment, held}, lanes);
    }
    if (!contact.idle()) {
      sweeps += contact.solve(gripper, lanes);
      abort_lanes(contact.sweep().unsolved(),
                  "the contact forces did not converge within a step; use a smaller simulation.time_step_s");
    }
    timer.lap(times.contact_s);
    std::span<const int> active;
    if (!contact.idle()) active = contact.sweep().active_nodes();
    body.add_contact(touch.node, active, contact.sweep().node_force());
  }
  body.finish_solve(lanes, contact.turn_by_arms());
  timer.lap(times.solve_s);
}

void LaneSimulation::Impl::advance_state() {
  const std::array<Lane, 3> old_mass_u = body.mass_u();
  if (body.frame() != nullptr) {
    contact.see_theta(*body.frame(), body.u_theta());
    OuterForces outer =
        body.outer_forces(parts.contact.node, contact.sweep().active_nodes(), contact.sweep().node_force());
    contact.add_arms(outer);
    body.advance(running, outer);
  } else {
    body.advance(running);
  }
  for (int pad = 0; pads && pad < kJawFingers; ++pad) {
    const Lane way_theta = gripper.way_at_theta(pad, contact.sweep().pad_force());
    pads->advance(pad, contact.pad_face_force(pad), way_theta, running);
  }
  gripper.advance(w, contact.sweep().pad_force(), running);
  if (pads) pads->book_step(gripper, running);
  if (mounts.any()) mounts.advance(w, contact.mount_wrench(), running);
  contact.end_step({body.u_theta(), body.u(), theta, next, mount(), padded()}, body.frame(), running);
  material->end_step(body.u(), w, running);
  balances.book_step(view, old_mass_u, now, next, running);
  now = next;
}

void LaneSimulation::Impl::observe_lanes() {
  for (const int s : parts.contact.surface) yield_ratio[s] = contact.yield_ratio(s, yield_stress);
  ++times.steps;
  for (int lane = 0; lane < kLanes; ++lane) {
    if (run_of(lane).busy) observe_lane(lane);
  }
}

void LaneSimulation::Impl::observe_lane(int lane) {
  LaneRun& r = run_of(lane);
  ++times.lane_steps;
  const double start = r.time_s(clock);
  ++r.step;
  r.tick += clock.ticks;
  const double time = r.time_s(clock);
  read_instruments(lane, start, time);
  tell_cycle(lane, start, time);
  const StepObservation seen = see(lane, time);
  balances.book_impulse(lane, view);
  LaneStep step = present(lane, seen);
  step.start_s = start;
  step.time_s = time;
  step.contact_sweeps = sweeps[lane];
  step.plastic_rounds = rounds[lane];
  bool goes_on = time < r.cycle.plan().end_s() - 1e-9 * clock.tick_s;
  for (const auto& observer : r.observers) goes_on = observer->observe(step) && goes_on;
  if (!goes_on) return finish(step);
  if (r.level.chooses()) choose_level(step);
}

void LaneSimulation::Impl::choose_level(const LaneStep& step) {
  LaneRun& r = run_of(step.lane);
  LevelSigns signs{
      .time_s = step.time_s, .cycle = r.cycle, .seen = step.seen, .contact_sweeps = step.contact_sweeps};
  if (r.cycle.has_contact()) {
    signs.support_gap_m = contact.least_gap_m(kSupport, step.lane);
  } else {
    signs.pad_gap_m =
        std::min(contact.least_gap_m(kLeftPad, step.lane), contact.least_gap_m(kRightPad, step.lane));
  }
  for (int f = 0; f < kJawFingers; ++f) {
    signs.closing_m_s = std::max(signs.closing_m_s, std::abs(gripper.speed(f)[step.lane]));
  }
  signs.weight_N = parts.body.total_mass_kg * length(r.scenario.cell.gravity_m_s2);
  signs.friction = product_friction(r.scenario.product);
  signs.gravity_m_s2 = r.scenario.cell.gravity_m_s2;
  r.level.decide(clock, signs);
}

/// Tells the cycle what the step showed; slip counts from the start of the lift on.
void LaneSimulation::Impl::tell_cycle(int lane, double start_s, double time_s) {
  std::optional<double> touch_s;
  if (const double touch = contact.first_touch()[lane]; touch <= 1.0) touch_s = start_s + touch * w.theta * w.dt;
  LaneRun& r = run_of(lane);
  const std::optional<double> guard_s = r.instruments ? r.instruments->guard_s() : std::nullopt;
  if (r.cycle.observe(time_s, touch_s, guard_s) == CycleEvent::lift_started) contact.forget_slip(lane);
}

void LaneSimulation::Impl::read_instruments(int lane, double start_s, double time_s) {
  LaneRun& r = run_of(lane);
  if (r.six_axis) r.six_axis->observe(start_s, time_s, mount_state(lane, mounts));
  if (!r.instruments) return;
  r.instruments->observe(start_s, time_s, view.finger_signs(lane, r.scenario, r.instruments->has_range()));
}

/// What the observers are shown.
StepObservation LaneSimulation::Impl::see(int lane, double time_s) {
  const LaneRun& r = run_of(lane);
  StepObservation seen = view.observe(lane, r.scenario, time_s);
  if (!r.instruments) return seen;
  for (std::size_t f = 0; f < kMostFingers; ++f) seen.finger[f].range_m = r.instruments->range_m()[f];
  return seen;
}

void LaneSimulation::Impl::finish(const LaneStep& last) {
  LaneRun& r = run_of(last.lane);
  if (r.outcome->end_handling(last)) {
    r.before_s += last.time_s;
    r.ticks_before += last.tick;
    r.again_due = true;
    r.level = LevelChoice(step_levels(r.scenario));
    return begin_next_handling(last.lane);
  }
  for (const auto& observer : r.observers) observer->end(last);
  finished.push_back({last.lane, r.outcome->result()});
  r.observers.clear();
  r.outcome = nullptr;
  r.busy = false;
  running.set(last.lane, false);
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
void LaneSimulation::step() {
  const FlushSubnormals flush;
  impl_->step();
}
int LaneSimulation::ticks() const { return impl_->clock.ticks; }
int LaneSimulation::next_ticks(int lane) const { return impl_->run_of(lane).level.ticks(); }
double LaneSimulation::time_left_s(int lane) const {
  const LaneRun& r = impl_->run_of(lane);
  return r.cycle.plan().end_s() - r.time_s(impl_->clock);
}
std::unique_ptr<ParkedScenario> LaneSimulation::take(int lane) { return impl_->take(lane); }
void LaneSimulation::put(int lane, ParkedScenario& parked) { impl_->put(lane, parked); }
const std::vector<LaneSimulation::Finished>& LaneSimulation::finished() const { return impl_->finished; }
void LaneSimulation::enable_timing() { impl_->timing = true; }
const LaneSimulation::PartTimes& LaneSimulation::part_times() const { return impl_->times; }

void LaneSimulation::watch(int lane, std::unique_ptr<LaneObserver> observer) {
  impl_->watch(lane, std::move(observer));
}
void LaneSimulation::record(int lane, const Recording& kept) {
  if (kept.trace != nullptr) {
    impl_->contact.note_events(lane);
    watch(lane, std::make_unique<TraceRecorder>(*kept.trace));
  }
  if (kept.curve != nullptr) watch(lane, std::make_unique<CurveRecorder>(*kept.curve));
  if (kept.replay != nullptr) {
    watch(lane, std::make_unique<ReplayRecorder>(*kept.replay, kept.replay_interval_s));
  }
}

}  // namespace unbruised
