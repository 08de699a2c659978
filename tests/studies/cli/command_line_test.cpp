#include <algorithm>

#include <unistd.h>

#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

class CommandLine : public testing::ProgramTest {
 protected:
  /// Exit 2, one clear message on stderr, nothing on stdout.
  void expect_refused(const std::string& words, const std::string& message) const {
    const Answer answer = call(words);
    EXPECT_EQ(answer.status, 2) << words << "\n" << answer.err;
    EXPECT_NE(answer.err.find(message), std::string::npos) << words << "\n" << answer.err;
    EXPECT_EQ(answer.out, "") << words;
  }

  void write_study(const std::string& product_line) const {
    write("study.toml",
          "[study]\nname = \"small\"\nkind = \"simulate\"\n[product]\nkind = \"lattice\"\nshape = \"box\"\n"
          "size_m = [0.04, 0.04, 0.04]\ncell_size_m = 0.01\nyoungs_modulus_Pa = 1e6\n" +
              product_line + "\n[simulation]\nduration_s = 0.1\n");
  }
};

TEST_F(CommandLine, RefusesAMisspeltKeyAndNamesTheNearest) {
  write_study("mass_kg = 0.1\nyoung_modulus_Pa = 2e6");
  expect_refused("check study.toml", "study.toml:11");
  expect_refused("run study.toml", "product.youngs_modulus_Pa");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "results")) << "nothing may be written for a bad study";
}

TEST_F(CommandLine, RefusesAWrongType) {
  write_study("mass_kg = \"heavy\"");
  expect_refused("run study.toml", "study.toml:10: product.mass_kg = \"heavy\"");
}

TEST_F(CommandLine, RefusesANegativeMass) {
  write_study("mass_kg = -0.1");
  expect_refused("run study.toml", "study.toml:10: product.mass_kg = -0.1");
}

TEST_F(CommandLine, RefusesAMissingFile) { expect_refused("run nowhere.toml", "nowhere.toml"); }

TEST_F(CommandLine, RefusesUnreadableToml) {
  write("study.toml", "[study\nname = 1\n");
  expect_refused("run study.toml", "study.toml:1");
}

TEST_F(CommandLine, RefusesABadSet) {
  write_study("mass_kg = 0.1");
  expect_refused("check study.toml --set product.mass_kg=-1", "product.mass_kg = -1");
  expect_refused("check study.toml --set product.mas_kg=1", "product.mass_kg");
  expect_refused("check study.toml --set product.mass_kg", "must be key=value");
}

TEST_F(CommandLine, SetMayRepeatAndTakeSeveral) {
  write_study("mass_kg = 0.1");
  // Each of the three is looked at: a wrong one among them is found wherever it stands.
  const std::string good = "product.mass_kg=0.2";
  expect_refused("check --set " + good + " product.poisson_ratio=7 study.toml", "product.poisson_ratio = 7");
  expect_refused("check --set " + good + " --set product.poisson_ratio=7 study.toml", "product.poisson_ratio = 7");
  expect_refused("check study.toml --set " + good + " product.poisson_ratio=7", "product.poisson_ratio = 7");
  const Answer answer = call("check --set " + good + " product.poisson_ratio=0.2 study.toml");
  EXPECT_EQ(answer.status, 0) << answer.err;
}

TEST_F(CommandLine, SuggestsTheNearestOptionAndCommand) {
  expect_refused("run study.toml --thread 2", "did you mean '--threads'?");
  expect_refused("rnu study.toml", "did you mean 'run'?");
  expect_refused("--verion", "unknown option '--verion'");
  expect_refused("", "which command?");
}

TEST_F(CommandLine, RefusesBadNumbersOfOptions) {
  write_study("mass_kg = 0.1");
  expect_refused("run study.toml --threads 0", "--threads");
  expect_refused("run study.toml --threads many", "--threads");
  expect_refused("run study.toml --scenario -1", "--scenario");
  expect_refused("run study.toml --scenario 1", "scenarios 0 to 0");
  expect_refused("run study.toml other.toml", "other.toml");
  expect_refused("run", "needs a study file");
}

TEST_F(CommandLine, AFolderMayHaveTheNameOfACommand) {
  std::filesystem::create_directories(folder_ / "run");
  expect_refused("info run", "run is no run directory");
}

TEST_F(CommandLine, HelpAndVersionGoToStdout) {
  EXPECT_EQ(call("--help").status, 0);
  EXPECT_NE(call("--help").out.find("check"), std::string::npos);
  EXPECT_NE(call("run --help").out.find("--scenario"), std::string::npos);
  EXPECT_TRUE(call("--version").out.starts_with("unbruised ")) << call("--version").out;
}

TEST_F(CommandLine, ExplainsKeys) {
  const Answer answer = call("explain strategy.grip_force_N");
  EXPECT_EQ(answer.status, 0);
  EXPECT_NE(answer.out.find("grip_force_N"), std::string::npos);
  expect_refused("explain strategy.grip_forse_N", "did you mean 'strategy.grip_force_N'?");
  EXPECT_EQ(call("explain grip_force_N").out, answer.out);  // as answers print it
}

TEST_F(CommandLine, ExplainsMetricsOutcomesAndWordsOfGoals) {
  EXPECT_NE(call("explain peak_pressure_Pa").out.find("unit: Pa"), std::string::npos);
  EXPECT_NE(call("explain held").out.find("no limit exceeded"), std::string::npos);
  EXPECT_NE(call("explain P").out.find("\"P(held) >= 0.95\""), std::string::npos);
  EXPECT_NE(call("explain").out.find("quantile"), std::string::npos);
  expect_refused("explain quantil", "did you mean 'quantile'?");
  expect_refused("explain droped", "did you mean 'dropped'?");
  expect_refused("explain peak_pressure_pa", "did you mean 'peak_pressure_Pa'?");
}

TEST_F(CommandLine, ListsTheLibrary) {
  const Answer answer = call("list");
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_NE(answer.out.find("products/kiwi_ripe.toml"), std::string::npos);
  EXPECT_NE(answer.out.find("grippers/parallel_jaw.toml"), std::string::npos);
}

TEST_F(CommandLine, InfoRefusesWhatIsNoRunDirectory) {
  expect_refused("info nowhere", "nowhere does not exist");
  expect_refused("info .", "no run directory");
  write("noise.h5", "not HDF5");
  EXPECT_NE(call("info noise.h5").status, 0);
}

TEST_F(CommandLine, ChecksAHundredThousandScenarios) {
  write(
      "study.toml",
      "[study]\nname = \"wide\"\nkind = \"sweep\"\n[product]\nuse = \"products/kiwi_ripe.toml\"\n[gripper]\nuse = "
      "\"grippers/parallel_jaw.toml\"\n[[vary]]\nkey = \"strategy.grip_force_N\"\nfrom = 0.6\nto = 6.0\ncount = "
      "500\n[[vary]]\nkey = \"strategy.approach_speed_m_s\"\nfrom = 0.02\nto = 0.25\ncount = 200\n");
  const Answer answer = call("check study.toml");
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_NE(answer.out.find("scenarios: 100,000"), std::string::npos) << answer.out;
  EXPECT_NE(answer.out.find("groups by factor key: 1\n"), std::string::npos) << answer.out;
}

TEST_F(CommandLine, CheckSaysOnWhichKindOfCoreItsTimeWasMeasured) {
  write(
      "study.toml",
      "[study]\nname = \"one\"\nkind = \"simulate\"\n[product]\nuse = \"products/kiwi_ripe.toml\"\n[gripper]\nuse "
      "= \"grippers/parallel_jaw.toml\"\n");
  const bool avx512 = call("--version").out.find("avx512f") != std::string::npos;
  const Answer answer = call("check study.toml");
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_NE(answer.out.find(avx512 ? "measured on an AVX-512 core" : "measured on an AVX2 core"),
            std::string::npos)
      << answer.out;
}

TEST_F(CommandLine, CheckWarnsWhereAContactGetsTooFewSteps) {
  write("study.toml",
        "[study]\nname = \"coarse\"\nkind = \"simulate\"\n[product]\nuse = "
        "\"products/kiwi_ripe.toml\"\n[gripper]\nuse "
        "= \"grippers/parallel_jaw.toml\"\n[simulation]\ntime_step_s = 0.01\n");
  const Answer answer = call("check study.toml");
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_NE(answer.err.find("use simulation.time_step_s <= 0.001035"), std::string::npos) << answer.err;
}

}  // namespace
}  // namespace unbruised::studies
