#pragma once

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "studies/config/study.hpp"
#include "tests/places.hpp"

namespace unbruised::studies::testing {

inline std::string config_root() { return std::string(UNBRUISED_SOURCE_DIR) + "/configs"; }

/// The messages for a text; empty when it is accepted.
inline std::vector<std::string> errors_of(const std::string& text, const std::vector<std::string>& sets = {}) {
  const StudyOrError result = read_study_text(text, "study.toml", sets, "", config_root());
  return result ? std::vector<std::string>{} : result.error().messages;
}

/// The study of a text that must be right.
inline Study study_of(const std::string& text, const std::vector<std::string>& sets = {}) {
  StudyOrError result = read_study_text(text, "study.toml", sets, "", config_root());
  if (!result) {
    std::string all;
    for (const std::string& line : result.error().messages) all += line + "\n";
    ADD_FAILURE() << all << "in\n" << text;
    return read_study(config_root() + "/hold.toml", {}, config_root()).value();
  }
  return *std::move(result);
}

/// A limit of damage for the kinds that judge damage (two lines); nothing for others.
inline std::string damage_limit(const std::string& kind) {
  const bool judges =
      kind == "window" || kind == "optimize" || kind == "robust" || kind == "pareto" || kind == "compare";
  return judges ? "[limits]\nfinger_force_N = 50.0\n" : "";
}

/// A lattice product, written out, in a gripper of default parameters.
inline std::string gripped_block(const std::string& kind) {
  return "[study]\nname = \"test\"\nkind = \"" + kind + "\"\n" + damage_limit(kind) +
         "[product]\nshape = \"box\"\nsize_m = [0.05, 0.06, 0.07]\nmass_kg = 0.1\nyoungs_modulus_Pa = 1e6\n"
         "[gripper]\n";
}

/// A correct study of a kind that searches or draws products, with as little as it needs.
inline std::string search_block(const std::string& kind) {
  const std::string variable = "[[variable]]\nkey = \"strategy.grip_force_N\"\nfrom = 1.0\nto = 3.0\n";
  const std::string random =
      "[[random]]\nkey = \"product.friction\"\ndistribution = \"uniform\"\nfrom = 0.4\nto = 0.8\n";
  const std::string candidates = "[[candidate]]\nname = \"a\"\n[[candidate]]\nname = \"b\"\ngrip_force_N = 2.0\n";
  std::string text = gripped_block(kind);
  if (kind == "pareto") text += "[search]\nobjectives = [\"cycle_time_s\", \"peak_finger_force_N\"]\n";
  if (kind == "sensitivity") text += "[sensitivity]\nmetrics = [\"cycle_time_s\"]\n";
  if (kind == "optimize" || kind == "robust" || kind == "pareto") text += variable;
  if (kind != "optimize" && kind != "pareto" && kind != "calibrate") text += random;
  if (kind == "compare") text += candidates;
  if (kind == "calibrate") {
    text +=
        "[[parameter]]\nkey = \"product.youngs_modulus_Pa\"\nfrom = 1e5\nto = 2e6\n"
        "[[specimen]]\nname = \"a\"\nclosure_m = [0.001, 0.002, 0.003]\ntime_s = [0.0, 0.5, 1.0]\n"
        "force_N = [1.0, 2.0, 4.0]\n";
  }
  return text;
}

/// A wall and a mass on a spring.
inline std::string small_network() {
  return R"(
[study]
name = "test"
kind = "simulate"
[product]
kind = "network"
[[product.particle]]
position_m = [0.0, 0.0, 0.0]
fixed = ["x", "y", "z"]
[[product.particle]]
position_m = [1.0, 0.0, 0.0]
mass_kg = 2.0
[[product.spring]]
between = [0, 1]
stiffness_N_m = 10.0
yield_force_N = 3.0
[[product.load]]
particle = 1
time_s = [0.0, 1.0]
force_N = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]]
[simulation]
duration_s = 1.0
)";
}

}  // namespace unbruised::studies::testing
