#include "core/scenario/gripper.hpp"

#include "core/scenario/finger_axes.hpp"

namespace unbruised {
namespace {

std::optional<double> stroke_of(const NoGripper&) { return std::nullopt; }
std::optional<double> stroke_of(const ParallelJawParameters& jaw) { return jaw.stroke_m; }

std::optional<double> opening_of(const NoGripper&) { return std::nullopt; }
std::optional<double> opening_of(const ParallelJawParameters& jaw) { return jaw.opening_m; }

std::optional<double> gain_of(const NoGripper&) { return std::nullopt; }
std::optional<double> gain_of(const ParallelJawParameters& jaw) { return jaw.drive_gain_N_s_m; }

}  // namespace

std::optional<double> finger_stroke_m(const GripperParameters& gripper) {
  return std::visit([](const auto& kind) { return stroke_of(kind); }, gripper);
}

std::optional<double> opening_m(const GripperParameters& gripper) {
  return std::visit([](const auto& kind) { return opening_of(kind); }, gripper);
}

std::optional<double> drive_gain_N_s_m(const GripperParameters& gripper) {
  return std::visit([](const auto& kind) { return gain_of(kind); }, gripper);
}

bool lists_fingers(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  return jaw != nullptr && !jaw->finger.empty();
}

int finger_count(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  return jaw != nullptr && !jaw->finger.empty() ? static_cast<int>(jaw->finger.size()) : kJawFingers;
}

bool has_range_sensors(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  return jaw != nullptr && jaw->range.maximum_m.has_value();
}

}  // namespace unbruised
