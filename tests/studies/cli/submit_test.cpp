// The jobs of a study for Slurm, with stand-ins for its commands; tests/cluster has a real one.

#include <unistd.h>

#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

class Submit : public testing::ProgramTest {
 protected:
  void SetUp() override {
    testing::ProgramTest::SetUp();
    write("study.toml", testing::two_masses_sweep("1.0", 40));
    fs::create_directory(folder_ / "bin");
    stand_in("scontrol", "echo 'MaxArraySize            = 21'");
    // Runs the array's tasks one after the other, and says a number.
    stand_in("sbatch",
             "for script; do :; done\n"
             "export SLURM_CPUS_PER_TASK=1 SLURM_ARRAY_JOB_ID=7\n"
             "for task in $(sed -n 's/^#SBATCH --array=1-//p' \"$script\" | xargs -r seq); do "
             "SLURM_ARRAY_TASK_ID=$task bash \"$script\" >>tasks.log 2>&1; done\n"
             "case \"$script\" in *merge.sh) bash \"$script\" >merge.log 2>&1; echo \"$@\" >merge_words; echo 8 "
             ";; *) echo '7;here' ;; esac");
  }
  void stand_in(const std::string& name, const std::string& text) const {
    write("bin/" + name, "#!/bin/bash\n" + text + "\n");
    fs::permissions(folder_ / "bin" / name, fs::perms::owner_all);
  }
  [[nodiscard]] Answer submit(const std::string& words) const {
    return shell("PATH=\"$PWD/bin:$PATH\" " + quoted(UNBRUISED_PROGRAM) + " submit study.toml " + words);
  }
};

TEST_F(Submit, HandsInAnArrayAndAMergeBehindItThatEndWithTheDigestOfOneProcess) {
  const Answer answer = submit(
      "--slurm --tasks 3 --cpus 2 --partition long --time 04:00:00 -o 'my run' --now "
      "--set product.particle[1].mass_kg=3.0");
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_NE(answer.out.find("masses: 3 tasks of 2 cores"), std::string::npos) << answer.out;
  EXPECT_NE(answer.out.find("jobs 7 (3 tasks) and 8 (merge)"), std::string::npos) << answer.out;
  EXPECT_NE(text_of("merge_words").find("--dependency=afterany:7 "), std::string::npos) << text_of("merge_words");
  const std::string array = text_of("my run.slurm/array.sh");
  for (const char* line : {"#SBATCH --array=1-3\n", "#SBATCH --cpus-per-task=2\n", "#SBATCH --partition=long\n",
                           "#SBATCH --time=04:00:00\n", "#SBATCH --requeue\n"}) {
    EXPECT_NE(array.find(line), std::string::npos) << line << array;
  }
  const Answer whole = call("run study.toml -q --no-replay -o whole --set product.particle[1].mass_kg=3.0");
  EXPECT_EQ(line_after(text_of("merge.log"), "digest "), line_after(whole.out, "digest ")) << text_of("merge.log");
}

TEST_F(Submit, WritesOnlyAndChoosesFewTasksByItself) {
  const Answer answer = submit("--slurm -o run");
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_NE(answer.out.find("masses: 1 task of 8 cores"), std::string::npos) << answer.out;
  EXPECT_NE(answer.err.find("run.slurm/submit.sh"), std::string::npos) << answer.err;
  EXPECT_FALSE(fs::exists(folder_ / "run"));
  EXPECT_EQ(text_of("run.slurm/array.sh").find("--time"), std::string::npos);
}

TEST_F(Submit, KeepsWithinWhatSlurmTakesAndRefusesWhatMakesNoSense) {
  EXPECT_EQ(submit("--slurm --tasks 20 -o run").status, 0);
  const Answer many = submit("--slurm --tasks 21");
  EXPECT_EQ(many.status, 2);
  EXPECT_NE(many.err.find("--tasks = 21: must be 1 to 20"), std::string::npos) << many.err;
  EXPECT_NE(submit("").err.find("--slurm is missing"), std::string::npos);
  EXPECT_NE(submit("--slurm --cpus 0").err.find("--cpus = 0: must be 1 to"), std::string::npos);
  EXPECT_NE(submit("--slurm --time '1;reboot'").err.find("must be a time"), std::string::npos);
  EXPECT_NE(submit("--slurm --set simulation.theta=0.1").err.find("simulation.theta"), std::string::npos);
  write("study.toml", testing::coarse_block("w") + "[window]\nfrom_N = 1.0\nto_N = 4.0\n");
  const Answer window = submit("--slurm --set study.kind=window -o window");
  EXPECT_NE(window.out.find("w: 1 task of 8 cores"), std::string::npos)
      << "one combination is one task: " << window.out;
  write("study.toml", testing::coarse_block("s") +
                          "[search]\nobjective = \"cycle_time_s\"\n[[variable]]\nkey = \"strategy.grip_force_N\"\n"
                          "from = 1.0\nto = 4.0\n");
  const Answer search = submit("--slurm --set study.kind=optimize");
  EXPECT_EQ(search.status, 2);
  EXPECT_NE(search.err.find("has no parts"), std::string::npos) << search.err;
}

TEST_F(Submit, SaysWhereSlurmTakesNothing) {
  stand_in("sbatch", "echo 'sbatch: error: no partition' >&2; exit 1");
  const Answer answer = submit("--slurm --now -o run");
  EXPECT_EQ(answer.status, 5);
  EXPECT_NE(answer.err.find("sbatch took none of the jobs"), std::string::npos) << answer.err;
}

}  // namespace
}  // namespace unbruised::studies
