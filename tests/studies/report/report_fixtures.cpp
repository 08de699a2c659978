#include "tests/studies/report/report_fixtures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

#include "studies/findings/grip_window.hpp"
#include "studies/findings/summary.hpp"
#include "studies/findings/window_answer.hpp"

namespace unbruised::studies::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kForceLimit_N = 5.0;

/// A small generator with known bits (Knuth's MMIX constants): fixtures never change by themselves.
class Chance {
 public:
  double uniform() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11U) * 0x1p-53;
  }
  double normal() { return std::sqrt(-2.0 * std::log(1.0 - uniform())) * std::cos(2.0 * kPi * uniform()); }

 private:
  std::uint64_t state_ = 20261125;
};

/// What the fixtures' gripper does to the fixtures' product: simple laws of the right shape.
struct Handling {
  double grip_force_N = 2.0;
  double approach_speed_m_s = 0.1;
  double lift_acceleration_m_s2 = 2.0;
  double friction = 0.6;
  double mass_kg = 0.095;
  double strength = 1.0;
};

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

const ColumnInfo kGrip{"strategy.grip_force_N", "N", "drive force limit of each finger"};
const ColumnInfo kSpeed{"strategy.approach_speed_m_s", "m s-1", ""};
const ColumnInfo kLift{"strategy.lift_acceleration_m_s2", "m s-2", ""};
const ColumnInfo kFriction{"product.friction", "1", ""};
const ColumnInfo kMass{"product.mass_kg", "kg", ""};
const ColumnInfo kYield{"product.yield_stress_Pa", "Pa", ""};

std::vector<double> from_to(double from, double to, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(count - 1)));
  }
  return values;
}

/// Name, meta and context; the rest is the kind's.
ReportFixture begin(const std::string& name, const std::string& kind) {
  ReportFixture fixture;
  fixture.name = name;
  fixture.content.meta = {
      .unbruised_version = "0.1.0",
      .config_toml = "[study]\nname = \"" + name + "\"\nkind = \"" + kind +
                     "\"\n\n[limits]\npermanent_set_m = 1e-4\ncontact_yield_ratio = 1.0\nslip_m = "
                     "0.002\n",
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

/// The summary needs the rows.
ReportFixture end(ReportFixture fixture) {
  if (fixture.window) {
    const SettingOfRow setting = [](std::size_t) {
      return ForceSetting{.min_N = 0.5, .max_N = 60.0, .accuracy = 0.05, .step_N = 0.1};
    };
    add_set_points(*fixture.window, setting);
    fixture.content.tables.push_back(
        set_points_table(window_answer(*fixture.window, setting, fixture.content.inputs, fixture.content.rows)));
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

// -- sweep and window. ---------------------------------------------------------------------------------------

GripSample sample_of(const Handling& at) {
  const ScenarioResult result = result_of(at);
  return {.grip_force_N = at.grip_force_N,
          .holds = result.outcome == Outcome::dropped || result.outcome == Outcome::slipped ? Verdict::no
                                                                                            : Verdict::yes,
          .undamaged = result.metrics[Metric::contact_yield_ratio_max] > 1.0 ? Verdict::no : Verdict::yes,
          .peak_finger_force_N = result.metrics[Metric::peak_finger_force_N]};
}

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

// -- searches. -----------------------------------------------------------------------------------------------

ResultColumn numbers(const std::string& name, const std::string& units, const std::string& long_name,
                     std::vector<double> values) {
  return {.name = name, .units = units, .long_name = long_name, .values = std::move(values)};
}

ResultColumn texts(const std::string& name, std::vector<std::string> values) {
  return {.name = name, .units = "", .long_name = "", .values = std::move(values)};
}

struct Evaluation {
  Handling at;
  double objective = 0.0;
  double second = 0.0;
  double violation = 0.0;
  std::string binding;
};

Evaluation evaluate(const Handling& at) {
  const ScenarioResult result = result_of(at);
  const double yield = result.metrics[Metric::contact_yield_ratio_max];
  const double margin = result.metrics[Metric::friction_margin_min];
  const double by_yield = yield - 1.0;
  const double by_margin = (0.2 - margin) / 0.2;
  return {.at = at,
          .objective = result.metrics[Metric::cycle_time_s],
          .second = yield,
          .violation = std::max(by_yield, by_margin),
          .binding = by_yield > by_margin ? "held: contact_yield_ratio_max <= limits.contact_yield_ratio"
                                          : "friction_margin_min >= 0.2"};
}

/// A random walk that narrows: what a search looks like from outside.
std::vector<Evaluation> search(std::size_t count, double strength) {
  Chance chance;
  std::vector<Evaluation> all;
  Handling centre{
      .grip_force_N = 3.0, .approach_speed_m_s = 0.1, .lift_acceleration_m_s2 = 3.0, .strength = strength};
  for (std::size_t i = 0; i < count; ++i) {
    const double width = 0.5 * std::exp(-3.0 * static_cast<double>(i) / static_cast<double>(count));
    Handling at = centre;
    at.grip_force_N = std::clamp(centre.grip_force_N * std::exp(width * chance.normal()), 0.6, 8.0);
    at.approach_speed_m_s = std::clamp(centre.approach_speed_m_s * std::exp(width * chance.normal()), 0.02, 0.4);
    at.lift_acceleration_m_s2 =
        std::clamp(centre.lift_acceleration_m_s2 * std::exp(width * chance.normal()), 0.5, 12.0);
    all.push_back(evaluate(at));
    const Evaluation now = evaluate(centre);
    const Evaluation& next = all.back();
    const bool better = now.violation > 0.0 ? next.violation < now.violation
                                            : next.violation <= 0.0 && next.objective < now.objective;
    if (better) centre = next.at;
  }
  return all;
}

std::size_t best_of(const std::vector<Evaluation>& all) {
  const auto better = [](const Evaluation& a, const Evaluation& b) {
    if ((a.violation <= 0.0) != (b.violation <= 0.0)) return a.violation <= 0.0;
    return a.violation <= 0.0 ? a.objective < b.objective : a.violation < b.violation;
  };
  return static_cast<std::size_t>(std::min_element(all.begin(), all.end(), better) - all.begin());
}

void add_keys(ResultTable& table, const std::vector<Evaluation>& all) {
  std::vector<double> force;
  std::vector<double> speed;
  std::vector<double> lift;
  for (const Evaluation& each : all) {
    force.push_back(each.at.grip_force_N);
    speed.push_back(each.at.approach_speed_m_s);
    lift.push_back(each.at.lift_acceleration_m_s2);
  }
  table.columns.push_back(numbers(kGrip.key, "N", "searched key", force));
  table.columns.push_back(numbers(kSpeed.key, "m s-1", "searched key", speed));
  table.columns.push_back(numbers(kLift.key, "m s-2", "searched key", lift));
}

std::vector<double> each_of(const std::vector<Evaluation>& all,
                            const std::function<double(const Evaluation&)>& value) {
  std::vector<double> values;
  for (const Evaluation& each : all) values.push_back(value(each));
  return values;
}

void add_verdicts(ResultTable& table, const std::vector<Evaluation>& all, const std::vector<double>& scenarios) {
  std::vector<std::string> binding;
  for (const Evaluation& each : all) binding.push_back(each.binding);
  table.columns.push_back(
      numbers("violation", "1", "", each_of(all, [](const Evaluation& e) { return e.violation; })));
  table.columns.push_back(numbers(
      "feasible", "1", "", each_of(all, [](const Evaluation& e) { return e.violation <= 0.0 ? 1.0 : 0.0; })));
  table.columns.push_back(texts("binding", binding));
  table.columns.push_back(numbers("scenario", "1", "", scenarios));
}

std::vector<double> counted(std::size_t count, double step) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(step * static_cast<double>(i));
  return values;
}

ResultTable searches_table() {
  return {
      .name = "searches",
      .row = "search_number",
      .columns = {texts("start", {"grip_force_N = 3, approach_speed_m_s = 0.1", "grip_force_N = 5"}),
                  numbers("evaluations", "1", "", {96.0, 64.0}), numbers("best_objective", "", "", {1.47, 1.471}),
                  numbers("best_violation", "1", "", {-1e-6, -2e-4}),
                  texts("termination", {"the steps are smaller than the tolerance", "the budget is spent"})},
      .attributes = {}};
}

ResultTable evaluations_table(const std::vector<Evaluation>& all, const std::vector<std::string>& objectives,
                              double scenarios_each) {
  ResultTable table{.name = "evaluations", .row = "evaluation", .columns = {}, .attributes = {}};
  table.columns.push_back(numbers("search", "1", "", each_of(all, [](const Evaluation&) { return 0.0; })));
  table.columns.push_back(numbers("generation", "1", "", counted(all.size(), 1.0)));
  add_keys(table, all);
  const auto first = each_of(all, [](const Evaluation& e) { return e.objective; });
  if (objectives.size() == 1) {
    table.columns.push_back(numbers("objective", "", objectives[0], first));
  } else {
    table.columns.push_back(numbers("objective_1", "", objectives[0], first));
    table.columns.push_back(
        numbers("objective_2", "", objectives[1], each_of(all, [](const Evaluation& e) { return e.second; })));
  }
  if (objectives.size() > 2) {
    table.columns.push_back(numbers("objective_3", "", objectives[2],
                                    each_of(all, [](const Evaluation& e) { return e.at.grip_force_N; })));
  }
  add_verdicts(table, all, counted(all.size(), scenarios_each));
  return table;
}

ResultTable best_table(const std::vector<Evaluation>& all, const std::string& objective, double scenarios_each) {
  const std::size_t best = best_of(all);
  const std::vector<Evaluation> one = {all[best]};
  ResultTable table{.name = "best", .row = "best_number", .columns = {}, .attributes = {}};
  add_keys(table, one);
  table.columns.push_back(numbers("objective", "", objective, {one[0].objective}));
  add_verdicts(table, one, {scenarios_each * static_cast<double>(best)});
  table.attributes = {{"objective", objective}, {"at_bounds", std::string()}};
  return table;
}

ResultTable constraints_table() {
  return {.name = "constraints",
          .row = "constraint",
          .columns = {texts("text", {"held: permanent_set_max_m <= limits.permanent_set_m",
                                     "held: contact_yield_ratio_max <= limits.contact_yield_ratio",
                                     "friction_margin_min >= 0.2"}),
                      numbers("slack", "1", "", {0.71, 4e-6, 0.013}), numbers("active", "1", "", {0.0, 1.0, 1.0})},
          .attributes = {}};
}

ResultTable verification_table(double objective, bool robust) {
  ResultTable table{
      .name = "verification",
      .row = "check_number",
      .columns = {texts("check", {"as found", "half the time step", "finer mesh"}),
                  texts("change", {"", "simulation.time_step_s = 0.001", "product.cell_size_m = 0.01"}),
                  numbers("objective", "", "", {objective, objective, objective * 0.999}),
                  numbers("objective_change", "1", "", {0.0, 3e-6, -1e-3}),
                  numbers("violation", "1", "", {-1e-4, -2e-4, -3e-3}),
                  numbers("feasible", "1", "", {1.0, 1.0, 1.0}), texts("binding", {"", "", ""})},
      .attributes = {}};
  if (robust) {
    std::get<std::vector<std::string>>(table.columns[0].values)[2] = "other products";
    table.columns.push_back(numbers("probability", "1", "", {0.975, 0.97, 0.962}));
    table.columns.push_back(numbers("probability_low", "1", "", {0.926, 0.91, 0.938}));
    table.columns.push_back(numbers("probability_high", "1", "", {0.992, 0.99, 0.977}));
  }
  return table;
}

ReportFixture search_study(const std::string& name, const std::string& kind, double strength) {
  ReportFixture fixture = begin(name, kind);
  fixture.content.inputs = {kGrip, kSpeed, kLift};
  const std::vector<Evaluation> all = search(160, strength);
  for (const Evaluation& each : all) {
    add_row(fixture, each.at, {each.at.grip_force_N, each.at.approach_speed_m_s, each.at.lift_acceleration_m_s2});
  }
  fixture.content.tables = {searches_table(), evaluations_table(all, {"cycle_time_s"}, 1.0),
                            best_table(all, "cycle_time_s", 1.0), constraints_table()};
  if (all[best_of(all)].violation <= 0.0) {
    fixture.content.tables.push_back(verification_table(all[best_of(all)].objective, false));
  }
  return fixture;
}

std::vector<Evaluation> front_of(const std::vector<Evaluation>& all) {
  std::vector<Evaluation> front;
  for (const Evaluation& each : all) {
    const bool beaten = std::any_of(all.begin(), all.end(), [&](const Evaluation& other) {
      return other.violation <= 0.0 && other.objective <= each.objective && other.second <= each.second &&
             (other.objective < each.objective || other.second < each.second);
    });
    if (each.violation <= 0.0 && !beaten) front.push_back(each);
  }
  std::sort(front.begin(), front.end(),
            [](const Evaluation& a, const Evaluation& b) { return a.objective < b.objective; });
  return front;
}

ReportFixture pareto(const std::string& name, const std::vector<std::string>& objectives, bool empty) {
  ReportFixture fixture = begin(name, "pareto");
  fixture.content.inputs = {kGrip, kSpeed, kLift};
  Chance chance;
  std::vector<Evaluation> all;
  for (std::size_t i = 0; i < 260; ++i) {
    all.push_back(evaluate({.grip_force_N = 1.0 + 4.0 * chance.uniform(),
                            .approach_speed_m_s = 0.03 + 0.3 * chance.uniform(),
                            .lift_acceleration_m_s2 = 1.0 + 9.0 * chance.uniform(),
                            .strength = empty ? 0.05 : 1.0}));
    const Handling& at = all.back().at;
    add_row(fixture, at, {at.grip_force_N, at.approach_speed_m_s, at.lift_acceleration_m_s2});
  }
  const std::vector<Evaluation> front = front_of(all);
  ResultTable table = evaluations_table(front, objectives, 3.0);
  table.name = "pareto";
  table.row = "point";
  std::vector<double> knee(front.size(), 0.0);
  if (!knee.empty()) knee[knee.size() / 3] = 1.0;
  table.columns.push_back(numbers("knee", "1", "", knee));
  table.attributes = {{"hypervolume", 0.8224}, {"reference_1", 2.6}, {"reference_2", 1.1}};
  fixture.content.tables = {searches_table(), evaluations_table(all, objectives, 1.0), table};
  return fixture;
}

// -- products that vary. -------------------------------------------------------------------------------------

struct Product {
  double friction;
  double mass_kg;
  double yield_stress_Pa;
};

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

ReportFixture sample() {
  ReportFixture fixture = begin("kiwi_sample", "sample");
  fixture.content.inputs = {kFriction, kMass, kYield};
  Chance chance;
  for (int i = 0; i < 200; ++i) add_product(fixture, {.grip_force_N = 1.2}, draw(chance), {});
  fixture.content.tables = {random_table()};
  return fixture;
}

ReportFixture robust() {
  ReportFixture fixture = begin("kiwi_robust", "robust");
  fixture.content.inputs = {kGrip, kSpeed, kLift, kFriction, kMass, kYield};
  const std::vector<Evaluation> all = search(40, 1.0);
  const std::size_t products = 50;
  for (const Evaluation& each : all) {
    Chance chance;
    for (std::size_t i = 0; i < products; ++i) {
      add_product(fixture, each.at, draw(chance),
                  {each.at.grip_force_N, each.at.approach_speed_m_s, each.at.lift_acceleration_m_s2});
    }
  }
  const std::string objective = "mean(cycle_time_s)";
  ResultTable best = best_table(all, objective, static_cast<double>(products));
  best.columns.push_back(numbers("probability", "1", "", {0.975}));
  best.columns.push_back(numbers("probability_low", "1", "", {0.926}));
  best.columns.push_back(numbers("probability_high", "1", "", {0.992}));
  best.attributes.insert(best.attributes.end(),
                         {{"event", std::string("held")}, {"confidence", 0.95}, {"products", 50.0}});
  fixture.content.tables = {searches_table(),
                            evaluations_table(all, {objective}, static_cast<double>(products)),
                            best,
                            constraints_table(),
                            verification_table(1.059, true),
                            random_table()};
  return fixture;
}

ReportFixture compare(const std::string& name, double force_a_N, double force_b_N, bool shown) {
  ReportFixture fixture = begin(name, "compare");
  fixture.content.inputs = {{"candidate", "", ""}, kFriction, kMass, kYield};
  Chance chance;
  std::vector<std::vector<double>> counts(7, std::vector<double>(2, 0.0));
  for (int i = 0; i < 64; ++i) {
    const Product product = draw(chance);
    for (std::size_t k = 0; k < 2; ++k) {
      const Handling at{.grip_force_N = k == 0 ? force_a_N : force_b_N, .approach_speed_m_s = k == 0 ? 0.05 : 0.3};
      add_product(fixture, shown ? at : Handling{.grip_force_N = force_a_N + 0.01 * static_cast<double>(k)},
                  product, {std::string(k == 0 ? "gentle" : "fast")});
      ++counts[static_cast<std::size_t>(fixture.content.rows.back().result.outcome)][k];
    }
  }
  ResultTable candidates{.name = "candidates",
                         .row = "candidate_number",
                         .columns = {texts("name", {"gentle", "fast"})},
                         .attributes = {}};
  for (std::size_t k = 0; k < counts.size(); ++k) {
    candidates.columns.push_back(numbers(std::string(kOutcomeWords[k]), "1", "", counts[k]));
  }
  const double a = counts[0][0] / 64.0;
  const double b = counts[0][1] / 64.0;
  candidates.columns.push_back(numbers("probability", "1", "", {a, b}));
  candidates.columns.push_back(numbers("probability_low", "1", "", {a - 0.06, b - 0.1}));
  candidates.columns.push_back(
      numbers("probability_high", "1", "", {std::min(1.0, a + 0.04), std::min(1.0, b + 0.1)}));
  candidates.columns.push_back(numbers("mean_cycle_time_s", "s", "", {2.784, 1.472}));
  candidates.attributes = {{"confidence", 0.95}};
  ResultTable comparison{
      .name = "comparison",
      .row = "difference",
      .columns =
          {texts("a", {"gentle", "gentle"}), texts("b", {"fast", "fast"}),
           texts("metric", {"cycle_time_s", "friction_margin_min"}), numbers("pairs", "1", "", {41.0, 41.0}),
           numbers("mean_difference", "", "b - a over these products",
                   shown ? std::vector<double>{-1.312, 0.9} : std::vector<double>{0.001, 0.004}),
           numbers("low", "", "", shown ? std::vector<double>{-1.33, 0.7} : std::vector<double>{-0.02, -0.03}),
           numbers("high", "", "", shown ? std::vector<double>{-1.29, 1.1} : std::vector<double>{0.022, 0.038}),
           numbers("wins", "1", "", {0.0, 0.0}), numbers("ties", "1", "", {0.0, 0.0}),
           numbers("losses", "1", "", {41.0, 41.0}), texts("verdict", {"", ""})},
      .attributes = {}};
  comparison.attributes = {
      {"verdict", std::string(shown ? "gentle is held more often (36 % of the products), but fast "
                                      "needs less cycle_time_s"
                                    : "gentle and fast: no difference shown")},
      {"confidence", 0.95}};
  fixture.content.tables = {candidates, comparison, random_table()};
  return fixture;
}

ReportFixture sensitivity(const std::string& name, bool morris) {
  ReportFixture fixture = begin(name, "sensitivity");
  fixture.content.inputs = {kFriction, kMass, kYield};
  Chance chance;
  for (int i = 0; i < 160; ++i) add_product(fixture, {.grip_force_N = 1.4}, draw(chance), {});
  const std::vector<std::string> keys = {kFriction.key, kMass.key, kYield.key,
                                         kFriction.key, kMass.key, kYield.key};
  ResultTable table{.name = "sensitivity", .row = "effect", .columns = {texts("key", keys)}, .attributes = {}};
  table.columns.push_back(
      texts("metric", {"friction_margin_min", "friction_margin_min", "friction_margin_min",
                       "contact_yield_ratio_max", "contact_yield_ratio_max", "contact_yield_ratio_max"}));
  if (morris) {
    table.columns.push_back(numbers("mean", "", "", {0.61, -0.22, 0.0, 0.0, 0.01, -0.3}));
    table.columns.push_back(numbers("mean_absolute", "", "", {0.61, 0.22, 0.001, 0.001, 0.01, 0.3}));
    table.columns.push_back(numbers("mean_absolute_low", "", "", {0.55, 0.19, 0.0, 0.0, 0.0, 0.27}));
    table.columns.push_back(numbers("mean_absolute_high", "", "", {0.67, 0.26, 0.002, 0.002, 0.02, 0.34}));
    table.columns.push_back(numbers("standard_deviation", "", "", {0.11, 0.05, 0.001, 0.001, 0.01, 0.08}));
  } else {
    table.columns.push_back(numbers("first_order", "1", "", {0.81, 0.14, -0.002, 0.0, 0.01, 0.96}));
    table.columns.push_back(numbers("first_order_low", "1", "", {0.66, 0.02, -0.03, -0.02, -0.02, 0.8}));
    table.columns.push_back(numbers("first_order_high", "1", "", {0.93, 0.27, 0.03, 0.02, 0.04, 1.08}));
    table.columns.push_back(numbers("total", "1", "", {0.85, 0.17, 0.001, 0.001, 0.02, 0.97}));
    table.columns.push_back(numbers("total_low", "1", "", {0.71, 0.12, 0.0, 0.0, 0.01, 0.82}));
    table.columns.push_back(numbers("total_high", "1", "", {0.99, 0.22, 0.003, 0.002, 0.03, 1.11}));
  }
  table.attributes = {
      {"method", std::string(morris ? "morris" : "sobol")}, {"left_out", 3.0}, {"confidence", 0.95}};
  fixture.content.tables = {table};
  return fixture;
}

// -- one scenario over time. ---------------------------------------------------------------------------------

ReportFixture simulate(const std::string& name, std::size_t steps) {
  ReportFixture fixture = begin(name, "simulate");
  add_row(fixture, {}, {});
  fixture.trace = std::make_shared<Trace>();
  Trace& trace = *fixture.trace;
  trace.particle_count = 512;
  TraceSignal finger{"finger_force_N",        "N",    "force of each finger on the product",
                     {"finger", "component"}, {2, 3}, {}};
  TraceSignal palm{"palm_position_m", "m", "motion of the palm", {"component"}, {3}, {}};
  TraceSignal strain{"plastic_strain_max", "1", "largest plastic strain", {}, {}, {}};
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = 2.0 * static_cast<double>(i) / static_cast<double>(steps);
    trace.time_s.push_back(t);
    const double grip = 2.0 / (1.0 + std::exp(-40.0 * (t - 0.2))) / (1.0 + std::exp(40.0 * (t - 1.8)));
    for (const double side : {1.0, -1.0}) {
      finger.values.insert(finger.values.end(), {side * grip, 0.02 * std::sin(9.0 * t), 0.47 * grip / 2.0});
    }
    palm.values.insert(palm.values.end(),
                       {0.0, 0.15 * (1.0 - std::cos(kPi * t / 2.0)), 0.1 * std::sin(kPi * t / 2.0)});
    strain.values.push_back(1e-3 * std::max(0.0, t - 0.3));
  }
  trace.signals = {finger, palm, strain};
  trace.events.push_back({.time_s = 0.2, .node = 3, .surface = 0, .kind = ContactEvent::Kind::make});
  return fixture;
}

// -- what may go wrong. --------------------------------------------------------------------------------------

ReportFixture incomplete() {
  ReportFixture fixture = sweep("half_a_night", from_to(0.6, 10.0, 12), from_to(0.02, 0.4, 6), {1.0, 4.0}, 1.0);
  fixture.content.meta.complete = false;
  fixture.context.wanted = fixture.content.rows.size();
  for (std::size_t i = fixture.content.rows.size() / 2; i < fixture.content.rows.size(); ++i) {
    fixture.content.rows[i].result = {};
  }
  fixture.content.rows[3].result.outcome = Outcome::diverged;
  fixture.content.rows[3].result.cause = "a number is not finite";
  fixture.content.rows[5].result.outcome = Outcome::out_of_range;
  fixture.content.rows[5].result.cause = "rotation 0.21 rad > simulation.max_rotation_rad";
  fixture.content.rows[7].result.metrics[Metric::peak_pressure_Pa] = INFINITY;
  fixture.window.reset();
  return fixture;
}

ReportFixture hostile() {
  const std::vector<std::string> evil = hostile_texts();
  ReportFixture fixture = begin("hostile", "sweep");
  fixture.content.meta.study_name = evil[0];
  fixture.content.meta.config_toml += "# " + evil[1] + "\n";
  fixture.content.meta.compiler = evil[2];
  fixture.context.replay_command = "unbruised run '" + evil[1] + "' --scenario";
  fixture.context.source = evil[2];
  fixture.content.inputs = {{"product." + evil[3], evil[4], evil[1]}, {"product.use", "", evil[0]}, kGrip};
  for (std::size_t i = 0; i < 120; ++i) {
    const double force = 0.5 + 0.05 * static_cast<double>(i);
    add_row(fixture, {.grip_force_N = force}, {static_cast<double>(i % 5), evil[i % evil.size()], force});
    fixture.content.rows.back().result.cause = evil[(i + 1) % evil.size()];
  }
  ResultTable table{.name = evil[1],
                    .row = evil[2],
                    .columns = {texts(evil[3], evil), texts("=HYPERLINK(1)", evil)},
                    .attributes = {}};
  table.attributes = {{evil[0], evil[1]}};
  ResultTable candidates{.name = "candidates",
                         .row = "candidate",
                         .columns = {texts("name", {evil[0], evil[1]}), numbers("held", "1", "", {3.0, 4.0}),
                                     numbers("probability", "1", "", {0.3, 0.4})},
                         .attributes = {}};
  fixture.content.tables = {table, candidates};
  return fixture;
}

ReportFixture unknown_table() {
  ReportFixture fixture = sample();
  fixture.name = "unknown_table";
  fixture.content.tables.push_back(
      {.name = "sorting_line",
       .row = "lane",
       .columns = {texts("belt", {"left", "right"}), numbers("speed_m_s", "m s-1", "", {0.4, NAN})},
       .attributes = {{"remark", std::string("from a later version")}}});
  return fixture;
}

}  // namespace

std::vector<std::string> hostile_texts() {
  return {"</script><script>window.hacked=1</script>",
          "<img src=x onerror=\"window.hacked=1\">",
          "\"><svg onload=window.hacked=1>",
          "<!--<script>",
          "]]>&lt;b&gt;' onmouseover='window.hacked=1",
          "line\xE2\x80\xA8separator\xE2\x80\xA9"
          "and ${window.hacked=1} {a|b} %s",
          "bytes \xFF\xFE that are no UTF-8",
          "=HYPERLINK(\"http://127.0.0.1/\",\"x\")",
          "javascript:window.hacked=1"};
}

std::vector<ReportFixture> report_fixtures() {
  const std::vector<double> forces = from_to(0.6, 10.0, 16);
  const std::vector<double> speeds = from_to(0.02, 0.6, 8);
  std::vector<ReportFixture> all;
  all.push_back(sweep("kiwi_sweep", forces, speeds, {1.0, 2.667, 4.333, 6.0}, 1.0));
  all.push_back(window("kiwi_window", {{0.02, 2.0}, {0.1, 2.0}, {0.2, 2.0}, {0.3, 2.0}}, 1.0));
  all.push_back(window("no_window", {{0.05, 2.0}}, 0.15));
  all.push_back(window("disjoint", {{0.02, 12.0}, {0.4, 0.5}}, 1.0));
  all.push_back(search_study("kiwi_optimize", "optimize", 1.0));
  all.push_back(search_study("none_feasible", "optimize", 0.1));
  all.push_back(robust());
  all.push_back(pareto("kiwi_pareto", {"cycle_time_s", "contact_yield_ratio_max"}, false));
  all.push_back(
      pareto("three_objectives", {"cycle_time_s", "contact_yield_ratio_max", "mean(peak_finger_force_N)"}, false));
  all.push_back(pareto("empty_front", {"cycle_time_s", "contact_yield_ratio_max"}, true));
  all.push_back(compare("kiwi_compare", 1.6, 3.4, true));
  all.push_back(compare("no_difference", 1.6, 1.6, false));
  all.push_back(sensitivity("kiwi_sobol", false));
  all.push_back(sensitivity("kiwi_morris", true));
  all.push_back(sample());
  all.push_back(simulate("hold", 2000));
  all.push_back(simulate("long_hold", 60000));
  all.push_back(incomplete());
  all.push_back(hostile());
  all.push_back(unknown_table());
  for (ReportFixture& fixture : all) fixture = end(std::move(fixture));
  return all;
}

ReportFixture large_fixture(std::size_t rows) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(rows)));
  return end(sweep("large", from_to(0.6, 10.0, side), from_to(0.02, 0.6, rows / side), {2.0}, 1.0));
}

}  // namespace unbruised::studies::testing
