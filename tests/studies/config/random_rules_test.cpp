// What the reader accepts, `validate` accepts, and `Model::build` builds: over random studies.

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <set>

#include "core/scenario/rules.hpp"
#include "core/simulation/simulation.hpp"
#include "studies/config/schema.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

/// Writes random studies, some of which are right.
class Writer {
 public:
  explicit Writer(std::uint64_t seed) : random_(seed) {}

  std::string lattice_study() {
    const bool sweep = chance(0.3);
    const bool sample = !sweep && chance(0.4);
    const double size = log_uniform(0.02, 0.1);
    std::string text = head(sweep ? "sweep" : sample ? "sample" : "simulate");
    text += "[product]\nshape = " + pick({"\"box\"", "\"ellipsoid\"", "\"cylinder\"", "\"box\""}) + "\n";
    text += "size_m = [" + number(size) + ", " + number(size * log_uniform(0.5, 2.0)) + ", " +
            number(size * log_uniform(0.5, 2.0)) + "]\n";
    text += "cell_size_m = " + number(size * log_uniform(0.12, 0.4)) + "\n";
    text += "youngs_modulus_Pa = " + number(log_uniform(1e4, 1e7)) + "\n";
    text += chance(0.9) ? "mass_kg = " + number(log_uniform(0.01, 1.0)) + "\n" : "density_kg_m3 = 1000.0\n";
    text += keys("product.", 0.1) + materials(size);
    text += "[gripper]\n" + keys("gripper.", 0.12) + "[cell]\n" + keys("cell.", 0.12) + "[strategy]\n" +
            keys("strategy.", 0.12) + "[limits]\n" + keys("limits.", 0.2) + "[simulation]\n" +
            keys("simulation.", 0.15);
    if (chance(0.3)) text += sensor();
    if (sweep) text += varied();
    if (sample) text += drawn(size);
    return text;
  }

  std::string network_study() {
    const int particles = integer(1, 4);
    const int springs = integer(0, 4);
    std::string text = head("simulate") + "[product]\nkind = \"network\"\n";
    for (int i = 0; i < particles; ++i) {
      text += "[[product.particle]]\nposition_m = [" + std::to_string(chance(0.1) ? 0 : i) + ", " +
              std::to_string(integer(0, 1)) + ", 0]\n";
      text += "fixed = " + pick({"[\"x\", \"y\", \"z\"]", "[\"y\", \"z\"]", "[]"}) + "\n";
      if (chance(0.95)) text += "mass_kg = " + number(log_uniform(0.01, 10.0)) + "\n";
    }
    for (int i = 0; i < springs; ++i) {
      text += "[[product.spring]]\nbetween = [" +
              std::to_string(chance(0.05) ? particles : integer(0, particles - 1)) + ", " +
              std::to_string(integer(0, particles - 1)) + "]\n";
      if (chance(0.9)) text += "stiffness_N_m = " + number(log_uniform(1.0, 1e4)) + "\n";
      if (chance(0.3)) text += "damping_N_s_m = " + number(log_uniform(0.01, 10.0)) + "\n";
      if (chance(0.4)) text += "yield_force_N = " + number(log_uniform(0.1, 10.0)) + "\n";
      if (chance(0.2)) text += "hardening_ratio = 0.1\n";
    }
    if (chance(0.4)) {
      text += "[[product.load]]\nparticle = " + std::to_string(integer(0, particles)) + "\ntime_s = [0.0, " +
              number(log_uniform(0.1, 1.0)) + "]\nforce_N = [[1, 0, 0], [0, 1, 0]]\n";
    }
    return text + "[simulation]\nduration_s = " + number(log_uniform(1e-4, 1.0)) + "\n";
  }

 private:
  bool chance(double share) { return uniform() < share; }
  double uniform() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }
  int integer(int low, int high) { return low + static_cast<int>(uniform() * (high - low + 1)); }
  std::string pick(const std::vector<std::string>& words) {
    return words[static_cast<std::size_t>(integer(0, static_cast<int>(words.size()) - 1))];
  }

  /// Three digits: round numbers meet each other, so that "<" and "<=" differ.
  static std::string number(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
    return spelled(std::round(value / unit) * unit);
  }

  static std::string head(const std::string& kind) { return "[study]\nname = \"t\"\nkind = \"" + kind + "\"\n"; }

  /// A value near the default, or of a usual size where the default is zero or nothing.
  std::string near_default(const KeySpec& spec) {
    Scenario scenario;
    scenario.gripper = ParallelJawParameters{};
    const FieldRef field = spec.field(scenario, 0);
    const auto one = [&](std::optional<double> usual) {
      const double size = usual.value_or(0.0);
      return number(size == 0.0 ? log_uniform(1e-3, 0.2) : std::abs(size) * log_uniform(0.2, 5.0));
    };
    if (spec.type != KeyType::numbers) return one(number_at(field, {}));
    std::string items;
    for (int i = 0; i < spec.size; ++i) items += (i > 0 ? ", " : "") + one(number_at(field, {i}));
    return "[" + items + "]";
  }

  /// Keys that have an effect only beside others, or a narrow range, are written rarely.
  bool is_chosen(const KeySpec& spec, double share) {
    const std::set<Use> conditional = {Use::network,     Use::with_axis,     Use::superellipsoid, Use::tracking,
                                       Use::stop,        Use::range,         Use::guard,          Use::range_guard,
                                       Use::force_guard, Use::position_hold, Use::not_gripper};
    const bool is_rare =
        conditional.contains(spec.use) ||
        std::ranges::any_of(std::to_array<std::string_view>(
                                {"gripper.pad.", "product.burgers_", "product.initial_", "simulation.theta"}),
                            [&](std::string_view rare) { return spec.path.starts_with(rare); });
    return chance(is_rare ? 0.15 * share : share);
  }

  /// Some keys of a table.
  std::string keys(const std::string& table, double share) {
    static const std::vector<std::string_view> written = {"product.shape",         "product.size_m",
                                                          "product.cell_size_m",   "product.mass_kg",
                                                          "product.density_kg_m3", "product.youngs_modulus_Pa",
                                                          "simulation.duration_s"};
    std::string text;
    for (const KeySpec& spec : key_table()) {
      if (!spec.path.starts_with(table) || spec.field == nullptr || spec.path.find("[]") != std::string_view::npos)
        continue;
      if (spec.type == KeyType::series) continue;            // lists that have to fit each other
      if (spec.path.starts_with("product.skin_")) continue;  // so do these: see `materials`
      if (std::find(written.begin(), written.end(), spec.path) != written.end() || !is_chosen(spec, share))
        continue;
      std::string value;
      if (spec.type == KeyType::boolean) value = pick({"true", "false"});
      if (spec.type == KeyType::choice)
        value = toml_string(
            spec.choices[static_cast<std::size_t>(integer(0, static_cast<int>(spec.choices.size()) - 1))]);
      if (spec.type == KeyType::integer) value = std::to_string(integer(0, 9));
      if (value.empty()) value = near_default(spec);
      text += std::string(spec.path.substr(table.size())) + " = " + value + "\n";
    }
    return text;
  }

  /// A skin, a layer by depth, one by place: mostly such as fit.
  std::string materials(double size) {
    std::string text;
    if (chance(0.2)) {
      text += "skin_thickness_m = " + number(size * log_uniform(0.01, 0.3)) + "\n";
      if (chance(0.8)) text += "skin_modulus_Pa = " + number(log_uniform(1e4, 1e8)) + "\n";
      if (chance(0.3)) text += "skin_poisson_ratio = " + number(log_uniform(0.1, 0.6)) + "\n";
    }
    for (const char* where : {"from_depth_m", "size_m"}) {
      if (!chance(0.2)) continue;
      const std::string length = number(size * log_uniform(0.05, 0.4));
      text += "[[product.layer]]\n" + std::string(where) + " = ";
      text +=
          where == std::string("size_m") ? "[" + length + ", " + length + ", " + length + "]\n" : length + "\n";
      text += "youngs_modulus_Pa = " + number(log_uniform(1e4, 1e8)) + "\n";
      if (chance(0.1)) text += "center_m = [0.0, 0.001, 0.0]\n";
      if (chance(0.3))
        text += "yield_stress_Pa = 1e4\ntangent_modulus_Pa = " + number(log_uniform(1e3, 1e5)) + "\n";
    }
    return text;
  }

  std::string sensor() {
    std::string text = "[sensor]\nat = " + pick({"\"wrist\"", "\"support\""}) + "\nposition_m = [0.0, 0.0, 0.1]\n";
    text += "mass_kg = " + number(log_uniform(0.05, 2.0)) + "\n";
    if (chance(0.5)) text += "rate_Hz = " + number(log_uniform(100.0, 5000.0)) + "\n";
    if (chance(0.2)) text += "noise_N = 0.01\n";
    if (chance(0.2)) text += "stiffness_N_m = [1e6, 1e6, 1e6]\n";
    return text;
  }

  std::string varied() {
    const std::string key =
        pick({"product.size_m[2]", "product.cell_size_m", "strategy.grip_force_N", "cell.lift_height_m",
              "gripper.opening_m", "simulation.time_step_s", "strategy.release_height_m"});
    const double from = key == "strategy.grip_force_N" ? 0.2 : key == "simulation.time_step_s" ? 2e-4 : 0.01;
    const double a = from * log_uniform(1.0, 5.0);
    return "[[vary]]\nkey = \"" + key + "\"\nfrom = " + number(a) + "\nto = " + number(a * log_uniform(1.1, 4.0)) +
           "\ncount = 4\n";
  }

  std::string drawn(double size) {
    const std::string key =
        pick({"product.size_m[0]", "product.size_m[2]", "product.mass_kg", "product.friction"});
    const double from = key.starts_with("product.size") ? size * log_uniform(0.8, 1.0) : log_uniform(0.05, 0.3);
    return "[[random]]\nkey = \"" + key + "\"\ndistribution = \"uniform\"\nfrom = " + number(from) +
           "\nto = " + number(from * log_uniform(1.1, 1.6)) + "\n";
  }

  std::mt19937_64 random_;
};

/// The scenarios of a study: those of its plan, and a few that it may draw.
std::vector<Scenario> scenarios_of(const Study& study) {
  std::vector<Scenario> all;
  for (std::size_t id = 0; id < study.scenario_count(); ++id) all.push_back(study.scenario(id));
  for (const RandomVariable& random : study.randoms()) {
    for (const double u : {0.03, 0.29, 0.5, 0.77, 0.99}) {
      const std::array<std::string, 1> key = {random.key};
      const std::array<double, 1> value = {quantile(random.distribution, u)};
      all.push_back(study.scenario_with(key, value));
    }
  }
  return all;
}

void expect_sound(const Scenario& scenario, const std::string& text, bool build) {
  for (const Violation& violation : validate(scenario)) {
    ADD_FAILURE() << "accepted by the reader, but " << violation.field << " = " << violation.value << ": "
                  << violation.rule << "\n"
                  << text;
  }
  if (!build) return;
  std::string error;
  EXPECT_NE(Model::build(scenario, error), nullptr) << error << "\n" << text;
}

struct Tally {
  int accepted = 0;
  int refused = 0;
};

/// @param built how many of the accepted studies have their first scenario built
Tally try_studies(int count, int built, std::string (Writer::*write)()) {
  constexpr std::uint64_t kSeed = 20261126;
  Tally tally;
  for (int i = 0; i < count; ++i) {
    Writer writer(kSeed + static_cast<std::uint64_t>(i));
    const std::string text = (writer.*write)();
    const StudyOrError read = read_study_text(text, "study.toml", {}, "", testing::config_root());
    (read ? tally.accepted : tally.refused) += 1;
    if (!read) continue;
    bool first = tally.accepted <= built;
    for (const Scenario& scenario : scenarios_of(*read)) {
      expect_sound(scenario, "seed " + std::to_string(kSeed + static_cast<std::uint64_t>(i)) + "\n" + text, first);
      first = false;
      if (::testing::Test::HasFailure()) return tally;
    }
  }
  return tally;
}

void expect_mixed(const Tally& tally, int least) {
  std::cout << tally.accepted << " accepted, " << tally.refused << " refused\n";
  EXPECT_GT(tally.accepted, least);
  EXPECT_GT(tally.refused, least);
}

TEST(RandomRules, WhatTheReaderAcceptsOfLatticesIsValidAndCanBeBuilt) {
  expect_mixed(try_studies(240, 4, &Writer::lattice_study), 10);
}

TEST(RandomRules, WhatTheReaderAcceptsOfNetworksIsValidAndCanBeBuilt) {
  expect_mixed(try_studies(100, 100, &Writer::network_study), 10);
}

TEST(HeavyRandomRules, WhatTheReaderAcceptsIsValidAndCanBeBuilt) {
  expect_mixed(try_studies(2500, 80, &Writer::lattice_study), 200);
  expect_mixed(try_studies(2000, 2000, &Writer::network_study), 200);
}

}  // namespace
}  // namespace unbruised::studies
