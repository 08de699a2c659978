// A study run by several processes that mpirun has started: the digest of one process, and what a kill costs.

#include <unistd.h>

#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

class Ranks : public testing::ProgramTest {
 protected:
  void SetUp() override {
    testing::ProgramTest::SetUp();
    write("study.toml", testing::two_masses_sweep("1.0", 40));
  }
  /// As root and with more ranks than cores too, on this machine alone.
  [[nodiscard]] static std::string mpirun(int ranks) {
    return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe --bind-to none "
           "--mca btl self,vader --mca plm isolated --mca oob_tcp_if_include lo -n " +
           std::to_string(ranks) + " " + quoted(UNBRUISED_PROGRAM) + " ";
  }
  [[nodiscard]] std::string digest_of_one_process(const std::string& study = "study.toml") const {
    const Answer whole = call("run " + study + " -q --no-replay -o whole");
    EXPECT_EQ(whole.status, 0) << whole.err;
    return line_after(whole.out, "digest ");
  }
};

TEST_F(Ranks, TwoEndWithTheDigestOfOneProcess) {
  const Answer two = shell(mpirun(2) + "run study.toml -q -j 1 --no-replay -o run");
  ASSERT_EQ(two.status, 0) << two.err;
  EXPECT_NE(two.err.find("2 ranks"), std::string::npos) << two.err;
  EXPECT_NE(two.out.find("40 scenarios, 40 run now"), std::string::npos) << two.out;
  EXPECT_EQ(two.out.find("digest "), two.out.rfind("digest ")) << "one rank speaks";
  EXPECT_EQ(line_after(two.out, "digest "), digest_of_one_process());
  EXPECT_EQ(call("verify run").status, 0);
}

TEST_F(Ranks, AllEndWhereTheStudyIsWrong) {
  const Answer wrong = shell(mpirun(2) + "run study.toml -q -o run --set simulation.theta=0.5");
  EXPECT_EQ(wrong.status, 2) << wrong.err;
  EXPECT_NE(wrong.err.find("simulation.theta"), std::string::npos) << wrong.err;
}

TEST_F(Ranks, RefuseWhatOneProcessDoes) {
  for (const char* words : {"run study.toml --shard 1/2", "run study.toml --scenario 3", "merge run"}) {
    const Answer refused = shell(mpirun(2) + words);
    EXPECT_EQ(refused.status, 2) << words;
    EXPECT_NE(refused.err.find("is for one process, without mpirun"), std::string::npos) << refused.err;
  }
}

/// Every kind of study that asks in its own way, on coarse blocks.
TEST_F(Ranks, OneTwoAndFourSearchAlike) {
  const std::string search = testing::coarse_block("s") + R"([[variable]]
key = "strategy.grip_force_N"
from = 1.0
to = 4.0
[search]
objective = "cycle_time_s"
constraints = ["held"]
starts = 4
budget = 24
)";
  write("search.toml", search);
  const std::string kind = " --set study.kind=optimize";
  const Answer alone = call("run search.toml -q --no-replay -o whole" + kind);
  ASSERT_EQ(alone.status, 0) << alone.err;
  for (const int ranks : {1, 2, 4}) {
    const std::string directory = "ranks" + std::to_string(ranks);
    const Answer together = shell(mpirun(ranks) + "run search.toml -q -j 1 --no-replay -o " + directory + kind);
    ASSERT_EQ(together.status, 0) << together.err;
    EXPECT_EQ(line_after(together.out, "digest "), line_after(alone.out, "digest ")) << ranks;
  }
}

/// Ends one rank of four again and again; what was answered stays, and the same command goes on.
TEST_F(Ranks, OfWhomOneIsKilledGoOnWithTheSameCommand) {
  write("study.toml", testing::two_masses_sweep("400.0", 60));
  const std::string words = mpirun(4) + "run study.toml -q -j 1 --no-replay -o run";
  // The youngest child of mpirun that is this program, once rows are in the journal; it is ended by its number.
  const std::string killed_once =
      words +
      " & parent=$!; while [ -z \"$(find run/journal -name '*.jrnl' -size +2k 2>/dev/null)\" ]; do sleep 0.02; "
      "kill -0 $parent 2>/dev/null || break; done; "
      "victim=$(ps -o pid= --ppid $parent | tail -n 1); kill -9 $victim; wait $parent; exit $?";
  const Answer killed = shell(killed_once);
  EXPECT_NE(killed.status, 0);
  const Answer again = shell(words);
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(again.out.find("60 scenarios, 60 run now"), std::string::npos) << "all was run again: " << again.out;
  EXPECT_EQ(line_after(again.out, "digest "), digest_of_one_process());
  EXPECT_EQ(call("verify run").status, 0);
}

}  // namespace
}  // namespace unbruised::studies
