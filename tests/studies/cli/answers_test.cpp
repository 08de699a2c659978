// What other programs read: info --json, check --json, export.
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

using nlohmann::json;

/// Four scenarios.
const std::string kStudy = testing::coarse_block("four") + R"([[vary]]
key = "strategy.grip_force_N"
values = [0.5, 4.0]
[[vary]]
key = "strategy.profile"
values = ["trapezoid", "minimum_jerk"]
)";

class Answers : public testing::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("study.toml", kStudy);
  }
  void run() const { ASSERT_EQ(call("run -q study.toml -j 1").status, 0); }
};

TEST_F(Answers, InfoAsJsonSaysWhatItsLinesSay) {
  run();
  const Answer lines = call("info results/four");
  const Answer answer = call("info results/four --json");
  ASSERT_EQ(answer.status, 0) << answer.err;
  const json info = json::parse(answer.out);
  EXPECT_EQ(info["schema"], "unbruised.info/1");
  EXPECT_EQ(info["study"]["name"], "four");
  EXPECT_EQ(info["study"]["scenarios_run"], 4);
  EXPECT_EQ(info["digest"], line_after(lines.out, "digest "));
  EXPECT_EQ(info["varied"], json({"strategy.grip_force_N", "strategy.profile"}));
  int outcomes = 0;
  for (const auto& [word, count] : info["outcomes"].items()) outcomes += count.get<int>();
  EXPECT_EQ(outcomes, 4);
  for (const auto& line : info["answer"]) {
    EXPECT_NE(lines.out.find(line.get<std::string>()), std::string::npos) << line;
  }
  ASSERT_EQ(info["window"]["rows"].size(), 2U) << info["window"];
  EXPECT_EQ(info["window"]["rows"][0]["strategy.profile"], "trapezoid");
  EXPECT_EQ(info["window"]["columns"]["hold_force_N"]["units"], "N");
}

TEST_F(Answers, CheckAsJsonSaysWhatItCostsOrWhatIsWrong) {
  const Answer answer = call("check study.toml --json");
  ASSERT_EQ(answer.status, 0) << answer.err;
  const json check = json::parse(answer.out);
  EXPECT_EQ(check["schema"], "unbruised.check/1");
  EXPECT_TRUE(check["valid"].get<bool>());
  EXPECT_EQ(check["scenarios"]["count"], 4);
  EXPECT_TRUE(check["scenarios"]["exact"].get<bool>());
  EXPECT_GT(check["estimate"]["seconds"].get<double>(), 0.0);
  EXPECT_TRUE(check["warnings"].is_array());

  const Answer wrong = call("check study.toml --json --set product.mas_kg=1");
  EXPECT_EQ(wrong.status, 2);
  const json problems = json::parse(wrong.out);
  EXPECT_FALSE(problems["valid"].get<bool>());
  EXPECT_NE(problems["problems"][0].get<std::string>().find("product.mass_kg"), std::string::npos) << problems;
}

TEST_F(Answers, ExportIsOneFlatTableOfNaturalTypes) {
  run();
  const Answer answer = call("export results/four");
  ASSERT_EQ(answer.status, 0) << answer.err;
  const std::string csv = text_of("results/four/scenarios.csv");
  EXPECT_TRUE(
      csv.starts_with("id,outcome,cause,outcome_time_s,strategy.grip_force_N,strategy.profile,"
                      "permanent_set_max_m,"))
      << csv.substr(0, 200);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_NE(csv.find("\n3,"), std::string::npos);
  EXPECT_NE(csv.find(",4,minimum_jerk,"), std::string::npos) << csv;
  const Answer windows = call("export results/four --table window -o -");
  EXPECT_TRUE(windows.out.starts_with("strategy.profile,hold_force_N,")) << windows.out;
}

TEST_F(Answers, ExportOpensInPandasWithNaturalTypes) {
  run();
  ASSERT_EQ(call("export results/four -o table.csv").status, 0);
  const Answer python = shell(
      "/usr/bin/python3 -c \"import pandas; t = pandas.read_csv('table.csv', index_col='id'); "
      "print(t.outcome.dtype, t['strategy.grip_force_N'].dtype, t.cycle_time_s.dtype, len(t))\"");
  if (python.err.find("No module named") != std::string::npos) GTEST_SKIP() << "no pandas here";
  EXPECT_EQ(python.out, "object float64 float64 4\n") << python.err;
}

TEST_F(Answers, ExportSaysWhichTablesAndFormatsThereAre) {
  run();
  EXPECT_NE(call("export results/four --table pareto").err.find("holds the tables scenarios, window"),
            std::string::npos);
  const Answer parquet = call("export results/four --format parquet");
  EXPECT_EQ(parquet.status, 2);
  EXPECT_NE(parquet.err.find("read_csv"), std::string::npos) << parquet.err;
  EXPECT_NE(call("export results/four --scenario 1").err.find("--scenario 1"), std::string::npos);
}

TEST_F(Answers, OneScenarioLeavesAThinTraceAPageAndTheSameBits) {
  run();
  const Answer one = call("run study.toml --scenario 3");
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_NE(one.err.find("before compression"), std::string::npos) << one.err;
  EXPECT_NE(one.err.find("same bits as the recorded row"), std::string::npos) << one.err;
  EXPECT_TRUE(text_of("results/four/scenario_3.html").starts_with("<!doctype html>"));
  EXPECT_EQ(line_after(one.out, "  cycle_time_s = ").size(), 5U) << one.out;  // four digits and a point
  ASSERT_EQ(call("export results/four --scenario 3").status, 0);
  const std::string trace = text_of("results/four/scenario_3.csv");
  EXPECT_TRUE(trace.starts_with("time_s,")) << trace.substr(0, 100);

  // A step so small that every second one is left out, and all of them when asked.
  const std::string fine =
      "run study.toml -o fine --scenario 3 --set simulation.time_step_s=5e-4 --set simulation.levels=off";
  ASSERT_EQ(call(fine).status, 0);
  ASSERT_EQ(call("export fine --scenario 3 -o thin.csv").status, 0);
  const Answer whole = call(fine + " --full-trace");
  ASSERT_EQ(whole.status, 0) << whole.err;
  ASSERT_EQ(call("export fine --scenario 3 -o whole.csv").status, 0);
  const auto rows = [&](const std::string& file) {
    const std::string text = text_of(file);
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_LE(rows("thin.csv"), 2002);
  EXPECT_GT(rows("whole.csv"), 2 * (rows("thin.csv") - 2));
  EXPECT_EQ(call("run study.toml --full-trace").status, 2);
}

}  // namespace
}  // namespace unbruised::studies
