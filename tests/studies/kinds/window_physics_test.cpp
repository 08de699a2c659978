/// @file
/// Window studies as shipped, through configs, search and simulator, against closed forms.

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <unistd.h>

#include "studies/config/study.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/execution/lane_executor.hpp"
#include "studies/kinds/study_runner.hpp"
#include "studies/results/run_directory.hpp"
#include "tests/places.hpp"

namespace unbruised::studies {
namespace {

constexpr double kGravity = 9.80665;

Study study_of(const std::string& file, const std::vector<std::string>& sets = {}) {
  const std::string root = std::string(UNBRUISED_SOURCE_DIR) + "/configs";
  return read_study(root + "/" + file, sets, root).value();
}

WindowTable window_of(const Study& study) {
  const auto directory = std::filesystem::temp_directory_path() /
                         ("unbruised_window_test_" + std::to_string(getpid()) + "_" + study.name());
  std::filesystem::remove_all(directory);
  auto run = RunDirectory::open({directory, study.resolved_toml(), build_line(), false});
  EXPECT_TRUE(run.has_value());
  StudyRunOptions options;
  auto report = run_study(study, **run, LaneExecutor(core_simulator(), 2), options);
  EXPECT_TRUE(report.has_value());
  WindowTable table = report->tables.window.value();
  run->reset();
  std::filesystem::remove_all(directory);
  return table;
}

double product_mass(const Study& study) { return *std::get<LatticeParameters>(study.scenario(0).product).mass_kg; }
double product_friction(const Study& study) {
  return std::get<LatticeParameters>(study.scenario(0).product).friction;
}

TEST(WindowPhysics, HoldForceOfALiftIsTheClosedForm) {
  const Study study = study_of("hold_limit.toml");
  const WindowTable table = window_of(study);
  ASSERT_EQ(table.rows.size(), 3U);
  const double accelerations[] = {1.0, 2.0, 4.0};
  for (std::size_t i = 0; i < 3; ++i) {
    const double exact = product_mass(study) * (kGravity + accelerations[i]) / (2.0 * product_friction(study));
    // 2 %: the bisection's own tolerance is 0.5 %, and while the rubber stretches the start costs about 1 %.
    EXPECT_NEAR(table.rows[i].hold_force_N, exact, 0.02 * exact) << "a = " << accelerations[i];
  }
}

TEST(WindowPhysics, HoldForceOfAHorizontalTransferIsTheClosedForm) {
  // The transfer needs more than the lift of 1 m/s2: m sqrt(g^2 + a^2) against m (g + 1).
  const Study study =
      study_of("hold_limit.toml", {"strategy.transfer_acceleration_m_s2=8.0", "cell.transfer_m=[0.0,0.6]"});
  const WindowTable table = window_of(study);
  const double exact = product_mass(study) * std::hypot(kGravity, 8.0) / (2.0 * product_friction(study));
  EXPECT_NEAR(table.rows[0].hold_force_N, exact, 0.02 * exact);
}

TEST(WindowPhysics, TofuHasNoWindow) {
  const Study study = study_of("tofu_window.toml");
  const WindowTable table = window_of(study);
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_FALSE(table.rows[0].exists);
  // It takes at least m (g + a) / (2 mu) = 5.4 N to hold and 2 N are allowed.
  EXPECT_GT(table.rows[0].hold_force_N, 5.4 * 0.98);
  EXPECT_LE(table.rows[0].damage_force_N, 2.0);
}

TEST(WindowPhysics, RipeKiwiIsHeldFromTheClosedFormOn) {
  // Coarse cells: the lower end does not depend on them.
  const Study study = study_of("kiwi_window.toml", {"product.cell_size_m=0.0085", "window.from_N=0.5",
                                                    "window.to_N=7.0", "window.tolerance=0.01"});
  const WindowTable table = window_of(study);
  const double exact = product_mass(study) * (kGravity + 2.0) / (2.0 * product_friction(study));
  ASSERT_EQ(table.rows.size(), 4U);
  double gentlest_N = 7.0;  // of the slower approaches
  // At 0.3 m/s the impact alone marks a ripe kiwi between pads of bonded silicone.
  EXPECT_FALSE(table.rows.back().exists);
  for (std::size_t i = 0; i + 1 < table.rows.size(); ++i) {
    const WindowRow& row = table.rows[i];
    EXPECT_LE(row.damage_force_N, gentlest_N) << "a faster approach never allows more";
    gentlest_N = row.damage_force_N;
    // The slip limit of 2 mm forgives a moment of sliding at the peak of a minimum-jerk profile: a few per cent
    // low.
    EXPECT_NEAR(row.hold_force_N, exact, 0.04 * exact);
    EXPECT_TRUE(row.exists);
  }
}

}  // namespace
}  // namespace unbruised::studies
