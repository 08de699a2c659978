// A study run in parts, by several processes, in one directory or several: it ends with the digest of one process.

#include <unistd.h>

#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

class Shards : public testing::ProgramTest {
 protected:
  void SetUp() override {
    testing::ProgramTest::SetUp();
    write_sweep("1.0");
  }
  void write_sweep(const std::string& duration_s) {
    write("study.toml", testing::two_masses_sweep(duration_s, 40));
  }
  [[nodiscard]] std::string digest_of_one_process() const {
    const Answer whole = call("run study.toml -q --no-replay -o whole");
    EXPECT_EQ(whole.status, 0) << whole.err;
    return line_after(whole.out, "digest ");
  }
  [[nodiscard]] Answer run_part(const std::string& part, const std::string& directory = "run") const {
    return call("run study.toml -q -o " + directory + " --shard " + part);
  }
};

TEST_F(Shards, SideBySideInOneDirectoryEndWithTheDigestOfOneProcess) {
  const std::string program = quoted(UNBRUISED_PROGRAM) + " run study.toml -q -o run --shard ";
  const Answer both =
      shell(program + "1/3 & first=$!; " + program + "2/3; second=$?; wait $first && exit $second");
  ASSERT_EQ(both.status, 0) << both.err;
  EXPECT_NE(both.out.find("part 1 of 3, 13 scenarios, 13 run now"), std::string::npos) << both.out;

  const Answer early = call("merge run");
  EXPECT_EQ(early.status, 3);
  EXPECT_NE(early.err.find("14 scenarios are missing (26 to 39)"), std::string::npos) << early.err;
  EXPECT_FALSE(fs::exists(folder_ / "run/results.h5"));
  // The command that it names runs just them and ends the study.
  const std::size_t command = early.err.find("  " + quoted(UNBRUISED_PROGRAM).substr(1, 5));
  ASSERT_NE(command, std::string::npos) << early.err;
  const Answer rest = shell(early.err.substr(command, early.err.find('\n', command) - command));
  EXPECT_EQ(rest.status, 0) << rest.err;
  EXPECT_NE(rest.out.find("40 scenarios, 14 run now"), std::string::npos) << rest.out;
  EXPECT_EQ(line_after(rest.out, "digest "), digest_of_one_process());
  EXPECT_EQ(call("verify run").status, 0);
}

TEST_F(Shards, OverlapAndOtherNumbersOfPartsChangeNothing) {
  EXPECT_EQ(run_part("2/2").status, 0);
  const Answer overlapping = run_part("2/3");
  EXPECT_NE(overlapping.out.find("part 2 of 3, 13 scenarios, 7 run now"), std::string::npos) << overlapping.out;
  EXPECT_NE(run_part("2/3").out.find(" 0 run now"), std::string::npos);
  EXPECT_EQ(run_part("1/3").status, 0);
  EXPECT_EQ(run_part("41/60").status, 0);  // more parts than scenarios
  const Answer merged = call("merge run -q");
  EXPECT_EQ(merged.status, 0) << merged.err;
  EXPECT_EQ(line_after(merged.out, "digest "), digest_of_one_process());
  // What is finished stays as it is.
  EXPECT_NE(run_part("1/2").err.find("holds this study, finished"), std::string::npos);
}

TEST_F(Shards, OfSeveralMachinesComeTogetherAndWhatIsDamagedCostsOnlyItself) {
  EXPECT_EQ(run_part("1/4", "a").status, 0);
  EXPECT_EQ(run_part("2/4", "b").status, 0);
  EXPECT_EQ(run_part("3/4", "b").status, 0);
  EXPECT_EQ(run_part("4/4", "c").status, 0);
  EXPECT_EQ(call("run study.toml -q -o other --shard 1/1 --set product.particle[1].mass_kg=3.0").status, 0);
  // A byte in the middle of the last part.
  fs::path journal;
  for (const auto& entry : fs::directory_iterator(folder_ / "c/journal")) journal = entry.path();
  std::fstream file(journal, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(fs::file_size(journal) / 2));
  file.put('\x55');
  file.close();

  const Answer merged = call("merge a b c other nowhere");
  EXPECT_EQ(merged.status, 3) << merged.out;
  EXPECT_NE(merged.err.find("other holds another study (product.particle[1].mass_kg); it is left out"),
            std::string::npos)
      << merged.err;
  EXPECT_NE(merged.err.find("nowhere holds no run directory; it is left out"), std::string::npos) << merged.err;
  EXPECT_NE(merged.err.find("is damaged"), std::string::npos) << merged.err;
  EXPECT_NE(merged.err.find("1 scenario is missing ("), std::string::npos) << merged.err;
  EXPECT_EQ(run_part("4/4", "a").status, 0);
  const Answer again = call("merge a -q");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(line_after(again.out, "digest "), digest_of_one_process());
}

TEST_F(Shards, KilledOnesGoOn) {
  write_sweep("100.0");
  const std::string program = quoted(UNBRUISED_PROGRAM) + " run study.toml -q -j 1 -o run --shard ";
  const Answer killed =
      shell(program + "1/2 & child=$!; while [ ! -d run/journal ]; do sleep 0.05; done; sleep 0.2; " +
            "kill -9 $child; wait $child; exit $?");
  EXPECT_EQ(killed.status, 137);
  EXPECT_EQ(run_part("1/2").status, 0);
  EXPECT_EQ(run_part("2/2").status, 0);
  const Answer merged = call("merge run -q");
  EXPECT_EQ(merged.status, 0) << merged.err;
  EXPECT_EQ(line_after(merged.out, "digest "), digest_of_one_process());
}

TEST_F(Shards, KeepOutAWholeRunAndItKeepsThemOut) {
  write_sweep("2000.0");
  // The first has the directory, and its lock, before the second begins.
  const auto status_of_second = [&](const std::string& directory, const std::string& first,
                                    const std::string& second) {
    const std::string program = quoted(UNBRUISED_PROGRAM) + " run study.toml -q -j 1 -o " + directory;
    return shell(program + first + " & child=$!; while [ ! -d " + directory + "/journal ]; do sleep 0.05; done; " +
                 program + second + "; status=$?; kill -9 $child; wait $child; exit $status")
        .status;
  };
  EXPECT_EQ(status_of_second("parts", " --shard 1/2", ""), 4);
  EXPECT_EQ(status_of_second("whole", "", " --shard 2/2"), 4);
}

TEST_F(Shards, RefuseWhatMakesNoSense) {
  for (const char* part : {"0/3", "4/3", "1", "a/b", "1/0", "-1/3", "1/3/5"}) {
    const Answer answer = run_part(part);
    EXPECT_EQ(answer.status, 2) << part;
    EXPECT_NE(answer.err.find("must be I/N"), std::string::npos) << part << ": " << answer.err;
  }
  EXPECT_NE(call("run study.toml --shard 1/2 --fresh").err.find("goes neither with"), std::string::npos);
  EXPECT_EQ(call("merge").status, 2);
  EXPECT_NE(call("merge nowhere").status, 0);
  write("search.toml",
        testing::coarse_block("s") +
            "[search]\nobjective = \"cycle_time_s\"\n[[variable]]\nkey = \"strategy.grip_force_N\"\n"
            "from = 1.0\nto = 4.0\n");
  const Answer search = call("run search.toml --shard 1/2 --set study.kind=optimize");
  EXPECT_EQ(search.status, 2);
  EXPECT_NE(search.err.find(
                "study.kind = \"optimize\": asks for one scenario after the answer of another and has no parts"),
            std::string::npos)
      << search.err;
}

}  // namespace
}  // namespace unbruised::studies
