#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "tests/studies/report/fixture_parts.hpp"

namespace unbruised::studies::testing {
namespace {

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

/// Of each strategy's products the part that was held.
std::vector<double> held_shares(const ReportFixture& fixture, std::size_t products) {
  std::vector<double> shares(fixture.content.rows.size() / products, 0.0);
  for (const ScenarioRow& row : fixture.content.rows) {
    if (row.result.outcome == Outcome::held) shares[row.id / products] += 1.0 / static_cast<double>(products);
  }
  return shares;
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
  ResultTable evaluations = evaluations_table(all, {objective}, static_cast<double>(products));
  evaluations.columns.push_back(numbers("probability", "1", "estimated P(held)", held_shares(fixture, products)));
  ResultTable best = best_table(all, objective, static_cast<double>(products));
  best.columns.push_back(numbers("probability", "1", "", {0.975}));
  best.columns.push_back(numbers("probability_low", "1", "", {0.926}));
  best.columns.push_back(numbers("probability_high", "1", "", {0.992}));
  best.attributes.insert(best.attributes.end(),
                         {{"event", std::string("held")}, {"confidence", 0.95}, {"products", 50.0}});
  fixture.content.tables = {
      searches_table(), evaluations, best, constraints_table(), verification_table(1.059, true), random_table()};
  return fixture;
}

}  // namespace

std::vector<ReportFixture> search_fixtures() {
  return {
      search_study("kiwi_optimize", "optimize", 1.0),
      search_study("none_feasible", "optimize", 0.1),
      robust(),
      pareto("kiwi_pareto", {"cycle_time_s", "contact_yield_ratio_max"}, false),
      pareto("three_objectives", {"cycle_time_s", "contact_yield_ratio_max", "mean(peak_finger_force_N)"}, false),
      pareto("empty_front", {"cycle_time_s", "contact_yield_ratio_max"}, true)};
}

}  // namespace unbruised::studies::testing
