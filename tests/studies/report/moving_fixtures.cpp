#include <utility>

#include "studies/execution/arm_run.hpp"
#include "studies/execution/lone_run.hpp"
#include "studies/findings/replay_choice.hpp"
#include "tests/core/robot/arms.hpp"
#include "tests/studies/report/fixture_parts.hpp"

namespace unbruised::studies::testing {
namespace {

/// A coarse kiwi in a jaw with a six-axis sensor at the wrist, carried a short way by an arm: all of it runs in a
/// second.
Scenario carried_kiwi(double grip_force_N) {
  Scenario scenario;
  LatticeParameters product;
  product.shape = Shape::ellipsoid;
  product.size_m = {0.05, 0.071, 0.05};
  product.cell_size_m = 0.01;
  product.mass_kg = 0.095;
  product.youngs_modulus_Pa = 0.288e6;
  product.poisson_ratio = 0.35;
  product.yield_stress_Pa = 0.024e6;
  product.tangent_modulus_Pa = 0.08e6;
  product.relaxation_time_s = 6e-4;
  product.friction = 0.6;
  scenario.product = product;
  scenario.gripper = ParallelJawParameters{};
  scenario.cell.approach_gap_m = 0.003;
  scenario.cell.lift_height_m = 0.04;
  scenario.cell.transfer_m = {0.0, 0.05};
  scenario.strategy.grip_force_N = grip_force_N;
  scenario.strategy.recover_s = 0.1;
  scenario.limits.contact_yield_ratio = 1.0;
  scenario.limits.plastic_strain = 0.01;
  scenario.robot = unbruised::testing::six_joints();
  scenario.robot.base_place_m = {-0.55, 0.1, 0.0};
  return scenario;
}

}  // namespace

std::vector<ReportFixture> moving_fixtures() {
  ReportFixture fixture = begin("in_motion", "sweep");
  fixture.content.inputs = {kGrip};
  std::vector<Scenario> scenarios;
  for (const double force_N : {0.5, 1.5, 9.0}) scenarios.push_back(carried_kiwi(force_N));
  std::vector<ScenarioReplay> seen(scenarios.size());
  std::vector<Recording> kept;
  for (ScenarioReplay& each : seen) {
    each.trace.keeps_motion = false;
    kept.emplace_back(&each.trace, &each.replay, 0.025);
  }
  const auto results = run_side_by_side(core_simulator(), scenarios, kept, nullptr);
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    seen[i].id = i;
    seen[i].result = (*results)[i];
    seen[i].arm_m = arm_links_m(scenarios[i], seen[i].result, seen[i].replay.time_s);
    seen[i].stage = replay_stage(scenarios[i]);
    fixture.content.rows.push_back(
        {.id = i, .result = seen[i].result, .inputs = {scenarios[i].strategy.grip_force_N}, .place = {}});
  }
  for (const ChosenReplay& chosen : chosen_replays(fixture.content.inputs, fixture.content.rows, {})) {
    seen[chosen.id].why = chosen.why;
    fixture.context.replays.push_back(seen[chosen.id]);
  }
  return {std::move(fixture)};
}

}  // namespace unbruised::studies::testing
