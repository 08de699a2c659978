#include <algorithm>
#include <array>
#include <variant>

#include "core/scenario/gripper.hpp"
#include "studies/config/schema.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

bool kind_uses(Use use, const StudyKindRow& row) {
  switch (use) {
    case Use::not_window:
      return row.scenarios != ScenarioSource::forces;
    case Use::window:
      return row.scenarios == ScenarioSource::forces;
    case Use::search:
      return row.variable != Blocks::refused;
    case Use::one_objective:
      return row.objectives == Objectives::one;
    case Use::several_objectives:
      return row.objectives == Objectives::several;
    case Use::sampling:
      return row.random != Blocks::refused && row.scenarios != ScenarioSource::design;
    case Use::random:
      return row.random != Blocks::refused;
    case Use::candidates:
      return row.candidate != Blocks::refused;
    case Use::curves:
      return row.scenarios == ScenarioSource::curves;
    case Use::design:
      return row.scenarios == ScenarioSource::design;
    default:
      return true;
  }
}

}  // namespace

std::vector<std::string> kinds_that_use(Use use) {
  return kinds_where([use](const StudyKindRow& row) { return kind_uses(use, row); });
}

bool kind_uses(Use use, StudyKind kind) { return kind_uses(use, row_of(kind)); }

bool scenario_uses(Use use, const Scenario& scenario, const std::vector<std::string>& varied_keys) {
  const auto varied = [&](std::string_view key) {
    return std::find(varied_keys.begin(), varied_keys.end(), key) != varied_keys.end();
  };
  const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
  const bool support = scenario.cell.support || varied("cell.support");
  switch (use) {
    case Use::lattice:
      return lattice != nullptr;
    case Use::network:
      return lattice == nullptr;
    case Use::with_axis:
      return lattice != nullptr &&
             (lattice->shape == Shape::cylinder || lattice->shape == Shape::revolution || varied("product.shape"));
    case Use::revolution:
      return lattice != nullptr && (lattice->shape == Shape::revolution || varied("product.shape"));
    case Use::superellipsoid:
      return lattice != nullptr && (lattice->shape == Shape::superellipsoid || varied("product.shape"));
    case Use::mesh:
      return lattice != nullptr && (lattice->shape == Shape::mesh || varied("product.shape"));
    case Use::gripper:
    case Use::not_window:
      return has_gripper(scenario);
    case Use::not_gripper:
      return !has_gripper(scenario);
    case Use::support:
      return support;
    case Use::lattice_support:
      return support && lattice != nullptr;
    case Use::network_support:
      return support && lattice == nullptr;
    case Use::tracking:
      return has_gripper(scenario) && (scenario.strategy.pick == PickKind::tracking || varied("strategy.pick"));
    case Use::stop:
      return has_gripper(scenario) && !has_robot(scenario) &&
             (scenario.strategy.stop_time_s || varied("strategy.stop_time_s"));
    case Use::sensor:
      return has_sensor(scenario) || varied("sensor.at");
    case Use::range:
      return has_range_sensors(scenario) || (has_gripper(scenario) && varied("gripper.range.maximum_m"));
    case Use::guard:
      return has_gripper(scenario) && (scenario.strategy.guard != GuardKind::none || varied("strategy.guard"));
    case Use::range_guard:
      return has_gripper(scenario) && (scenario.strategy.guard == GuardKind::range || varied("strategy.guard"));
    case Use::force_guard:
      return has_gripper(scenario) && (scenario.strategy.guard == GuardKind::force || varied("strategy.guard"));
    case Use::position_hold: {
      const ParallelJawParameters* jaw = parallel_jaw(scenario);
      return jaw != nullptr && (jaw->hold == HoldMode::position || varied("gripper.hold"));
    }
    case Use::robot:
      return has_robot(scenario);
    case Use::elastic_arm:
      return has_robot(scenario) &&
             (!scenario.robot.stiffness_N_m_rad.empty() || varied("robot.stiffness_N_m_rad"));
    default:
      return true;
  }
}

std::string why_unused(Use use, const Scenario& scenario) {
  constexpr std::array<Use, 8> kGripping = {Use::not_window,  Use::tracking,     Use::stop,
                                            Use::range,       Use::guard,        Use::range_guard,
                                            Use::force_guard, Use::position_hold};
  const bool grips = std::find(kGripping.begin(), kGripping.end(), use) != kGripping.end();
  if (grips && !has_gripper(scenario)) use = Use::gripper;
  if (use == Use::elastic_arm && !has_robot(scenario)) use = Use::robot;
  switch (use) {
    case Use::always:
      return "";
    case Use::lattice:
      return "not used: the product is a network";
    case Use::network:
      return "not used: only products of kind = \"network\" have it";
    case Use::with_axis:
      return "not used: only a cylinder or a solid of revolution has an axis";
    case Use::revolution:
      return "not used: only a solid of revolution (product.shape = \"revolution\") has it";
    case Use::superellipsoid:
      return "not used: only a superellipsoid has exponents";
    case Use::mesh:
      return "not used: only a product with shape = \"mesh\" has it";
    case Use::gripper:
      return "not used: the study has no [gripper]";
    case Use::not_gripper:
      return "not used: the phases of the gripper fix the length of the run";
    case Use::not_window:
      return "not used: a window study searches it, between window.from_N and window.to_N";
    case Use::support:
      return "not used: there is no support (cell.support is false)";
    case Use::lattice_support:
      return "not used: only lattice products on a support have it";
    case Use::network_support:
      return "not used: only networks with cell.support = true have it";
    case Use::stop:
      return has_robot(scenario) ? "not used: an arm stops as hard as its joints can (robot.deceleration_rad_s2)"
                                 : "not used: without strategy.stop_time_s nothing is stopped";
    case Use::sensor:
      return "not used: there is no sensor; sensor.at says where it is";
    case Use::range:
      return "not used: without gripper.range.maximum_m there are no range sensors";
    case Use::guard:
      return "not used: only an approach with a guard (strategy.guard) has it";
    case Use::range_guard:
      return "not used: only a guard by range (strategy.guard = \"range\") has it";
    case Use::force_guard:
      return "not used: only a guard by force (strategy.guard = \"force\") has it";
    case Use::position_hold:
      return "not used: only fingers that a lock holds (gripper.hold = \"position\") have it";
    case Use::robot:
      return "not used: there is no arm; robot.urdf names its file";
    case Use::elastic_arm:
      return "not used: without robot.stiffness_N_m_rad the arm is rigid";
    case Use::tracking:
      return "not used: only a palm that tracks (strategy.pick = \"tracking\") has it";
    default:
      return "not used: only studies of kind = " + listed_quoted(kinds_that_use(use), "or") + " have it";
  }
}

}  // namespace unbruised::studies
