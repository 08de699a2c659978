#include <unistd.h>

#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

class ReportProgram : public testing::ProgramTest {
 protected:
  void write_study(const std::string& duration_s, int count) const {
    write("study.toml", testing::two_masses_sweep(duration_s, count));
  }
};

TEST_F(ReportProgram, IsWrittenAtTheEndOfARun) {
  write_study("0.5", 5);
  const Answer run = call("run study.toml");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(line_after(run.out, "report: "), "results/masses/report.html");
  const std::string page = text_of("results/masses/report.html");
  EXPECT_NE(page.find("<title>masses - Unbruised</title>"), std::string::npos);
  EXPECT_NE(page.find("run results/masses/config.toml --output results/masses --scenario"), std::string::npos);
}

TEST_F(ReportProgram, IsMadeAgainOfARunDirectoryAResultsFileAndASingleScenario) {
  write_study("0.5", 5);
  ASSERT_EQ(call("run study.toml --output run").status, 0);
  std::filesystem::remove(folder_ / "run/report.html");
  EXPECT_TRUE(line_after(call("report run").out, "report: ").starts_with("run/report.html ("));
  EXPECT_TRUE(line_after(call("report run/results.h5 -o page.html").out, "report: ").starts_with("page.html ("));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "page.html"));
  ASSERT_EQ(call("run study.toml --output run --scenario 2").status, 0);
  const Answer one = call("report run/scenario_2.h5");
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_NE(text_of("run/scenario_2.html").find("\"trace\":"), std::string::npos);
}

TEST_F(ReportProgram, TheCommandOnThePageReplaysItsScenario) {
  write_study("0.5", 5);
  ASSERT_EQ(call("run study.toml --output run").status, 0);
  const Answer again = call("run run/config.toml --output run --scenario 3");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.err.find("same bits as the recorded row"), std::string::npos) << again.err;
}

TEST_F(ReportProgram, SaysThatAnInterruptedStudyIsNotComplete) {
  write_study("200.0", 400);
  // The signal comes once the first scenarios are in the journal, however busy the machine.
  const Answer stopped = shell(quoted(UNBRUISED_PROGRAM) +
                               " run study.toml --threads 1 --output run & program=$!; "
                               "while ! cat run/journal/*.jrnl 2>/dev/null | grep -q UBJ; do sleep 0.05; done; "
                               "kill -TERM $program; wait $program");
  ASSERT_EQ(stopped.status, 143) << stopped.err;
  const std::string page = text_of("run/report.html");
  EXPECT_NE(page.find("\"complete\":false"), std::string::npos);
  EXPECT_NE(page.find("\"wanted\":400"), std::string::npos);
}

TEST_F(ReportProgram, ARunThatCannotWriteItsPageIsStillDone) {
  write_study("0.5", 2);
  std::filesystem::create_directories(folder_ / "run/report.html/in_the_way");
  const Answer run = call("run study.toml --output run");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("no report was written"), std::string::npos) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "run/results.h5"));
}

TEST_F(ReportProgram, RefusesWhatIsNoResultAndWhatIsNoReport) {
  write_study("0.5", 2);
  ASSERT_EQ(call("run study.toml --output run").status, 0);
  EXPECT_EQ(call("report nowhere").status, 2);
  EXPECT_EQ(call("report study.toml").status, 2);
  const Answer kept = call("report run -o run/results.h5");
  EXPECT_EQ(kept.status, 2) << kept.err;
  EXPECT_EQ(call("verify run").status, 0);
  EXPECT_EQ(call("report run -o missing/page.html").status, 5);
}

}  // namespace
}  // namespace unbruised::studies
