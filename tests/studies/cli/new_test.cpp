#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

const std::vector<std::string> kKinds = {"simulate", "sweep",  "window",  "sample",      "optimize",
                                         "robust",   "pareto", "compare", "sensitivity", "calibrate"};

class NewStudy : public testing::ProgramTest {
 protected:
  [[nodiscard]] Answer make(const std::string& kind) const {
    return call("new my_" + kind + " --kind " + kind +
                " --product products/kiwi_ripe.toml --gripper grippers/parallel_jaw.toml");
  }
};

TEST_F(NewStudy, OfEveryKindPassesCheckWithoutAWarning) {
  for (const std::string& kind : kKinds) {
    const Answer made = make(kind);
    ASSERT_EQ(made.status, 0) << kind << ": " << made.err;
    const Answer checked = call("check my_" + kind + ".toml");
    EXPECT_EQ(checked.status, 0) << kind << ": " << checked.err << text_of("my_" + kind + ".toml");
    EXPECT_EQ(checked.err, "") << kind;
    EXPECT_NE(checked.out.find("my_" + kind + ": " + kind + ", valid"), std::string::npos) << checked.out;
  }
}

/// A line that assigns something says what it means, but for ends of ranges under a key that said it.
TEST_F(NewStudy, SaysWhatItsLinesMeanWithTheirUnits) {
  ASSERT_EQ(make("window").status, 0);
  const std::string text = text_of("my_window.toml");
  for (const char* line : {"approach_speed_m_s = 0.1", "from_N = ", "lift_height_m = 0.1", "kind = \"window\""}) {
    const std::size_t at = text.find(line);
    ASSERT_NE(at, std::string::npos) << line << " in\n" << text;
    EXPECT_LT(text.find("# ", at), text.find('\n', at)) << line;
  }
}

TEST_F(NewStudy, LeavesWhatIsThereAndSaysWhatIsWrong) {
  write("my_sweep.toml", "mine");
  const Answer answer = make("sweep");
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.err.find("is there already"), std::string::npos) << answer.err;
  EXPECT_EQ(text_of("my_sweep.toml"), "mine");
  EXPECT_NE(call("new a --kind windw --product p --gripper g").err.find("did you mean 'window'?"),
            std::string::npos);
  EXPECT_EQ(call("new a --kind window --product no.toml --gripper grippers/parallel_jaw.toml").status, 2);
  EXPECT_EQ(call("new a --kind window --product products/kiwi_ripe.toml").status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.toml"));
}

class HeavyNewStudy : public NewStudy {};

/// On cells so coarse that the numbers mean nothing: what is written can be run.
TEST_F(HeavyNewStudy, OfEveryKindRuns) {
  for (const std::string& kind : kKinds) {
    ASSERT_EQ(make(kind).status, 0) << kind;
    std::string sets = " --set product.cell_size_m=0.0125 simulation.time_step_s=2e-3";
    if (kind == "optimize" || kind == "robust" || kind == "pareto") sets += " search.budget=16 search.starts=2";
    if (kind == "pareto") sets += " search.points=2 search.budget=48";
    if (kind == "sample" || kind == "robust" || kind == "compare") {
      sets += " sampling.count=8 sampling.factor_groups=2";
    }
    if (kind == "sensitivity") sets += " sensitivity.samples=2";
    const Answer answer = call("run -q my_" + kind + ".toml" + sets);
    EXPECT_EQ(answer.status, 0) << kind << ": " << answer.err;
    EXPECT_NE(line_after(answer.out, "digest "), "") << kind << ": " << answer.out;
  }
}

}  // namespace
}  // namespace unbruised::studies
