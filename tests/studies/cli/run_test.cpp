#include <unistd.h>

#include "tests/places.hpp"
#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

class RunProgram : public testing::ProgramTest {
 protected:
  void write_network(const std::string& kind, const std::string& vary, const std::string& duration_s) const {
    write("study.toml",
          "[study]\nname = \"masses\"\nkind = \"" + kind + "\"\n" + testing::two_masses(duration_s) + vary);
  }
  /// Begins a shell line: a run beside it, its process id in $child.
  static std::string started(const std::string& words) {
    return quoted(UNBRUISED_PROGRAM) + " " + words + " & child=$!; ";
  }
  /// Until the run has its directory and listens.
  static constexpr const char* kWaitForIt = "while [ ! -d run/journal ]; do sleep 0.05; done; sleep 0.3; ";

  void write_sweep(const std::string& duration_s, int count) const {
    write("study.toml", testing::two_masses_sweep(duration_s, count));
  }
};

TEST_F(RunProgram, WritesResultsWhereTheSummarySaysAndInfoPrintsTheSameDigest) {
  write_sweep("1.0", 5);
  const Answer run = call("run study.toml");
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string results = line_after(run.out, "results: ");
  EXPECT_EQ(results, "results/masses/results.h5");
  EXPECT_TRUE(std::filesystem::exists(folder_ / results));
  const std::string digest = line_after(run.out, "digest ");
  EXPECT_EQ(digest.size(), 16U);
  const Answer info = call("info results/masses");
  EXPECT_EQ(info.status, 0) << info.err;
  EXPECT_EQ(line_after(info.out, "digest "), digest);
  EXPECT_NE(info.out.find("masses: sweep, complete, 5 scenarios"), std::string::npos) << info.out;
  EXPECT_EQ(call("info results/masses/results.h5").out.find("not complete"), std::string::npos);
  EXPECT_EQ(call("verify results/masses").status, 0);
}

TEST_F(RunProgram, DigestsDoNotDependOnTheThreads) {
  write_sweep("1.0", 40);
  const std::string one = line_after(call("run study.toml --threads 1 --output one").out, "digest ");
  EXPECT_EQ(one.size(), 16U);
  EXPECT_EQ(line_after(call("run study.toml --threads 4 --output four").out, "digest "), one);
}

TEST_F(RunProgram, RefusesAFinishedDirectoryUnlessFresh) {
  write_sweep("0.5", 3);
  ASSERT_EQ(call("run study.toml").status, 0);
  const Answer again = call("run study.toml");
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("--fresh"), std::string::npos) << again.err;
  const Answer other = call("run study.toml --set product.particle[1].mass_kg=3.0");
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("product.particle[1].mass_kg"), std::string::npos) << other.err;
  EXPECT_EQ(call("run study.toml --fresh").status, 0);
}

TEST_F(RunProgram, ReplaysOneScenarioWithTheBitsOfTheBatch) {
  write_sweep("1.0", 5);
  ASSERT_EQ(call("run study.toml").status, 0);
  const Answer one = call("run study.toml --scenario 3");
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_NE(one.err.find("same bits as the recorded row"), std::string::npos) << one.err;
  EXPECT_NE(one.out.find("stiffness_N_m = 55"), std::string::npos) << one.out;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "results/masses/scenario_3.h5"));
  const Answer info = call("info results/masses/scenario_3.h5");
  EXPECT_NE(info.out.find("/trace"), std::string::npos) << info.out << info.err;
}

TEST_F(RunProgram, ASingleSimulationKeepsItsTrace) {
  write_network("simulate", "", "1.0");
  ASSERT_EQ(call("run study.toml").status, 0);
  EXPECT_NE(call("info results/masses").out.find("/trace"), std::string::npos);
}

TEST_F(RunProgram, AnInterruptedRunSaysHowToContinueAndEndsWithTheSameDigest) {
  write_sweep("200.0", 400);  // some seconds of work on one thread
  // Ctrl-C once the first results are on the disk, however busy the machine is.
  const Answer stopped = shell(quoted(UNBRUISED_PROGRAM) +
                               " run study.toml --threads 1 --output run & "
                               "until [ -s run/journal/*.jrnl ]; do sleep 0.02; done; kill -INT $!; wait $!");
  ASSERT_EQ(stopped.status, 130) << stopped.err;
  EXPECT_NE(stopped.err.find("run study.toml --output run --threads 1"), std::string::npos) << stopped.err;
  EXPECT_EQ(stopped.out, "");
  const Answer half = call("info run");
  EXPECT_NE(half.out.find("not complete"), std::string::npos) << half.out << half.err;

  const Answer rest = call("run study.toml --threads 2 --output run");
  ASSERT_EQ(rest.status, 0) << rest.err;
  EXPECT_NE(rest.err.find("continuing"), std::string::npos) << rest.err;
  const Answer whole = call("run study.toml --threads 2 --output whole");
  EXPECT_EQ(line_after(rest.out, "digest "), line_after(whole.out, "digest "));
}

TEST_F(RunProgram, ATerminatedRunEndsWith143AndInfoBringsItsResultsUpToDate) {
  write_sweep("200.0", 400);
  const Answer stopped =
      shell(started("run study.toml --threads 1 --output run") +
            "while [ ! -s run/journal/*.jrnl ]; do sleep 0.05; done; sleep 0.2; kill -TERM $child; "
            "wait $child");
  EXPECT_EQ(stopped.status, 143) << stopped.err;
  EXPECT_NE(stopped.err.find("continue with"), std::string::npos) << stopped.err;
  std::filesystem::remove(folder_ / "run/results.h5");
  const Answer info = call("info run");
  EXPECT_EQ(info.status, 0) << info.err;
  EXPECT_NE(info.err.find("up to date from the journal"), std::string::npos) << info.err;
  const Answer again = call("info run");
  EXPECT_EQ(again.err.find("up to date"), std::string::npos) << again.err;  // nothing new to write
  EXPECT_EQ(line_after(again.out, "digest "), line_after(info.out, "digest "));
  EXPECT_EQ(call("verify run").status, 0);
}

TEST_F(RunProgram, AClosedTerminalEndsItWith129AndTheLineThatContinues) {
  write_sweep("200.0", 400);
  const std::string begun = started("run study.toml --threads 1 --output run");
  const Answer stopped = shell(begun + kWaitForIt + "kill -HUP $child; wait $child");
  EXPECT_EQ(stopped.status, 129) << stopped.err;
  EXPECT_NE(stopped.err.find("run study.toml --output run --threads 1"), std::string::npos) << stopped.err;
}

TEST_F(RunProgram, UnderNohupAClosedTerminalDoesNotEndIt) {
  write_sweep("2.0", 4);
  const Answer answer = shell("nohup " + started("run study.toml --threads 1 --output run 2>/dev/null") +
                              kWaitForIt + "kill -HUP $child; wait $child");
  EXPECT_EQ(answer.status, 0) << answer.err;
}

TEST_F(RunProgram, AFileThatMayNotGrowIsAnErrorOfWritingWithItsPath) {
  write_sweep("0.5", 200);
  const Answer answer = shell("ulimit -f 8; " + quoted(UNBRUISED_PROGRAM) + " run study.toml --output run");
  EXPECT_EQ(answer.status, 5) << answer.err;
  EXPECT_NE(answer.err.find("run/"), std::string::npos) << answer.err;
}

TEST_F(RunProgram, TakesTheThreadsThatItsAffinityLeaves) {
  write_sweep("0.5", 2);
  const Answer answer = shell("taskset -c 0 " + quoted(UNBRUISED_PROGRAM) + " run study.toml");
  EXPECT_NE(answer.out.find(" on 1 thread\n"), std::string::npos) << answer.out << answer.err;
}

TEST_F(RunProgram, AResultsFileThatAnotherProgramWritesIsInUseNotDamaged) {
  write_sweep("0.5", 2);
  ASSERT_EQ(call("run study.toml --output run").status, 0);
  const Answer answer = shell("flock --exclusive run/results.h5 " + quoted(UNBRUISED_PROGRAM) + " info run");
  EXPECT_EQ(answer.status, 4) << answer.err;
  EXPECT_NE(answer.err.find("is in use"), std::string::npos) << answer.err;
  EXPECT_EQ(answer.err.find("damaged"), std::string::npos) << answer.err;
}

TEST_F(RunProgram, ASecondInterruptEndsItAtOnce) {
  write_sweep("100000.0", 4);  // a batch of minutes
  const Answer stopped = shell(started("run study.toml --threads 1 --output run") + kWaitForIt +
                               "kill -INT $child; sleep 0.1; kill -INT $child; wait $child");
  EXPECT_EQ(stopped.status, 130) << stopped.err;
  EXPECT_NE(stopped.err.find("once more ends at once"), std::string::npos) << stopped.err;
}

TEST_F(RunProgram, ASecondProcessEndsWith4AndReadersDoNotMind) {
  write_sweep("100000.0", 4);
  const Answer second =
      shell(started("run study.toml --threads 1 --output run 2>/dev/null") + kWaitForIt + "status=0; " +
            quoted(UNBRUISED_PROGRAM) + " run study.toml --output run || status=$?; " + quoted(UNBRUISED_PROGRAM) +
            " info run || status=99; echo \"pid = $child\"; kill -9 $child; "
            "exit $status");
  EXPECT_EQ(second.status, 4) << second.err;
  EXPECT_NE(second.err.find("pid = " + line_after(second.out, "pid = ")), std::string::npos) << second.err;
  EXPECT_NE(second.out.find("not complete"), std::string::npos) << second.out;
}

TEST_F(RunProgram, DamagedResultsEndInfoWith6AndAreWrittenAnew) {
  write_sweep("0.5", 3);
  const std::string digest = line_after(call("run study.toml --output run").out, "digest ");
  std::filesystem::resize_file(folder_ / "run/results.h5", 3000);
  const Answer info = call("info run");
  EXPECT_EQ(info.status, 6) << info.err;
  EXPECT_NE(info.err.find("the journal holds 3 whole scenarios"), std::string::npos) << info.err;
  EXPECT_EQ(call("verify run").status, 6);
  const Answer again = call("run study.toml --output run");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(line_after(again.out, "digest "), digest);
  EXPECT_EQ(call("verify run").status, 0);
}

TEST_F(RunProgram, SaysThatNobodyCouldReadWhatItPrinted) {
  write_sweep("0.5", 2);
  ASSERT_EQ(call("run study.toml --output run").status, 0);
  const Answer answer = shell(quoted(UNBRUISED_PROGRAM) + " info run >/dev/full");
  EXPECT_EQ(answer.status, 5) << answer.err;
}

TEST_F(RunProgram, RefusesAProductThatDoesNotFitIntoMemory) {
#ifdef UNBRUISED_SANITIZER
  GTEST_SKIP() << "sanitizers need more address space than this test leaves";
#endif
  const std::string study = quoted(UNBRUISED_SOURCE_DIR "/configs/kiwi_sweep.toml");
  for (const std::string command : {" check ", " run "}) {
    // About 260,000 particles: some 15 GB for the factor.
    const Answer answer = shell("ulimit -v 4000000; " + quoted(UNBRUISED_PROGRAM) + command + study +
                                " --set product.cell_size_m=0.0007");
    EXPECT_EQ(answer.status, 2) << answer.out << answer.err;
    EXPECT_NE(answer.err.find("this machine gives 4.1 GB"), std::string::npos) << answer.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "results"));
}

TEST_F(RunProgram, SaysWhereItCannotWrite) {
  write_sweep("0.5", 2);
  write("file", "");
  const Answer answer = call("run study.toml --output file/run");
  EXPECT_EQ(answer.status, 5) << answer.err;
  EXPECT_NE(answer.err.find("file"), std::string::npos);
}

}  // namespace
}  // namespace unbruised::studies
