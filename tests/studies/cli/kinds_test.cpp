/// @file
/// The shipped study of each kind, on coarse cells, as a user would try it: run, info, verify, interrupted and
/// continued.

#include <string>
#include <vector>

#include <unistd.h>

#include "tests/places.hpp"
#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

/// A shipped study, made small, and how the first line of its answer begins.
struct Shipped {
  std::string name;
  std::string sets;
  std::string answer;
};

void PrintTo(const Shipped& shipped, std::ostream* out) { *out << shipped.name; }

const std::string kCoarse =
    " --set product.cell_size_m=0.0125 --set simulation.time_step_s=2e-3 --set 'cell.transfer_m=[0.0,0.0]'";

class ShippedKind : public testing::ProgramTest, public ::testing::WithParamInterface<Shipped> {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    const std::filesystem::path plain = std::filesystem::temp_directory_path() /
                                        ("unbruised_kind_" + GetParam().name + "_" + std::to_string(::getpid()));
    std::filesystem::remove_all(plain);
    std::filesystem::rename(folder_, plain);  // the name of a parametrised test holds a slash
    folder_ = plain;
  }

  [[nodiscard]] static std::string run_words() {
    return "run " + quoted(std::string(UNBRUISED_SOURCE_DIR) + "/configs/" + GetParam().name + ".toml") + kCoarse +
           " " + GetParam().sets;
  }
};

TEST_P(ShippedKind, RunsAnswersAndVerifies) {
  const Answer run = call(run_words() + " --output run");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("\n" + GetParam().answer), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\nlanes: "), std::string::npos) << run.out;
  const Answer info = call("info run");
  EXPECT_EQ(info.status, 0) << info.err;
  EXPECT_NE(info.out.find("\n" + GetParam().answer), std::string::npos) << info.out;
  EXPECT_EQ(line_after(info.out, "digest "), line_after(run.out, "digest "));
  const Answer verify = call("verify run");
  EXPECT_EQ(verify.status, 0) << verify.out << verify.err;
  const Answer replay = call(run_words() + " --output run --scenario 3");
  EXPECT_EQ(replay.status, 0) << replay.err;
  EXPECT_NE(replay.err.find("same bits as the recorded row"), std::string::npos) << replay.err;
}

TEST_P(ShippedKind, EndsWithTheSameDigestAfterAnInterruption) {
  const std::string whole = line_after(call(run_words() + " --threads 2 --output whole").out, "digest ");
  ASSERT_EQ(whole.size(), 16U);
  std::string digest;
  int interruptions = 0;
  // Until it ends by itself; each piece is longer, so that it does, with sanitizers on a busy machine too.
  for (int piece = 1; digest.empty() && piece < 40; ++piece) {
    const std::string seconds = std::to_string(0.05 * piece * (piece + 2));
    const Answer part = shell("timeout --preserve-status -s INT " + seconds + " " + quoted(UNBRUISED_PROGRAM) +
                              " " + run_words() + " --threads 1 --output pieces");
    if (part.status == 0) {
      digest = line_after(part.out, "digest ");
      break;
    }
    // A signal before the program listens for it ends it as any other; nothing is there to be lost then.
    ASSERT_EQ(part.status, 130) << part.err;
    ++interruptions;
    if (!std::filesystem::exists(folder_ / "pieces" / "results.h5")) continue;
    EXPECT_EQ(call("verify pieces").status, 0);
    const std::string info = call("info pieces").out;
    if (info.find("not complete") != std::string::npos) continue;
    // `timeout` signals twice, so the program may end at once while it makes the report of a finished study.
    digest = line_after(info, "digest ");
  }
  EXPECT_EQ(digest, whole);
  EXPECT_GT(interruptions, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Each, ShippedKind,
    ::testing::Values(
        Shipped{"kiwi_optimize", "--set search.starts=4 --set search.budget=48", "best: cycle_time_s = "},
        Shipped{
            "kiwi_robust",
            "--set search.starts=2 --set search.budget=6 --set sampling.count=16 --set sampling.factor_groups=4",
            "best: mean(cycle_time_s) = "},
        Shipped{"kiwi_pareto", "--set search.starts=1 --set search.points=4 --set search.budget=88", "front: "},
        Shipped{"kiwi_compare", "--set sampling.count=12 --set sampling.factor_groups=3", "verdict: "},
        Shipped{"kiwi_sensitivity", "--set sensitivity.samples=8", "contact_yield_ratio_max, "},
        Shipped{"kiwi_sample", "--set sampling.count=24 --set sampling.factor_groups=3", "P(held) = "}),
    [](const ::testing::TestParamInfo<Shipped>& each) { return each.param.name; });

class Typos : public testing::ProgramTest {};

TEST_F(Typos, InMetricsAndConstraintsAreAnsweredWithTheNearestName) {
  const std::string study = quoted(std::string(UNBRUISED_SOURCE_DIR) + "/configs/kiwi_optimize.toml");
  const Answer metric = call("check " + study + " --set search.objective=cycle_tim_s");
  EXPECT_EQ(metric.status, 2);
  EXPECT_NE(metric.err.find("did you mean 'cycle_time_s'?"), std::string::npos) << metric.err;
  const Answer constraint = call("check " + study + " --set 'search.constraints=[\"hled\"]'");
  EXPECT_EQ(constraint.status, 2);
  EXPECT_NE(constraint.err.find("did you mean 'held'?"), std::string::npos) << constraint.err;
  const Answer bound = call("check " + study + " --set 'search.constraints=[\"friction_margin_mn >= 0.2\"]'");
  EXPECT_NE(bound.err.find("did you mean 'friction_margin_min'?"), std::string::npos) << bound.err;
  const Answer algorithm = call("check " + study + " --set search.algorithm=BOBYQA");
  EXPECT_EQ(algorithm.status, 2);
  EXPECT_NE(algorithm.err.find("COBYLA"), std::string::npos) << algorithm.err;
}

}  // namespace
}  // namespace unbruised::studies
