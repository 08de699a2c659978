#include <unistd.h>

#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

/// Two masses between springs: runs in milliseconds.
constexpr const char* kNetwork = R"([product]
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
[cell]
gravity_m_s2 = [0.0, 0.0, 0.0]
support = false
)";

class RunProgram : public testing::ProgramTest {
 protected:
  void write_network(const std::string& kind, const std::string& vary, const std::string& duration_s) const {
    std::string network = kNetwork;
    network.insert(network.find("[cell]"), "duration_s = " + duration_s + "\n");
    write("study.toml", "[study]\nname = \"masses\"\nkind = \"" + kind + "\"\n" + network + vary);
  }
  void write_sweep(const std::string& duration_s, int count) const {
    write_network("sweep",
                  "[[vary]]\nkey = \"product.spring[0].stiffness_N_m\"\nfrom = 40.0\nto = 60.0\ncount = " +
                      std::to_string(count) + "\n",
                  duration_s);
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
  const Answer stopped = shell("timeout --preserve-status -s INT 0.4 " + quoted(UNBRUISED_PROGRAM) +
                               " run study.toml --threads 1 --output run");
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

TEST_F(RunProgram, SaysWhereItCannotWrite) {
  write_sweep("0.5", 2);
  write("file", "");
  const Answer answer = call("run study.toml --output file/run");
  EXPECT_EQ(answer.status, 5) << answer.err;
  EXPECT_NE(answer.err.find("file"), std::string::npos);
}

}  // namespace
}  // namespace unbruised::studies
