// What `check` says that a study takes, against what shipped ones took.

#include "studies/estimate/study_cost.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "studies/estimate/cost_estimate.hpp"
#include "tests/places.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

StudyCost cost_of(const std::string& name, int threads) {
  const fs::path configs = fs::path(UNBRUISED_SOURCE_DIR) / "configs";
  const StudyOrError read = read_study(configs / (name + ".toml"), {}, configs);
  EXPECT_TRUE(read.has_value()) << name;
  return study_cost(*read, threads);
}

/// A study on two threads of a Zen 3 core at 2.4 GHz.
struct Measured {
  std::string name;
  double seconds;
};

TEST(StudyCost, OfProductsThatTouchWithTheirWholeSurfaceIsRightWithinAFactorOfTwo) {
  // Core time over the threads that worked, on a machine that did other things beside it: 17.1 s on two
  // (2026-11-27), and 24.2 s on one (2026-11-28, when a lone scenario no longer cost as much as sixteen).
  const double machine = measured_lane_step_rate().seconds_per_factor_entry / 8.7e-10;
  for (const Measured& run : {Measured{"drop_attitude", 8.5}, Measured{"turn_and_place", 24.2}}) {
    const double ratio = cost_of(run.name, 2).seconds / (machine * run.seconds);
    EXPECT_GT(ratio, 0.5) << run.name;
    EXPECT_LT(ratio, 2.0) << run.name;
  }
}

TEST(StudyCost, OfOneRunDoesNotFallWithMoreThreads) {
  // Its lanes are one thread's.
  EXPECT_EQ(cost_of("turn_and_place", 1).seconds, cost_of("turn_and_place", 8).seconds);
  EXPECT_NEAR(cost_of("kiwi_sweep", 4).seconds, 0.25 * cost_of("kiwi_sweep", 1).seconds,
              1e-9 * cost_of("kiwi_sweep", 1).seconds);
}

}  // namespace
}  // namespace unbruised::studies
