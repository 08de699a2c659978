#include "tests/studies/report/fixture_parts.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "studies/findings/sizing.hpp"
#include "studies/findings/summary.hpp"
#include "studies/findings/window_answer.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies::testing {
namespace {

constexpr double kForceLimit_N = 5.0;

constexpr std::string_view kProduct =
    "\n[product]\nkind = \"lattice\"\nsize_m = [0.05, 0.071, 0.05]\nmass_kg = 0.095\nfriction = 0.6\n"
    "\n[product.source]\nsize_m = \"assumed: a medium fruit\"\nmass_kg = \"Du et al. 2019\"\n";
constexpr std::string_view kLimits =
    "\n[limits]\npermanent_set_m = 1e-4\ncontact_yield_ratio = 1.0\nslip_m = 0.002\n";

/// What the sizing sheet reckons with.
Scenario sized_kiwi() {
  LatticeParameters product;
  product.size_m = {0.05, 0.071, 0.05};
  product.mass_kg = 0.095;
  product.friction = 0.6;
  Scenario scenario;
  scenario.product = product;
  scenario.gripper = ParallelJawParameters{};
  jaw_of(scenario).payload_kg = 0.5;
  jaw_of(scenario).finger_length_m = 0.08;
  jaw_of(scenario).jaw_moment_N_m = 2.0;
  return scenario;
}

}  // namespace

ScenarioResult result_of(const Handling& at) {
  const double need_N = at.mass_kg * (9.80665 + at.lift_acceleration_m_s2) / (2.0 * at.friction);
  const double peak_N = at.grip_force_N + 9.0 * at.approach_speed_m_s;
  const double yield = std::cbrt(peak_N / (kForceLimit_N * at.strength));
  ScenarioResult result;
  Metrics& m = result.metrics;
  m[Metric::friction_margin_min] = at.grip_force_N / need_N - 1.0;
  m[Metric::contact_yield_ratio_max] = yield;
  m[Metric::permanent_set_max_m] = std::max(0.0, yield - 0.93) * 4e-4;
  m[Metric::peak_finger_force_N] = peak_N;
  m[Metric::cycle_time_s] = 0.9 + 0.02 / at.approach_speed_m_s + 1.0 / std::sqrt(at.lift_acceleration_m_s2);
  m[Metric::slip_max_m] = at.grip_force_N < need_N ? 4e-3 : 2e-5;
  m[Metric::energy_balance_error] = -5e-4;
  m[Metric::impulse_balance_error] = 2e-11;
  m[Metric::step_count] = 1095.0;
  result.outcome = Outcome::held;
  if (at.grip_force_N < 0.75 * need_N) {
    result.outcome = Outcome::dropped;
    result.cause = "no finger contact between lift and release";
  } else if (at.grip_force_N < need_N) {
    result.outcome = Outcome::slipped;
    result.cause = "slip_max_m > limits.slip_m";
  } else if (yield > 1.0) {
    result.outcome = Outcome::damaged;
    result.cause = "contact_yield_ratio_max > limits.contact_yield_ratio";
  }
  if (result.outcome != Outcome::held) result.outcome_time_s = 0.42;
  if (result.outcome == Outcome::dropped) m[Metric::cycle_time_s] = kAbsent;
  return result;
}

std::vector<double> from_to(double from, double to, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(count - 1)));
  }
  return values;
}

ReportFixture begin(const std::string& name, const std::string& kind) {
  ReportFixture fixture;
  fixture.name = name;
  fixture.content.meta = {
      .unbruised_version = "0.1.0",
      .config_toml = joined({"[study]\nname = \"", name, "\"\nkind = \"", kind, "\"\n", kProduct, kLimits}),
      .config_sha256 = std::string(64, 'a'),
      .study_name = name,
      .study_kind = kind,
      .created_utc = "2026-11-25T06:30:00Z",
      .instruction_set = "avx2",
      .compiler = "GNU 12.2.0",
      .complete = true};
  fixture.context.replay_command =
      "unbruised run results/" + name + "/config.toml --output results/" + name + " --scenario";
  fixture.context.source = "results/" + name + "/results.h5";
  fixture.context.digest = "0123456789abcdef";
  return fixture;
}

ReportFixture end(ReportFixture fixture) {
  if (fixture.window) {
    const SettingOfRow setting = [gripper = fixture.gripper](std::size_t) { return gripper; };
    add_set_points(*fixture.window, setting);
    const WindowAnswer answer =
        window_answer(*fixture.window, setting, fixture.content.inputs, fixture.content.rows);
    fixture.content.tables.push_back(set_points_table(answer));
    fixture.content.tables.push_back(sizing_table(answer, [](std::size_t) { return sized_kiwi(); }));
    fixture.content.window = fixture.window.get();
  }
  if (fixture.trace) fixture.content.trace = fixture.trace.get();
  StudyTables tables;
  tables.inputs = fixture.content.inputs;
  tables.rows = fixture.content.rows;
  tables.found = fixture.content.tables;
  if (fixture.window) tables.window = *fixture.window;
  fixture.context.summary = summary_lines(tables, fixture.content.meta.study_kind);
  return fixture;
}

void add_row(ReportFixture& fixture, const Handling& at, std::vector<InputValue> inputs) {
  fixture.content.rows.push_back(
      {.id = fixture.content.rows.size(), .result = result_of(at), .inputs = std::move(inputs)});
}

ResultColumn numbers(const std::string& name, const std::string& units, const std::string& long_name,
                     std::vector<double> values) {
  return {.name = name, .units = units, .long_name = long_name, .values = std::move(values)};
}

ResultColumn texts(const std::string& name, std::vector<std::string> values) {
  return {.name = name, .units = "", .long_name = "", .values = std::move(values)};
}

Product draw(Chance& chance) {
  const double friction = 0.45 + 0.3 * chance.uniform();
  const double mass_kg = 0.095 * (1.0 + 0.08 * chance.normal());
  return {.friction = friction, .mass_kg = mass_kg, .yield_stress_Pa = 24000.0 * (1.0 + 0.15 * chance.normal())};
}

void add_product(ReportFixture& fixture, Handling at, const Product& product, std::vector<InputValue> first) {
  at.friction = product.friction;
  at.mass_kg = product.mass_kg;
  at.strength = std::pow(product.yield_stress_Pa / 24000.0, 3.0);
  std::vector<InputValue> inputs = std::move(first);
  inputs.insert(inputs.end(), {product.friction, product.mass_kg, product.yield_stress_Pa});
  add_row(fixture, at, std::move(inputs));
}

ResultTable random_table() {
  return {.name = "random",
          .row = "random_key",
          .columns = {texts("key", {kFriction.key, kMass.key, kYield.key}),
                      texts("distribution", {"uniform(0.45, 0.75)", "normal(mean 0.095, sd 0.0076)",
                                             "normal(mean 24000, sd 3600)"}),
                      numbers("mean", "", "", {0.601, 0.0951, 24020.0}),
                      numbers("standard_deviation", "", "", {0.087, 0.0075, 3580.0})},
          .attributes = {}};
}

}  // namespace unbruised::studies::testing
