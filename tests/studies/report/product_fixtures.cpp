#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/studies/report/fixture_parts.hpp"

namespace unbruised::studies::testing {
namespace {

ReportFixture compare(const std::string& name, double force_a_N, double force_b_N, bool shown) {
  ReportFixture fixture = begin(name, "compare");
  fixture.content.meta.config_toml +=
      "\n[[candidate]]\nname = \"gentle\"\napproach_speed_m_s = 0.05\nhold_s = 0.5\n"
      "\n[[candidate]]\nname = \"fast\"\napproach_speed_m_s = 0.3\nhold_s = 0.5\n";
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

/// Of two metrics one never changes; in the samples the other is missing from some run.
ReportFixture without_effects() {
  ReportFixture fixture = sensitivity("no_effects", true);
  ResultTable& table = fixture.content.tables.front();
  const std::string constant = "does not vary, whatever the keys are";
  const std::string missing =
      "has no effects that could be told: each of the 40 samples has a run in which it does not exist";
  for (std::size_t c = 2; c < table.columns.size(); ++c) {
    table.columns[c] = numbers(table.columns[c].name, "", "", {0.0, 0.0, 0.0, kAbsent, kAbsent, kAbsent});
  }
  table.columns.push_back(texts("note", {constant, constant, constant, missing, missing, missing}));
  return fixture;
}

/// Three specimens of five points, whose rupture is predicted but for one.
ReportFixture calibrated() {
  ReportFixture fixture = begin("kiwi_calibrate", "calibrate");
  const std::string modulus = "product.youngs_modulus_Pa";
  fixture.content.inputs = {{modulus, "Pa", "fitted key"}};
  const std::vector<double> moduli_Pa = {2.4e5, 3.1e5, 4.2e5};
  const std::vector<std::string> names = {"first", "second", "third"};
  for (const double modulus_Pa : moduli_Pa) add_row(fixture, {.grip_force_N = 5e-5 * modulus_Pa}, {modulus_Pa});
  ResultTable fits{
      .name = "calibration", .row = "specimen_number", .columns = {texts("specimen", names)}, .attributes = {}};
  fits.columns.push_back(numbers(modulus, "Pa", "fitted value", moduli_Pa));
  fits.columns.push_back(numbers(modulus + "_low", "Pa", "", {2.2e5, 3.0e5, 3.9e5}));
  fits.columns.push_back(numbers(modulus + "_high", "Pa", "", {2.7e5, 3.3e5, 4.6e5}));
  fits.columns.push_back(numbers("rms_residual", "N", "", {0.01, 0.02, 0.03}));
  fits.columns.push_back(numbers("outcome", "N", "rupture_force_N, measured", {3.0, 4.1, 5.5}));
  fits.columns.push_back(numbers("predicted", "N", "", {3.2, 3.9, kAbsent}));
  fits.columns.push_back(numbers("predicted_low", "N", "", {2.0, 2.8, kAbsent}));
  fits.columns.push_back(numbers("predicted_high", "N", "", {5.1, 5.4, kAbsent}));
  fits.columns.push_back(texts("note", {"", "youngs_modulus_Pa is at the end of its range", ""}));
  fits.attributes = {{"measured", std::string("force_N")},
                     {"over", std::string("closure_m")},
                     {"confidence", 0.95},
                     {"told", 3.0},
                     {"outcome", std::string("rupture_force_N")},
                     {"predicted", 2.0},
                     {"predicted_covered", 2.0},
                     {"mean_error_relative", 0.058}};
  std::vector<std::string> of_point;
  std::vector<double> closure_m, measured_N, simulated_N;
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (int point = 1; point <= 5; ++point) {
      of_point.push_back(names[i]);
      closure_m.push_back(2e-4 * point);
      simulated_N.push_back(moduli_Pa[i] * 1e-6 * std::pow(point, 1.5));
      measured_N.push_back(simulated_N.back() + (point % 2 == 0 ? 0.02 : -0.02));
    }
  }
  ResultTable curve{.name = "calibration_curve",
                    .row = "curve_point",
                    .columns = {texts("specimen", of_point)},
                    .attributes = {}};
  curve.columns.push_back(numbers("closure_m", "m", "", closure_m));
  curve.columns.push_back(numbers("measured", "N", "", measured_N));
  curve.columns.push_back(numbers("simulated", "N", "", simulated_N));
  ResultTable population{.name = "population",
                         .row = "fitted_key",
                         .columns = {texts("key", {modulus})},
                         .attributes = {{"specimens", 3.0}}};
  population.columns.push_back(numbers("mean", "", "", {3.2e5}));
  population.columns.push_back(numbers("standard_deviation", "", "", {0.8e5}));
  fixture.content.tables = {fits, curve, population};
  return fixture;
}

}  // namespace

ReportFixture sample() {
  ReportFixture fixture = begin("kiwi_sample", "sample");
  fixture.content.inputs = {kFriction, kMass, kYield};
  Chance chance;
  for (int i = 0; i < 200; ++i) add_product(fixture, {.grip_force_N = 1.2}, draw(chance), {});
  fixture.content.tables = {random_table()};
  return fixture;
}

std::vector<ReportFixture> product_fixtures() {
  return {compare("kiwi_compare", 1.6, 3.4, true),
          compare("no_difference", 1.6, 1.6, false),
          sensitivity("kiwi_sobol", false),
          sensitivity("kiwi_morris", true),
          without_effects(),
          calibrated(),
          sample()};
}

}  // namespace unbruised::studies::testing
