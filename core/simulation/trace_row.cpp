#include "core/simulation/trace_row.hpp"

#include <numeric>
#include <span>
#include <string>
#include <string_view>

#include "core/outcome/damage_limits.hpp"
#include "core/scenario/gripper.hpp"
#include "core/scenario/product_frame.hpp"

namespace unbruised {
namespace {

void declare(Trace& trace, const char* name, const char* units, std::string long_name,
             std::vector<std::string> dimensions, std::vector<int> extents) {
  trace.signals.push_back({name, units, std::move(long_name), std::move(dimensions), std::move(extents), {}});
}

/// "0 approach, 1 grip, ..."
template <std::size_t N>
std::string codes(const std::array<std::string_view, N>& words) {
  std::string text;
  for (std::size_t i = 0; i < N; ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(i) + " " + std::string(words[i]);
  return text;
}

/// In the order of `Dissipated` and of `WorkDone`.
constexpr std::array<std::string_view, 7> kDissipationWords = {
    "product damping", "plastic flow", "layer viscosity", "friction", "layers left", "gripper", "sensor"};
constexpr std::array<std::string_view, 5> kWorkWords = {"gravity", "palm", "moving surfaces", "drives",
                                                        "sensor's load"};

std::array<double, kDissipationWords.size()> by_cause(const Dissipated& lost) {
  return {lost.damping, lost.plastic_flow, lost.layer_viscosity, lost.friction, lost.layers_left,
          lost.gripper, lost.mount};
}

/// What is stored, what is gone, what was put in: stored_energy_J + dissipated_energy_J - sum of work_J keeps its
/// first value.
void declare_energies(Trace& trace, const Scenario& scenario) {
  declare(trace, "kinetic_energy_J", "J", "energy of motion of the product", {}, {});
  declare(trace, "elastic_energy_J", "J", "elastic energy of the product", {}, {});
  declare(trace, "plastic_work_J", "J", "work of the plastic flow of the product's cells or springs", {}, {});
  declare(trace, "hardening_energy_J", "J", "part of the plastic work that hardening stores", {}, {});
  declare(trace, "dissipated_energy_J", "J", "energy lost since the start, whatever the cause", {}, {});
  declare(trace, "dissipated_by_cause_J", "J", "energy lost since the start: " + codes(kDissipationWords),
          {"cause"}, {static_cast<int>(kDissipationWords.size())});
  declare(trace, "work_J", "J", "work done since the start on product and fingers: " + codes(kWorkWords),
          {"source"}, {static_cast<int>(kWorkWords.size())});
  if (has_gripper(scenario)) {
    declare(trace, "finger_energy_J", "J", "energy of motion of the fingers against the palm, and of end stops",
            {}, {});
  }
  if (has_sensor(scenario)) {
    declare(trace, "sensor_energy_J", "J", "energy of motion of what the sensor carries, and of its spring", {},
            {});
  }
}

/// Appends values to the signals in the order of their declaration.
class SignalWriter {
 public:
  explicit SignalWriter(Trace& trace) : trace_(trace) {}
  void put(double value) { trace_.signals[at_++].values.push_back(value); }
  void put(std::span<const double> values) {
    auto& out = trace_.signals[at_++].values;
    out.insert(out.end(), values.begin(), values.end());
  }

 private:
  Trace& trace_;
  std::size_t at_ = 0;
};

void put_energies(const TraceRow& row, SignalWriter& signals) {
  signals.put(row.stored.kinetic);
  signals.put(row.stored.elastic);
  signals.put(row.plastic_work_J);
  signals.put(row.stored.hardening);
  const auto lost = by_cause(row.dissipated);
  signals.put(std::accumulate(lost.begin(), lost.end(), 0.0));
  signals.put(lost);
  signals.put(std::array{row.work.gravity, row.work.palm, row.work.surfaces, row.work.drives, row.work.mount});
  if (row.gripper) signals.put(row.stored.fingers);
  if (row.sensor) signals.put(row.stored.mount);
}

void put_surfaces(const TraceRow& row, SignalWriter& signals) {
  for (const auto* vectors : {&row.surface_force_N, &row.surface_torque_N_m}) {
    std::vector<double> values;
    for (std::size_t s = 0; s < row.surface_count; ++s) {
      values.insert(values.end(), (*vectors)[s].begin(), (*vectors)[s].end());
    }
    signals.put(values);
  }
}

}  // namespace

void start_trace(const std::vector<std::array<double, 3>>& position_m, const Scenario& scenario, Trace& trace) {
  const bool keeps_motion = trace.keeps_motion;
  trace = Trace{};
  trace.keeps_motion = keeps_motion;
  trace.particle_count = static_cast<int>(position_m.size());
  for (const auto& p : position_m) trace.rest_position_m.insert(trace.rest_position_m.end(), p.begin(), p.end());
  declare(trace, "support_force_N", "N", "force of the support on the product", {"component"}, {3});
  const std::string codes_of_surfaces = surface_codes(surfaces_of(scenario));
  const auto surfaces = static_cast<int>(surfaces_of(scenario).size());
  declare(trace, "contact_count", "1", "closed contacts per surface: " + codes_of_surfaces, {"surface"},
          {surfaces});
  declare(trace, "sliding_count", "1", "sliding contacts per surface: " + codes_of_surfaces, {"surface"},
          {surfaces});
  declare(trace, "plastic_strain_max", "1", "largest accumulated equivalent plastic strain", {}, {});
  declare(trace, "absorbed_energy_J", "J", "plastic work done in the product", {}, {});
  declare(trace, "stored_energy_J", "J",
          "kinetic and elastic energy of product, contact layers, fingers and what a sensor carries", {}, {});
  declare(trace, "contact_energy_J", "J", "elastic energy of the contact layers", {}, {});
  declare_energies(trace, scenario);
  declare(trace, "surface_force_N", "N", "force of each surface on the product: " + codes_of_surfaces,
          {"surface", "component"}, {surfaces, 3});
  declare(trace, "surface_torque_N_m", "N m",
          "torque of each surface on the product about its centre of mass: " + codes_of_surfaces,
          {"surface", "component"}, {surfaces, 3});
  if (can_yield(scenario)) {
    declare(trace, "support_yield_ratio", "1",
            "mean pressure of the support's contact patch over the one at first yield above it", {}, {});
  }
  if (product_frame(scenario) == ProductFrame::floating) {
    declare(trace, "attitude", "1", "rotation of the product since the start: a unit quaternion w, x, y, z",
            {"quaternion"}, {4});
    declare(trace, "spin_rad_s", "rad s-1", "angular velocity of the product as a whole", {"component"}, {3});
  }
  if (has_sensor(scenario)) {
    declare(trace, "sensor_wrench", "N, N m",
            "wrench that the six-axis sensor reads: Fx, Fy, Fz in N, Mx, My, Mz in N m, less its tare", {"wrench"},
            {6});
    declare(trace, "sensor_wrench_compensated", "N, N m",
            "the same without weight and inertia of what the sensor carries itself", {"wrench"}, {6});
  }
  if (!has_gripper(scenario)) return;
  const int fingers = finger_count(scenario);
  declare(trace, "finger_force_N", "N", "force of each finger on the product", {"finger", "component"},
          {fingers, 3});
  declare(trace, "finger_way_m", "m", "closing way of each finger since the start", {"finger"}, {fingers});
  declare(trace, "finger_speed_m_s", "m s-1", "closing speed of each finger", {"finger"}, {fingers});
  declare(trace, "palm_position_m", "m", "motion of the palm since the start", {"component"}, {3});
  if (product_frame(scenario) == ProductFrame::floating) {
    declare(trace, "palm_rotation_rad", "rad", "rotation of the palm from upright, about the vector by its length",
            {"component"}, {3});
  }
  declare(trace, "patch_pressure_Pa", "Pa", "largest contact pressure averaged over a square patch of fixed size",
          {}, {});
  declare(trace, "slip_m", "m",
          "way that the product has slipped past each finger's pad since the start of the lift", {"finger"},
          {fingers});
  declare(trace, "slip_rad", "rad",
          "angle that the product has turned against each finger's pad since the start of the lift", {"finger"},
          {fingers});
  declare(trace, "friction_margin", "1",
          "friction coefficient x normal force / tangential force of each finger - 1; while a finger slides as a "
          "whole, how much of the slip limits it has used up, negative",
          {"finger"}, {fingers});
  declare(trace, "phase", "1", "phase of the cycle: " + codes(kCyclePhaseWords), {}, {});
  if (has_range_sensors(scenario)) {
    declare(trace, "range_m", "m", "last reading of each finger's range sensor", {"finger"}, {fingers});
  }
  if (!can_yield(scenario)) return;
  declare(trace, "contact_yield_ratio", "1",
          "mean pressure of each finger's contact patch over the one at first yield below it", {"finger"},
          {fingers});
}

/// Appends values to a row of a trace.
void append(std::span<const double> values, std::vector<double>& to) {
  to.insert(to.end(), values.begin(), values.end());
}

void append_row(const TraceRow& row, const BodyState& state, Trace& trace) {
  trace.time_s.push_back(row.time_s);
  append(state.displacement_m, trace.displacement_m);
  append(state.velocity_m_s, trace.velocity_m_s);
  append(state.acceleration_m_s2, trace.acceleration_m_s2);
  SignalWriter signals(trace);
  signals.put(row.surface_force_N[row.finger_count]);  // of the support, after the pads
  for (const auto* counts : {&row.closed, &row.sliding}) signals.put(std::span(*counts).first(row.surface_count));
  signals.put(row.plastic_strain);
  signals.put(row.absorbed_energy_J);
  signals.put(row.stored.total);
  signals.put(row.stored.layers);
  put_energies(row, signals);
  put_surfaces(row, signals);
  if (row.yields) signals.put(row.support_yield_ratio);
  if (row.attitude) {
    signals.put(*row.attitude);
    signals.put(row.spin_rad_s);
  }
  if (row.sensor) {
    signals.put(row.sensor->reading);
    signals.put(row.sensor->compensated);
  }
  if (!row.gripper) return;
  const auto of_fingers = [&row](const auto& values) { return std::span(values).first(row.finger_count); };
  std::vector<double> forces;
  for (const std::array<double, 3>& force : of_fingers(row.surface_force_N)) append(force, forces);
  signals.put(forces);
  signals.put(of_fingers(row.finger_way_m));
  signals.put(of_fingers(row.finger_speed_m_s));
  signals.put(row.palm_m);
  if (row.attitude) signals.put(row.palm_rotation_rad);
  signals.put(row.patch_pressure_Pa);
  signals.put(of_fingers(row.slip_m));
  signals.put(of_fingers(row.slip_rad));
  signals.put(of_fingers(row.friction_margin));
  signals.put(static_cast<double>(row.phase));
  if (row.ranged) signals.put(of_fingers(row.range_m));
  if (row.yields) signals.put(of_fingers(row.yield_ratio));
}

}  // namespace unbruised
