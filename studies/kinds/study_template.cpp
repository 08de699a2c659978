#include "studies/kinds/study_template.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <variant>
#include <vector>

#include "core/scenario/lattice_cells.hpp"
#include "studies/config/document.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

constexpr double kLiftAcceleration_m_s2 = 2.0;
constexpr std::size_t kCommentColumn = 38;

/// The nearest number with two significant digits.
double round_two(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", value);
  return std::strtod(text.data(), nullptr);
}

/// A TOML number that reads as it was meant: "2.0", "0.25", "3e+05".
std::string toml(double value) {
  std::string text = short_number(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// `KEY = VALUE      # comment`
std::string line(std::string_view assignment, std::string_view comment) {
  const std::size_t gap = assignment.size() + 1 < kCommentColumn ? kCommentColumn - assignment.size() : 2;
  return joined({assignment, std::string(gap, ' '), "# ", comment, "\n"});
}

std::string line(std::string_view key, double value, std::string_view comment) {
  return line(joined({key, " = ", toml(value)}), comment);
}

std::string texts(std::string_view key, std::string_view text, std::string_view comment) {
  return line(joined({key, " = ", toml_string(text)}), comment);
}

std::string head(const TemplateRequest& request) {
  return joined(
      {"# Written by `unbruised new`; change what you like. `unbruised explain KEY` says more of any key.\n",
       "[study]\n", texts("name", request.name, joined({"results go to results/", request.name, "/"})),
       texts("kind", study_kind_word(request.kind), row_of(request.kind).asks),
       line("seed = 1", "of everything that is drawn at random"), "\n[product]\n",
       texts("use", request.product, "shape, mass, stiffness, friction and limits of the product"),
       "\n[gripper]\n", texts("use", request.gripper, "pads, fingers, drive"), "\n[cell]\n",
       line("lift_height_m", 0.1, "how high it is lifted, m"),
       line("transfer_m = [0.0, 0.3]", "how far it is carried along and across the grip axis, m")});
}

std::string strategy(const TemplateRequest& request, const TemplateNumbers& numbers) {
  std::string text = "\n[strategy]\n";
  if (!searches_force(request.kind)) {
    text += line("grip_force_N", numbers.force_N,
                 joined({"each finger, N; holding takes about ", short_number(numbers.hold_force_N), " N"}));
  }
  return text + line("approach_speed_m_s", numbers.speed_m_s, "each finger, m/s") +
         line("lift_acceleration_m_s2", kLiftAcceleration_m_s2, "peak while it is lifted and carried, m/s2");
}

/// Values from..to, evenly spaced in their logarithm, as the gripper can set them.
std::string force_values(const TemplateNumbers& numbers, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double ratio = numbers.force_to_N / numbers.force_from_N;
    double value = round_two(numbers.force_from_N * std::pow(ratio, static_cast<double>(i) / (count - 1)));
    const double step = numbers.force_step_N;
    if (step > 0.0) value = std::max(step, std::round(value / step) * step);
    if (values.empty() || value > values.back()) values.push_back(value);
  }
  return comma_list(values, toml);
}

std::string vary(std::string_view key, std::string_view values, std::string_view comment) {
  return joined({"\n[[vary]]\n", texts("key", key, comment), "values = [", values, "]\n"});
}

std::string vary_speed(const TemplateNumbers& numbers) {
  return vary(
      "strategy.approach_speed_m_s",
      joined({toml(numbers.speed_from_m_s), ", ", toml(numbers.speed_m_s), ", ", toml(numbers.speed_to_m_s)}),
      "a faster approach hits harder, m/s");
}

std::string box(std::string_view table, std::string_view key, double from, double to, std::string_view comment) {
  return joined(
      {"\n[[", table, "]]\n", texts("key", key, comment), "from = ", toml(from), "\nto = ", toml(to), "\n"});
}

std::string variables(const TemplateNumbers& numbers) {
  return box("variable", "strategy.grip_force_N", numbers.force_from_N, numbers.force_to_N, "searched, N") +
         box("variable", "strategy.lift_acceleration_m_s2", 0.5, 8.0, "searched, m/s2");
}

std::string random_friction(const TemplateNumbers& numbers) {
  const double friction = numbers.friction;
  return joined({"\n[[random]]\n",
                 texts("key", "product.friction", "how products differ; measure yours, this is a guess"),
                 "distribution = \"triangular\"\n", "from = ", toml(0.8 * friction), "\nmode = ", toml(friction),
                 "\nto = ", toml(1.2 * friction), "\n"});
}

std::string random_keys(const TemplateNumbers& numbers) {
  return joined({random_friction(numbers), "\n[[random]]\n",
                 texts("key", "product.youngs_modulus_Pa", "stiffness, Pa; a guess, too"),
                 "distribution = \"lognormal\"\nmean = ", toml(numbers.youngs_modulus_Pa), "\n",
                 line("relative_deviation", 0.1, "standard deviation over the mean")});
}

constexpr std::string_view kSampling = "\n[sampling]\n";

std::string sample_count() { return line("count = 64", "products, the same for every strategy"); }

std::string sampling() {
  return joined({kSampling, sample_count(),
                 line("factor_groups = 8", "joint values of the stiffness among them: each is factored once")});
}

std::string search(std::string_view goals, std::string_view budget) {
  return joined({"\n[search]\n", goals, line("starts = 4", "searches from different beginnings"),
                 line(joined({"budget = ", budget}), "strategies tried, all searches together")});
}

std::string candidate(std::string_view name, double force_N, double speed_m_s) {
  return joined({"\n[[candidate]]\n", texts("name", name, "or: use = \"strategies/gentle.toml\""),
                 line("grip_force_N", force_N, "N"), line("approach_speed_m_s", speed_m_s, "m/s")});
}

std::string held_constraint() {
  return line("constraints = [\"held\"]", "not dropped, not slipped, no limit exceeded");
}

}  // namespace

std::string simulate_template(const TemplateNumbers& /*numbers*/) { return ""; }

std::string sweep_template(const TemplateNumbers& numbers) {
  return vary("strategy.grip_force_N", force_values(numbers, 8), "N") + vary_speed(numbers);
}

std::string window_template(const TemplateNumbers& numbers) {
  return joined({"\n[window]\n", line("from_N", numbers.force_from_N, "least grip force looked at, N"),
                 line("to_N", numbers.force_to_N, "greatest, N"), vary_speed(numbers)});
}

std::string sample_template(const TemplateNumbers& numbers) { return sampling() + random_keys(numbers); }

std::string optimize_template(const TemplateNumbers& numbers) {
  return search(line("objective = \"cycle_time_s\"",
                     "to be least: `unbruised explain metrics` lists what can stand here") +
                    held_constraint(),
                "120") +
         variables(numbers);
}

std::string robust_template(const TemplateNumbers& numbers) {
  return search(
             line("objective = \"mean(cycle_time_s)\"", "over the products") +
                 line("constraints = [\"P(held) >= 0.9\"]", "held: not dropped, not slipped, no limit exceeded"),
             "40") +
         joined({kSampling, sample_count()}) + variables(numbers) +
         // Values of the stiffness would come in few groups, and P would stay unshown.
         random_friction(numbers);
}

std::string pareto_template(const TemplateNumbers& numbers) {
  return search(line("objectives = [\"cycle_time_s\", \"peak_finger_force_N\"]", "both to be small") +
                    held_constraint(),
                "240") +
         variables(numbers);
}

std::string compare_template(const TemplateNumbers& numbers) {
  return joined({"\n[compare]\n", texts("metric", "cycle_time_s", "decides among candidates that hold unharmed"),
                 sampling(), candidate("slow", numbers.force_N, numbers.speed_from_m_s),
                 candidate("fast", numbers.force_N, numbers.speed_m_s), random_keys(numbers)});
}

std::string sensitivity_template(const TemplateNumbers& numbers) {
  return joined({"\n[sensitivity]\n", texts("method", "morris", "few runs; \"sobol\" shares the variance out"),
                 line("metrics = [\"friction_margin_min\"]", "what the effects are on"),
                 line("samples = 16", "runs: 16 x (keys + 1)"), random_keys(numbers)});
}

std::string calibrate_template(const TemplateNumbers& numbers) {
  const double modulus_Pa = numbers.youngs_modulus_Pa;
  return joined({"\n[calibrate]\n",
                 line("data = [\"data/press_example.csv\"]", "your curves: closure_m, force_N, specimen"),
                 texts("test", "press", "or relaxation, creep, slide"),
                 box("parameter", "product.youngs_modulus_Pa", round_two(0.5 * modulus_Pa),
                     round_two(5.0 * modulus_Pa), "what is fitted, and how far it may go"),
                 "scale = \"log\"\n"});
}

TemplateNumbers template_numbers(const Scenario& scenario) {
  const auto& product = std::get<LatticeParameters>(scenario.product);
  const ParallelJawParameters& gripper = jaw_of(scenario);
  const double mass_kg = lattice_mass_kg(product);
  const double gravity_m_s2 = std::abs(scenario.cell.gravity_m_s2[2]);
  // Without friction nothing is held; a tenth stands for it, and the study says what comes of it.
  const double friction = std::max(product.friction, 0.1);
  TemplateNumbers numbers;
  numbers.hold_force_N = mass_kg * (gravity_m_s2 + kLiftAcceleration_m_s2) / (2.0 * friction);
  const double least_N = std::max(gripper.min_force_N, gripper.force_step_N);
  const auto settable = [&](double force_N) {
    return std::clamp(round_two(force_N), least_N, gripper.max_force_N);
  };
  numbers.force_N = settable(2.0 * numbers.hold_force_N);
  numbers.force_from_N = settable(0.5 * numbers.hold_force_N);
  numbers.force_to_N =
      std::max(settable(10.0 * numbers.hold_force_N), std::min(2.0 * numbers.force_from_N, gripper.max_force_N));
  numbers.force_step_N = gripper.force_step_N;
  numbers.speed_m_s = std::min(0.1, gripper.max_speed_m_s);
  numbers.speed_from_m_s = 0.5 * numbers.speed_m_s;
  numbers.speed_to_m_s = std::min(0.2, gripper.max_speed_m_s);
  numbers.friction = product.friction;
  numbers.youngs_modulus_Pa = product.youngs_modulus_Pa;
  return numbers;
}

std::string bare_study(const TemplateRequest& request) {
  return joined({"[study]\nname = ", toml_string(request.name), "\nkind = \"simulate\"\n[product]\nuse = ",
                 toml_string(request.product), "\n[gripper]\nuse = ", toml_string(request.gripper), "\n"});
}

std::string study_template(const TemplateRequest& request, const TemplateNumbers& numbers) {
  return joined({head(request), strategy(request, numbers), runner_of(request.kind).template_part(numbers)});
}

}  // namespace unbruised::studies
