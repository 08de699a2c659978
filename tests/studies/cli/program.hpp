#pragma once

/// @file
/// Calls the real program as a user does.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

namespace unbruised::studies::testing {

namespace fs = std::filesystem;

/// The start of a sweep of a coarse block: the numbers mean nothing, their form does.
inline std::string coarse_block(const std::string& name) {
  return "[study]\nname = \"" + name + R"("
kind = "sweep"
[product]
shape = "box"
size_m = [0.04, 0.04, 0.04]
cell_size_m = 0.02
mass_kg = 0.1
youngs_modulus_Pa = 1e6
yield_stress_Pa = 1e5
tangent_modulus_Pa = 1e5
relaxation_time_s = 1e-3
friction = 0.5
[limits]
contact_yield_ratio = 1.0
[gripper]
use = "grippers/parallel_jaw.toml"
[simulation]
time_step_s = 2e-3
)";
}

/// Two masses between springs: milliseconds to run for each second.
inline std::string two_masses(const std::string& duration_s) {
  std::string text = R"([product]
kind = "network"
[[product.particle]]
position_m = [0.0, 0.0, 0.0]
fixed = ["x", "y", "z"]
[[product.particle]]
position_m = [1.0, 0.0, 0.0]
mass_kg = 2.0
fixed = ["y", "z"]
initial_displacement_m = [0.01, 0.0, 0.0]
[[product.spring]]
between = [0, 1]
stiffness_N_m = 50.0
[simulation]
time_step_s = 0.01
duration_s = DURATION
[cell]
gravity_m_s2 = [0.0, 0.0, 0.0]
support = false
)";
  return text.replace(text.find("DURATION"), std::string("DURATION").size(), duration_s);
}

/// A sweep of the spring between them.
inline std::string two_masses_sweep(const std::string& duration_s, int count) {
  return "[study]\nname = \"masses\"\nkind = \"sweep\"\n" + two_masses(duration_s) +
         "[[vary]]\nkey = \"product.spring[0].stiffness_N_m\"\nfrom = 40.0\nto = 60.0\ncount = " +
         std::to_string(count) + "\n";
}

/// A folder of its own for each test, removed at its end.
class ProgramTest : public ::testing::Test {
 protected:
  struct Answer {
    int status = -1;
    std::string out;
    std::string err;
  };

  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        fs::temp_directory_path() / (std::string("unbruised_") + info->name() + "_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] Answer call(const std::string& words) const {
    return shell(quoted(UNBRUISED_PROGRAM) + " " + words);
  }

  /// Runs a shell line in the test's folder.
  [[nodiscard]] Answer shell(const std::string& line) const {
    const std::string command = "cd " + quoted(folder_.string()) + " && (" + line + ") >stdout.txt 2>stderr.txt";
    const int status = std::system(command.c_str());
    Answer answer;
    answer.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    answer.out = text_of("stdout.txt");
    answer.err = text_of("stderr.txt");
    return answer;
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  [[nodiscard]] std::string text_of(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
    return text.str();
  }

  [[nodiscard]] static std::string quoted(const std::string& word) { return "'" + word + "'"; }

  /// The line of `text` that begins so, without that beginning; empty when there is none.
  [[nodiscard]] static std::string line_after(const std::string& text, const std::string& begin) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with(begin)) return line.substr(begin.size());
    }
    return {};
  }

  fs::path folder_;
};

}  // namespace unbruised::studies::testing
