#include "studies/config/execution_error.hpp"

#include <array>
#include <cmath>

#include "studies/statistics/distribution.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::errors_of;
using testing::gripped_block;
using testing::search_block;
using testing::study_of;

const std::string kForceError = "[[random]]\nkey = \"strategy.grip_force_N\"\nrelative = 0.1\n";

/// The only message; all of them otherwise.
std::string message_of(const std::string& text) {
  const auto messages = errors_of(text);
  EXPECT_EQ(messages.size(), 1U) << ::testing::PrintToString(messages);
  return messages.empty() ? "" : messages.front();
}

double force_of(const Study& study, const std::vector<std::string>& keys, const std::vector<double>& values) {
  return study.scenario_with(keys, values).strategy.grip_force_N;
}

TEST(ExecutionError, ScattersTheValueThatIsSearched) {
  const Study study = study_of(search_block("robust") + kForceError);
  ASSERT_EQ(study.variables().size(), 1U);
  ASSERT_EQ(study.randoms().size(), 2U);
  EXPECT_EQ(study.randoms()[1].key, "strategy.grip_force_N_relative_error");
  EXPECT_EQ(study.randoms()[1].units, "1");
  EXPECT_FALSE(study.randoms()[1].changes_factor);
  const double force = force_of(study, {"strategy.grip_force_N", study.randoms()[1].key}, {2.0, -0.1});
  EXPECT_DOUBLE_EQ(force, 1.8);  // one rounding of 2 x 0.9
}

TEST(ExecutionError, ScattersTheValueThatIsWrittenAndEachCandidatesOwn) {
  const Study sample = study_of(search_block("sample") + kForceError, {"strategy.grip_force_N=3"});
  EXPECT_DOUBLE_EQ(force_of(sample, {"strategy.grip_force_N_relative_error"}, {0.1}), 3.3);
  const Study compare = study_of(search_block("compare") + kForceError);
  const std::array<std::string, 1> key = {"strategy.grip_force_N_relative_error"};
  const std::array<double, 1> error = {0.1};
  EXPECT_DOUBLE_EQ(Study::with_values(compare.candidates()[0].scenario, key, error).strategy.grip_force_N, 1.1);
  EXPECT_DOUBLE_EQ(Study::with_values(compare.candidates()[1].scenario, key, error).strategy.grip_force_N, 2.2);
}

TEST(ExecutionError, MayBeInTheUnitOfTheKey) {
  const Study study =
      study_of(search_block("sample") +
               "[[random]]\nkey = \"cell.grip_offset_m\"\nabsolute = 0.003\ndistribution = \"normal\"\n");
  const RandomVariable& random = study.randoms().back();
  EXPECT_EQ(random.key, "cell.grip_offset_m_error");
  EXPECT_EQ(random.units, "m");
  const std::vector<std::string> keys = {"cell.grip_offset_m", random.key};
  EXPECT_DOUBLE_EQ(study.scenario_with(keys, std::vector<double>{0.01, 0.002}).cell.grip_offset_m, 0.012);
}

TEST(ExecutionError, StaysWithinItsBoundsWhateverItsDistribution) {
  for (const char* word : {"uniform", "triangular", "normal"}) {
    const Study study = study_of(search_block("sample") + kForceError + "distribution = \"" + word + "\"\n");
    const Distribution& error = study.randoms().back().distribution;
    EXPECT_NEAR(quantile(error, 0.5), 0.0, 1e-12) << word;  // symmetric, to rounding
    EXPECT_GE(quantile(error, 1e-9), -0.1) << word;
    EXPECT_LE(quantile(error, 1.0 - 1e-9), 0.1) << word;
  }
}

TEST(ExecutionError, ReadsBackFromTheResolvedConfig) {
  const Study study = study_of(search_block("robust") + kForceError);
  const Study again = study_of(study.resolved_toml());
  EXPECT_EQ(again.resolved_toml(), study.resolved_toml());
  EXPECT_EQ(again.randoms()[1].key, study.randoms()[1].key);
}

TEST(ExecutionError, IsRefusedWhereItMeansNothing) {
  const std::string sample = search_block("sample");
  EXPECT_NE(message_of(sample + "[[random]]\nkey = \"gripper.stroke_m\"\nrelative = 0.1\n")
                .find("[strategy] and [cell]"),
            std::string::npos);
  EXPECT_NE(message_of(sample + kForceError + "absolute = 0.1\n").find("absolute does not go with"),
            std::string::npos);
  EXPECT_NE(message_of(sample + kForceError + "from = 0.1\n").find("from does not go with"), std::string::npos);
  EXPECT_NE(
      message_of(sample + kForceError + "distribution = \"lognormal\"\n").find("uniform, normal or triangular"),
      std::string::npos);
  EXPECT_NE(message_of(sample + kForceError + kForceError).find("is drawn twice"), std::string::npos);
  EXPECT_NE(
      message_of(sample + "[[random]]\nkey = \"strategy.grip_force_N\"\nabsolute = 2.0\n").find("outside '> 0'"),
      std::string::npos);
  EXPECT_NE(message_of(sample + "[[random]]\nkey = \"strategy.lower_acceleration_m_s2\"\nrelative = 0.1\n")
                .find("no value"),
            std::string::npos);
}

TEST(ExecutionError, IsCheckedAgainstTheRulesBetweenKeys) {
  const std::string text = search_block("robust") + kForceError;
  EXPECT_EQ(errors_of(text, {"gripper.max_force_N=3.3"}), std::vector<std::string>{});
  EXPECT_FALSE(errors_of(text, {"gripper.max_force_N=3.2"}).empty()) << "3 N searched and a tenth more";
}

}  // namespace
}  // namespace unbruised::studies
