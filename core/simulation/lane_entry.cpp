#include "core/robot/arm_carrier.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/product.hpp"
#include "core/simulation/lane_drives.hpp"
#include "core/simulation/lane_mounts.hpp"
#include "core/simulation/lane_simulation_impl.hpp"
#include "core/simulation/step_levels.hpp"

namespace unbruised {

// How scenarios come into their lanes, and from one to another.

void LaneSimulation::Impl::load(int lane, const Scenario& scenario) {
  LaneRun& r = run_of(lane);
  require(!r.busy, "LaneSimulation::load: the lane is busy");
  require(factor_key(scenario) == parts.key,
          "LaneSimulation::load: the scenario has another factor key than the model");
  r = LaneRun{};
  r.busy = true;
  r.scenario = scenario;
  begin(lane, nullptr);
  auto outcome = std::make_unique<OutcomeObserver>(scenario);
  r.outcome = outcome.get();
  watch(lane, std::move(outcome));
}

void LaneSimulation::Impl::begin(int lane, LaneContent* worn) {
  LaneRun& r = run_of(lane);
  const Scenario& scenario = r.scenario;
  r.cycle = HandlingCycle(scenario, arm_carrier(scenario));
  r.level = LevelChoice(step_levels(scenario));
  r.step = r.tick = 0;
  r.plane = SupportPlane::start;
  set_carriers(lane, r.cycle.plan(), 0.0, r.plane, now);
  set_listed_surfaces(lane, scenario.cell, 0.0, now);
  set_up(lane, r);
  const std::vector<double> mounted_N = material->plastic_load_N(lane);
  const InitialState state = initial.of(scenario, mounted_N, wear(lane, worn, mounted_N));
  body.load(lane, state.body, scenario.cell.gravity_m_s2);
  material->settle(lane, body.u());
  if (state.rest != nullptr) contact.set_rest(lane, *state.rest);
  contact.set_anchors(lane, body.u(), now, body.frame());
  load_mount(lane, scenario, parts, state.rest, now, mounts);
  r.six_axis.reset();
  if (mounts.has(lane))
    r.six_axis.emplace(scenario.sensor, sensor_stiffness(scenario.sensor), mount_state(lane, mounts));
  for (Lane& ratio : yield_ratio) ratio.set(lane, 0.0);
  running.set(lane, true);
  r.instruments.reset();
  if (FingerInstruments instruments(scenario); !instruments.idle()) {
    instruments.start(view.finger_signs(lane, scenario, instruments.has_range()));
    r.instruments = instruments;
  }
  balances.load(lane, view, scenario);
}

/// Gives the material what it was in former handlings. @return the load of what flowed in them, [3n]; empty:
/// nothing
std::vector<double> LaneSimulation::Impl::wear(int lane, LaneContent* worn, const std::vector<double>& mounted_N) {
  if (worn == nullptr) return {};
  LaneArchive into = LaneArchive::into(lane, *worn);
  material->archive(into);
  material->open_accounts(lane);
  std::vector<double> load_N = material->plastic_load_N(lane);
  bool flowed = false;
  for (std::size_t i = 0; i < load_N.size(); ++i) {
    load_N[i] -= mounted_N[i];
    flowed = flowed || load_N[i] != 0.0;
  }
  if (!flowed) load_N.clear();
  return load_N;
}

/// Only here is known how a product rests, where steps are shortest; a batch of others sends it on to them.
void LaneSimulation::Impl::begin_next_handling(int lane) {
  LaneRun& r = run_of(lane);
  if (clock.ticks != 1) return;
  r.again_due = false;
  LaneContent worn;
  LaneArchive out = LaneArchive::out_of(lane, worn);
  material->archive(out);
  const bool notes_events = contact.notes_events(lane);
  begin(lane, &worn);
  if (notes_events) contact.note_events(lane);
  const StepObservation seen = see(lane, 0.0);
  for (const auto& observer : r.observers) observer->next_handling(present(lane, seen));
}

/// Puts there what the scenario alone decides.
void LaneSimulation::Impl::set_up(int lane, const LaneRun& r) {
  const Scenario& scenario = r.scenario;
  // The approach begins in steady motion, but for a grip that is ramped up from rest.
  gripper.load(lane, scenario, scenario.strategy.ramp_from_start ? 0.0 : scenario.strategy.approach_speed_m_s,
               r.cycle.plan().force_limit_N(0.0));
  if (pads) pads->load(lane, scenario.cell.gravity_m_s2, opened_half_m(scenario));
  contact.load(lane, scenario);
  material->load(lane, scenario);
  yield_stress.set(lane, yield_stress_Pa(scenario.product).value_or(1.0));
}

void LaneSimulation::Impl::archive(LaneArchive& lane) {
  body.archive(lane);
  material->archive(lane);
  contact.archive(lane);
  gripper.archive(lane);
  mounts.archive(lane);
  if (pads) pads->archive(lane);
  balances.archive(lane);
  now.archive(lane);
}

std::unique_ptr<ParkedScenario> LaneSimulation::Impl::take(int lane) {
  LaneRun& r = run_of(lane);
  require(r.busy, "LaneSimulation::take: the lane is free");
  auto parked = std::make_unique<ParkedScenario>();
  parked->content.number.reserve(numbers_of_lane);
  LaneArchive out = LaneArchive::out_of(lane, parked->content);
  archive(out);
  numbers_of_lane = parked->content.number.size();
  parked->ticks = clock.ticks;
  parked->run = std::move(r);
  r = LaneRun{};
  running.set(lane, false);
  return parked;
}

void LaneSimulation::Impl::put(int lane, ParkedScenario& parked) {
  LaneRun& r = run_of(lane);
  require(!r.busy, "LaneSimulation::put: the lane is busy");
  require(factor_key(parked.run.scenario) == parts.key, "LaneSimulation::put: a scenario of another model");
  r = std::move(parked.run);
  set_up(lane, r);
  load_mount(lane, r.scenario, parts, nullptr, now, mounts);
  LaneArchive into = LaneArchive::into(lane, parked.content);
  archive(into);
  if (parked.ticks != clock.ticks) contact.forget_trend(lane);
  for (Lane& ratio : yield_ratio) ratio.set(lane, 0.0);
  running.set(lane, true);
  if (r.again_due) begin_next_handling(lane);
}

void LaneSimulation::Impl::watch(int lane, std::unique_ptr<LaneObserver> observer) {
  LaneRun& r = run_of(lane);
  require(r.busy && r.step == 0 && r.ticks_before == 0, "LaneSimulation::watch: not right after load");
  const StepObservation seen = see(lane, 0.0);
  observer->start(present(lane, seen));
  r.observers.push_back(std::move(observer));
}

LaneStep LaneSimulation::Impl::present(int lane, const StepObservation& seen) {
  const LaneRun& r = run_of(lane);
  return {.lane = lane,
          .count = r.step,
          .tick = r.tick,
          .before_s = r.before_s,
          .ticks_before = r.ticks_before,
          .scenario = r.scenario,
          .cycle = r.cycle,
          .seen = seen,
          .view = view,
          .balances = balances,
          .six_axis = six_axis(r)};
}

}  // namespace unbruised
