#include <memory>
#include <utility>

#include "studies/findings/grip_window.hpp"
#include "tests/studies/report/fixture_parts.hpp"

namespace unbruised::studies::testing {
namespace {

GripSample sample_of(const Handling& at) {
  const ScenarioResult result = result_of(at);
  return {.grip_force_N = at.grip_force_N,
          .holds = result.outcome == Outcome::dropped || result.outcome == Outcome::slipped ? Verdict::no
                                                                                            : Verdict::yes,
          .undamaged = result.metrics[Metric::contact_yield_ratio_max] > 1.0 ? Verdict::no : Verdict::yes,
          .peak_finger_force_N = result.metrics[Metric::peak_finger_force_N]};
}

struct Approach {
  double speed_m_s;
  double lift_m_s2;
};

ReportFixture window(const std::string& name, const std::vector<Approach>& approaches, double strength) {
  ReportFixture fixture = begin(name, "window");
  fixture.content.inputs = {kSpeed, kLift, kGrip};
  fixture.window = std::make_shared<WindowTable>();
  fixture.window->inputs = {kSpeed, kLift};
  for (const auto& [speed, lift] : approaches) {
    std::vector<GripSample> samples;
    for (const double force : from_to(0.4, 12.0, 28)) {
      const Handling at{.grip_force_N = force,
                        .approach_speed_m_s = speed,
                        .lift_acceleration_m_s2 = lift,
                        .strength = strength};
      add_row(fixture, at, {speed, lift, force});
      samples.push_back(sample_of(at));
    }
    WindowRow row = read_grip_window(std::move(samples));
    row.inputs = {speed, lift};
    fixture.window->rows.push_back(std::move(row));
  }
  return fixture;
}

/// Two cells and products that no single force suits: one answer has to hold over both.
ReportFixture disjoint() {
  ReportFixture fixture = window("disjoint", {{0.02, 12.0}, {0.4, 0.5}}, 1.0);
  for (std::vector<ColumnInfo>* columns : {&fixture.content.inputs, &fixture.window->inputs}) {
    (*columns)[0] = {"cell.approach_gap_m", "m", ""};
    (*columns)[1] = kMass;
  }
  return fixture;
}

/// A gripper whose least force already marks the product; half the time step moves the upper end a little.
ReportFixture too_strong() {
  ReportFixture fixture = window("not_for_this_gripper", {{0.1, 2.0}}, 1.0);
  fixture.gripper.min_N = 8.0;
  fixture.content.meta.config_toml += "[gripper]\nmin_force_N = 8.0\n";
  WindowRow& row = fixture.window->rows.front();
  row.hold_force_half_step_N = row.hold_bracket_high_N;
  row.damage_force_half_step_N = 0.99 * row.damage_bracket_low_N;
  return fixture;
}

}  // namespace

ReportFixture sweep(const std::string& name, const std::vector<double>& forces, const std::vector<double>& speeds,
                    const std::vector<double>& lifts, double strength) {
  ReportFixture fixture = begin(name, "sweep");
  fixture.content.inputs = {kGrip, kSpeed, kLift};
  fixture.window = std::make_shared<WindowTable>();
  fixture.window->inputs = {kSpeed, kLift};
  const auto at = [&](double force, double speed, double lift) {
    return Handling{
        .grip_force_N = force, .approach_speed_m_s = speed, .lift_acceleration_m_s2 = lift, .strength = strength};
  };
  for (const double force : forces) {
    for (const double speed : speeds) {
      for (const double lift : lifts) add_row(fixture, at(force, speed, lift), {force, speed, lift});
    }
  }
  for (const double speed : speeds) {
    for (const double lift : lifts) {
      std::vector<GripSample> samples;
      for (const double force : forces) samples.push_back(sample_of(at(force, speed, lift)));
      WindowRow row = read_grip_window(std::move(samples));
      row.inputs = {speed, lift};
      fixture.window->rows.push_back(std::move(row));
    }
  }
  return fixture;
}

std::vector<ReportFixture> window_fixtures() {
  const std::vector<double> forces = from_to(0.6, 10.0, 16);
  const std::vector<double> speeds = from_to(0.02, 0.6, 8);
  ReportFixture measured = window("kiwi_window", {{0.02, 2.0}, {0.1, 2.0}, {0.2, 2.0}, {0.3, 2.0}}, 1.0);
  measured.context.measured = {.file = "kiwi_rupture.csv", .rupture_N = {6.51, 1.92, 6.06, 3.63, 12.4}};
  return {sweep("kiwi_sweep", forces, speeds, {1.0, 2.667, 4.333, 6.0}, 1.0), std::move(measured),
          window("no_window", {{0.05, 2.0}}, 0.15), disjoint(), too_strong()};
}

}  // namespace unbruised::studies::testing
