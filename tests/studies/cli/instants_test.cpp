// Numbers of one scenario at any time, and what the contact state register tells of it: info --at, info, export.
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

using nlohmann::json;

/// Two scenarios.
const std::string kStudy = testing::coarse_block("two") + R"([[vary]]
key = "strategy.grip_force_N"
values = [2.0, 4.0]
)";

class Instants : public testing::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("study.toml", kStudy);
    ASSERT_EQ(call("run -q study.toml -j 1 --set simulation.levels=off").status, 0);
  }
  /// With a row for every step.
  void record() const { ASSERT_EQ(call("run study.toml --scenario 1 --set simulation.levels=off").status, 0); }
  void expect_refused(const std::string& words, const std::string& sentence) const {
    const Answer answer = call(words);
    EXPECT_EQ(answer.status, 2) << words;
    EXPECT_NE(answer.err.find(sentence), std::string::npos) << words << ": " << answer.err;
    EXPECT_TRUE(answer.out.empty()) << answer.out;
  }
  [[nodiscard]] json at(const std::string& time) const {
    const Answer answer = call("info results/two --scenario 1 --at " + time + " --json");
    EXPECT_EQ(answer.status, 0) << answer.err;
    return json::parse(answer.out);
  }
  static double value(const json& instant, const std::string& signal, std::size_t curve = 0) {
    return instant["signals"][signal]["curves"][curve]["value"].get<double>();
  }
};

TEST_F(Instants, SayWhichCommandMakesATraceThatIsNotThere) {
  const Answer answer = call("info results/two --scenario 1 --at 0.3");
  EXPECT_EQ(answer.status, 2);
  const std::string makes = "this makes it: ";
  const std::size_t from = answer.err.find(makes);
  ASSERT_NE(from, std::string::npos) << answer.err;
  // The command does what it says.
  ASSERT_EQ(shell(answer.err.substr(from + makes.size())).status, 0) << answer.err;
  EXPECT_EQ(call("info results/two --scenario 1 --at 0.3").status, 0);
}

TEST_F(Instants, LieOnAStraightLineBetweenTheirRows) {
  record();
  const json before = at("0.6"), between = at("0.6005"), after = at("0.602");
  EXPECT_EQ(before["schema"], "unbruised.instant/1");
  EXPECT_EQ(before["row_times_s"], json({0.6, 0.6}));
  EXPECT_NEAR(between["row_times_s"][0].get<double>(), 0.6, 1e-12);
  EXPECT_NEAR(between["row_times_s"][1].get<double>(), 0.602, 1e-12);
  for (const char* signal : {"finger_force_N", "stored_energy_J", "palm_position_m"}) {
    for (std::size_t i = 0; i < before["signals"][signal]["curves"].size(); ++i) {
      const double wanted = 0.75 * value(before, signal, i) + 0.25 * value(after, signal, i);
      EXPECT_NEAR(value(between, signal, i), wanted, 1e-12 + 1e-9 * std::abs(wanted)) << signal << i;
    }
  }
  // What is counted is that of the row before.
  for (const char* signal : {"phase", "contact_count"}) {
    EXPECT_FALSE(between["signals"][signal]["interpolated"].get<bool>());
    EXPECT_EQ(value(between, signal), value(before, signal));
  }
  const Answer lines = call("info results/two --scenario 1 --at 0.6005");
  EXPECT_NE(lines.out.find("between the rows at 0.6 s and 0.602 s"), std::string::npos) << lines.out;
  EXPECT_NE(lines.out.find("  finger_force_N [finger 1, x] = "), std::string::npos) << lines.out;
  EXPECT_NE(lines.out.find("  phase = "), std::string::npos) << lines.out;
  // The file itself will do.
  EXPECT_EQ(call("info results/two/scenario_1.h5 --at 0.6005").out, lines.out);
}

TEST_F(Instants, RefuseWhatTheyCannotShow) {
  record();
  expect_refused("info results/two --scenario 1 --at 99", "--at 99: must be 0 to ");
  expect_refused("info results/two --scenario 1 --at=-0.1", "--at -0.1: must be 0 to ");
  expect_refused("info results/two --scenario 1 --at nan", "--at nan: must be 0 to ");
  expect_refused("info results/two --scenario 1 --at soon", "--at");
  expect_refused("info results/two --scenario 1", "--scenario ID goes with --at TIME");
  expect_refused("info results/two --at 0.3", "--scenario ID picks one");
  expect_refused("info results/two --scenario -1 --at 0.3", "ids begin with 0");
  expect_refused("info results/two/results.h5 --at 0.3", "holds no trace");
  expect_refused("info results/two/scenario_1.h5 --scenario 0 --at 0.3", "another scenario");
}

TEST_F(Instants, ContactsAreSummarisedPerSurface) {
  record();
  const Answer info = call("info results/two/scenario_1.h5");
  const std::string line = line_after(info.out, "contacts of left pad: ");
  EXPECT_NE(line.find(" makes, "), std::string::npos) << info.out;
  EXPECT_NE(line.find("at longest for "), std::string::npos) << info.out;
  const json contacts = json::parse(call("info results/two/scenario_1.h5 --json").out)["tables"]["contacts"];
  ASSERT_EQ(contacts["rows"].size(), 3U);
  const json& support = contacts["rows"][2];
  EXPECT_EQ(support["surface"], "support");
  EXPECT_EQ(support["first_contact_s"], 0.0) << "it stands there";
  EXPECT_GT(support["make_count"].get<double>(), support["break_count"].get<double>()) << "and stands there again";
  EXPECT_NE(call("export results/two/scenario_1.h5 --table contacts -o -").out.find("left pad,"),
            std::string::npos);
  EXPECT_NE(text_of("results/two/scenario_1.html").find("contacts"), std::string::npos);
}

}  // namespace
}  // namespace unbruised::studies
