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
  r.cycle = HandlingCycle(scenario, arm_carrier(scenario));
  r.level = LevelChoice(step_levels(scenario));
  set_carriers(lane, r.cycle.plan(), 0.0, r.plane, now);
  set_listed_surfaces(lane, scenario.cell, 0.0, now);
  set_up(lane, r);
  const InitialState state = initial.of(scenario, material->plastic_load_N(lane));
  body.load(lane, state.body, scenario.cell.gravity_m_s2);
  material->settle(lane, body.u());
  if (state.rest != nullptr) contact.set_rest(lane, *state.rest);
  contact.set_anchors(lane, body.u(), now, body.frame());
  load_mount(lane, scenario, parts, state.rest, now, mounts);
  if (mounts.has(lane))
    r.six_axis.emplace(scenario.sensor, sensor_stiffness(scenario.sensor), mount_state(lane, mounts));
  for (Lane& ratio : yield_ratio) ratio.set(lane, 0.0);
  running.set(lane, true);
  if (FingerInstruments instruments(scenario); !instruments.idle()) {
    instruments.start(view.finger_signs(lane, scenario, instruments.has_range()));
    r.instruments = instruments;
  }
  balances.load(lane, view, scenario);
  auto outcome = std::make_unique<OutcomeObserver>(scenario);
  r.outcome = outcome.get();
  watch(lane, std::move(outcome));
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
  LaneArchive out = LaneArchive::out_of(lane, parked->content);
  archive(out);
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
}

void LaneSimulation::Impl::watch(int lane, std::unique_ptr<LaneObserver> observer) {
  LaneRun& r = run_of(lane);
  require(r.busy && r.step == 0, "LaneSimulation::watch: not right after load");
  const StepObservation seen = see(lane, 0.0);
  observer->start({.lane = lane,
                   .scenario = r.scenario,
                   .cycle = r.cycle,
                   .seen = seen,
                   .view = view,
                   .balances = balances,
                   .six_axis = six_axis(r)});
  r.observers.push_back(std::move(observer));
}

}  // namespace unbruised
