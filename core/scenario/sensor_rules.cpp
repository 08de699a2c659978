#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scenario/conveyor.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

/// The rule where there is a sensor.
Rule measured(Rule rule) {
  rule.fields.push_back("sensor.at");
  rule.check = [check = std::move(rule.check)](const Scenario& s, Violations& out) {
    if (has_sensor(s)) check(s, out);
  };
  return rule;
}

void sensor_stands_somewhere(const Scenario& s, Violations& out) {
  if (s.sensor.position_m) return;
  out.push_back({"sensor.position_m", "",
                 s.sensor.at == SensorMount::wrist
                     ? "missing; where the sensor's origin is, from the centre of the pads"
                     : "missing; where the sensor's origin is, from where the support lies under the product"});
}

void wrist_carries_a_gripper(const Scenario& s, Violations& out) {
  if (s.sensor.at != SensorMount::wrist) return;
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr) {
    out.push_back({"sensor.at", "\"wrist\"", "needs a [gripper], which the wrist carries"});
  } else if (jaw->coupling != FingerCoupling::centric) {
    out.push_back({"sensor.at", "\"wrist\"",
                   "needs gripper.coupling = \"centric\": the motion of fingers that are driven alone against the "
                   "wrist is not followed"});
  }
}

void gripper_outweighs_fingers(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (s.sensor.at != SensorMount::wrist || jaw == nullptr || s.sensor.mass_kg > 2.0 * jaw->finger_mass_kg) return;
  out.push_back({"sensor.mass_kg", spelled(s.sensor.mass_kg),
                 "must be > 2 x gripper.finger_mass_kg = " + spelled(2.0 * jaw->finger_mass_kg) +
                     ": the sensor carries the whole gripper"});
}

void plate_stands_still(const Scenario& s, Violations& out) {
  if (s.sensor.at != SensorMount::support) return;
  if (!s.cell.support) {
    out.push_back(
        {"sensor.at", "\"support\"", "needs cell.support = true: the plate on the sensor is the support"});
  }
  const auto& v = s.cell.place_velocity_m_s;
  const bool moves = std::any_of(v.begin(), v.end(), [](double speed) { return speed != 0.0; });
  if (!has_belt(s.cell) && !moves) return;
  out.push_back({"sensor.at", "\"support\"",
                 "does not go with a support that moves (cell.conveyor, cell.place_velocity_m_s)"});
}

constexpr std::string_view kHasNoModel = "missing; sensor.model has no stiffness without it";

/// Keys of one model, given where it is another.
void one_model(const Scenario& s, Violations& out) {
  const SixAxisSensorParameters& sensor = s.sensor;
  const auto goes_with = [&](bool given, SensorModel model, const char* key, const char* word) {
    if (given && sensor.model != model) {
      out.push_back({key, "", "not used: only sensor.model = \"" + std::string(word) + "\" has it"});
    } else if (!given && sensor.model == model) {
      out.push_back({key, "", std::string(kHasNoModel)});
    }
  };
  goes_with(sensor.ring_stiffness_N_m.has_value(), SensorModel::ring, "sensor.ring_stiffness_N_m", "ring");
  goes_with(sensor.stiffness_N_m.has_value(), SensorModel::datasheet, "sensor.stiffness_N_m", "datasheet");
  goes_with(sensor.stiffness_N_m_rad.has_value(), SensorModel::datasheet, "sensor.stiffness_N_m_rad", "datasheet");
  goes_with(sensor.stiffness_matrix.has_value(), SensorModel::matrix, "sensor.stiffness_matrix", "matrix");
}

void stiffness_holds(const Scenario& s, Violations& out) {
  const SixAxisSensorParameters& sensor = s.sensor;
  const bool is_given =
      (sensor.model != SensorModel::ring || sensor.ring_stiffness_N_m) &&
      (sensor.model != SensorModel::matrix || sensor.stiffness_matrix) &&
      (sensor.model != SensorModel::datasheet || (sensor.stiffness_N_m && sensor.stiffness_N_m_rad));
  if (!is_given) return;  // said elsewhere
  const bool is_matrix = sensor.model == SensorModel::matrix;
  const SixBySix K = sensor_stiffness(sensor);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double apart = std::abs(K[6 * i + j] - K[6 * j + i]);
      if (!is_matrix || apart <= 1e-9 * std::sqrt(std::abs(K[7 * i] * K[7 * j]))) continue;
      out.push_back({"sensor.stiffness_matrix", "",
                     "must be symmetric: row " + std::to_string(i + 1) + ", column " + std::to_string(j + 1) +
                         " differs from row " + std::to_string(j + 1) + ", column " + std::to_string(i + 1)});
      return;
    }
  }
  if (is_positive_definite(K)) return;
  out.push_back({is_matrix ? "sensor.stiffness_matrix" : "sensor.ring_stiffness_N_m", "",
                 "must be positive definite: there is a direction in which this sensor holds nothing"});
}

void samples_within_steps(const Scenario& s, Violations& out) {
  const double most_Hz = 1.0 / s.simulation.time_step_s;
  constexpr double kRounding = 1e-9;  // 1 / 1e-3 is not 1000
  if (!s.sensor.rate_Hz || *s.sensor.rate_Hz <= most_Hz * (1.0 + kRounding)) return;
  out.push_back({"sensor.rate_Hz", spelled(*s.sensor.rate_Hz),
                 "must be <= 1 / simulation.time_step_s = " + for_people(most_Hz) +
                     ": what happens faster than the steps is not known"});
}

void noise_of_samples(const Scenario& s, Violations& out) {
  for (const auto& [key, noise] :
       {std::pair{"sensor.noise_N", s.sensor.noise_N}, std::pair{"sensor.noise_N_m", s.sensor.noise_N_m}}) {
    if (!(noise > 0.0) || s.sensor.rate_Hz) continue;
    out.push_back({key, spelled(noise), "needs sensor.rate_Hz: each sample has an error of its own"});
  }
}

}  // namespace

std::vector<Rule> sensor_rules() {
  std::vector<Rule> rules = {
      {{"sensor.position_m"}, "required with a sensor", sensor_stands_somewhere},
      {{"sensor.at", "gripper", "gripper.coupling"},
       "\"wrist\" needs a gripper with centric fingers",
       wrist_carries_a_gripper},
      {{"sensor.mass_kg", "gripper", "gripper.finger_mass_kg"},
       "at the wrist: > 2 x gripper.finger_mass_kg",
       gripper_outweighs_fingers},
      {{"sensor.at", "cell.support", "cell.conveyor.speed_m_s", "cell.conveyor.initial_speed_m_s",
        "cell.place_velocity_m_s"},
       "\"support\" needs a support that stands still",
       plate_stands_still},
      {{"sensor.ring_stiffness_N_m", "sensor.model", "sensor.stiffness_N_m", "sensor.stiffness_N_m_rad",
        "sensor.stiffness_matrix"},
       "of model = \"ring\" only",
       one_model},
      {{"sensor.stiffness_matrix", "sensor.model", "sensor.ring_stiffness_N_m", "sensor.element_count",
        "sensor.element_radius_m", "sensor.element_stiffness_N_m", "sensor.stiffness_N_m",
        "sensor.stiffness_N_m_rad"},
       "symmetric and positive definite",
       stiffness_holds},
      {{"sensor.rate_Hz", "simulation.time_step_s"}, "<= 1 / simulation.time_step_s", samples_within_steps},
      {{"sensor.noise_N", "sensor.noise_N_m", "sensor.rate_Hz"},
       "needs rate_Hz",
       noise_of_samples,
       "needs rate_Hz"},
  };
  for (Rule& rule : rules) rule = measured(std::move(rule));
  return rules;
}

}  // namespace unbruised
