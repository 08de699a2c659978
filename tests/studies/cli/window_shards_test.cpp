// A window study run in parts: each takes whole combinations, and all together end with the digest, the windows
// and the words of one process.

#include <unistd.h>

#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

/// Two products at three speeds: six combinations in two factor groups.
const std::string kWindow =
    "[window]\nfrom_N = 0.2\nto_N = 40.0\ntolerance = 0.02\n[[vary]]\nkey = \"product.youngs_modulus_Pa\"\nvalues "
    "= [1e6, 2e6]\n"
    "[[vary]]\nkey = \"strategy.approach_speed_m_s\"\nvalues = [0.02, 0.05, 0.1]\n";

class WindowShards : public testing::ProgramTest {
 protected:
  void SetUp() override {
    testing::ProgramTest::SetUp();
    std::string text = testing::coarse_block("w") + kWindow;
    text.replace(text.find("sweep"), 5, "window");
    write("study.toml", text);
  }
  /// What a finished run prints, without how long it took and where the files are.
  [[nodiscard]] static std::string findings(const std::string& out) {
    std::istringstream lines(out);
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
      const bool is_its_own = line.find(" run now in ") != std::string::npos || line.starts_with("lanes: ") ||
                              line.starts_with("results: ") || line.starts_with("report: ") ||
                              line.find("--scenario") != std::string::npos;
      if (!is_its_own) kept += line + "\n";
    }
    return kept;
  }
  [[nodiscard]] std::string of_one_process(const std::string& options = "") const {
    const Answer whole = call("run study.toml -q --no-replay -o whole" + options);
    EXPECT_EQ(whole.status, 0) << whole.err;
    EXPECT_EQ(call("export whole -o whole.csv").status, 0);
    return findings(whole.out);
  }
  [[nodiscard]] Answer run_part(const std::string& part, const std::string& directory = "run",
                                const std::string& options = "") const {
    return call("run study.toml -q -o " + directory + " --shard " + part + options);
  }
  void expect_as_of_one_process(const Answer& merged, const std::string& directory,
                                const std::string& options = "") const {
    EXPECT_EQ(merged.status, 0) << merged.err;
    EXPECT_EQ(findings(merged.out), of_one_process(options));
    EXPECT_EQ(call("export " + directory + " -o parts.csv").status, 0);
    EXPECT_EQ(text_of("parts.csv"), text_of("whole.csv"));
    const Answer verified = call("verify " + directory);
    EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  }
};

TEST_F(WindowShards, EndAsOneProcessAndMissingCombinationsAreNamedWithWhatRunsJustThem) {
  const std::string program = quoted(UNBRUISED_PROGRAM) + " run study.toml -q -j 1 -o run --shard ";
  const Answer both =
      shell(program + "1/3 & first=$!; " + program + "2/3; second=$?; wait $first && exit $second");
  ASSERT_EQ(both.status, 0) << both.err;
  EXPECT_NE(both.out.find("part 1 of 3, 2 combinations, "), std::string::npos) << both.out;
  const Answer early = call("merge run");
  EXPECT_EQ(early.status, 3);
  EXPECT_NE(early.err.find("2 combinations are missing (4 to 5)"), std::string::npos) << early.err;
  EXPECT_FALSE(fs::exists(folder_ / "run/results.h5"));
  const std::size_t command = early.err.find("  " + quoted(UNBRUISED_PROGRAM).substr(1, 5));
  ASSERT_NE(command, std::string::npos) << early.err;
  const Answer rest =
      shell(early.err.substr(command, early.err.find('\n', command) - command) + " -q --no-replay");
  expect_as_of_one_process(rest, "run");
}

TEST_F(WindowShards, OverlapAndOtherNumbersOfPartsChangeNothing) {
  EXPECT_EQ(run_part("2/2").status, 0);
  const Answer overlapping = run_part("2/3");
  EXPECT_NE(overlapping.out.find("part 2 of 3, 2 combinations, "), std::string::npos) << overlapping.out;
  EXPECT_NE(run_part("2/3").out.find(" 0 scenarios run now"), std::string::npos);
  EXPECT_EQ(run_part("3/9").status, 0);  // more parts than combinations
  EXPECT_EQ(run_part("1/4").status, 0);
  EXPECT_EQ(run_part("1/3").status, 0);
  expect_as_of_one_process(call("merge run -q"), "run");
}

TEST_F(WindowShards, OfSeveralMachinesWithAnotherToleranceComeTogether) {
  const std::string coarse = " --set window.tolerance=0.1";
  EXPECT_EQ(run_part("1/3", "a", coarse).status, 0);
  EXPECT_EQ(run_part("2/3", "b", coarse).status, 0);
  EXPECT_EQ(run_part("3/3", "c", coarse).status, 0);
  EXPECT_EQ(run_part("3/3", "other").status, 0);
  const Answer early = call("merge a b other");
  EXPECT_EQ(early.status, 3);
  EXPECT_NE(early.err.find("other holds another study (window.tolerance); it is left out"), std::string::npos)
      << early.err;
  expect_as_of_one_process(call("merge a c -q"), "a", coarse);
}

TEST_F(WindowShards, KilledOnesGoOn) {
  const std::string slow = " --set simulation.time_step_s=8e-4 -j 1";
  const std::string program = quoted(UNBRUISED_PROGRAM) + " run study.toml -q -o run --shard 1/2" + slow;
  const Answer killed =
      shell(program +
            " & child=$!; while [ ! -d run/journal ] || [ -z \"$(ls run/journal)\" ]; do sleep 0.05; "
            "done; sleep 0.1; kill -9 $child; wait $child; exit $?");
  EXPECT_EQ(killed.status, 137) << "it had ended before it was killed";
  EXPECT_EQ(run_part("1/2", "run", slow).status, 0);
  EXPECT_EQ(run_part("2/2", "run", slow).status, 0);
  expect_as_of_one_process(call("merge run -q"), "run", slow);
}

}  // namespace
}  // namespace unbruised::studies
