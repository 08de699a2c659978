#include <unistd.h>

#include "tests/places.hpp"
#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

/// A block without a yield stress falls on a support: a limit on its plastic strain can never act. Milliseconds.
constexpr const char* kStudy = R"([study]
name = "block"
kind = "simulate"
[product]
shape = "box"
youngs_modulus_Pa = 1e5
size_m = [0.04, 0.04, 0.04]
cell_size_m = 0.02
mass_kg = 0.05
relaxation_time_s = 0.001
[limits]
plastic_strain = 0.01
[simulation]
time_step_s = 1e-3
duration_s = 0.05
)";
constexpr const char* kSentence = "limits.plastic_strain: never exceeded";

class WarningsOfTheProgram : public testing::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("study.toml", kStudy);
  }
};

TEST_F(WarningsOfTheProgram, CheckAndRunSayTheSameOnStderr) {
  const std::string begin = "unbruised: warning: ";
  const std::string checked = line_after(call("check study.toml").err, begin);
  EXPECT_NE(checked.find(kSentence), std::string::npos) << checked;
  EXPECT_EQ(line_after(call("run study.toml").err, begin), checked);
  EXPECT_EQ(line_after(call("run study.toml --scenario 0").err, begin), checked);
}

TEST_F(WarningsOfTheProgram, TravelWithTheAnswerIntoLogResultsAndPage) {
  ASSERT_EQ(call("run study.toml").status, 0);
  EXPECT_NE(text_of("results/block/log.txt").find(kSentence), std::string::npos);
  EXPECT_NE(call("info results/block").out.find(std::string("warning: ") + kSentence), std::string::npos);
  std::filesystem::remove_all(folder_ / "results/block/journal");  // so that only results.h5 can tell
  EXPECT_NE(call("info results/block/results.h5").out.find(kSentence), std::string::npos);
  EXPECT_NE(text_of("results/block/report.html").find(std::string("\"warnings\":[\"") + kSentence),
            std::string::npos);
}

TEST_F(WarningsOfTheProgram, AreInTheFileOfASingleScenarioToo) {
  ASSERT_EQ(call("run study.toml --scenario 0").status, 0);
  EXPECT_NE(call("info results/block/scenario_0.h5").out.find(kSentence), std::string::npos);
}

}  // namespace
}  // namespace unbruised::studies
