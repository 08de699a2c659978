// Golden messages: what a user reads for each kind of mistake. A change here is a change users see.

#include <sstream>

#include "tests/figures.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::errors_of;
using testing::gripped_block;
using testing::small_network;

struct BadConfig {
  std::string what;
  std::string text;
  std::vector<std::string> sets;
  std::vector<std::string> messages;
};

/// A correct study (nine lines) with lines after it; the first of them is line 10.
BadConfig after_block(const std::string& what, const std::string& lines, const std::vector<std::string>& messages,
                      const std::string& kind = "simulate") {
  return {what, gripped_block(kind) + lines, {}, messages};
}

BadConfig with_set(const std::string& what, const std::string& set, const std::string& message) {
  return {what, gripped_block("simulate"), {set}, {message}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// A solid of revolution with lines after it; the first of them is line 9.
BadConfig revolution(const std::string& what, const std::string& lines, const std::vector<std::string>& messages) {
  std::string text = replaced(gripped_block("simulate"), "\"box\"", "\"revolution\"");
  text = replaced(text, "[0.05, 0.06, 0.07]", "[0.05, 0.05, 0.07]");
  return {what, replaced(text, "[gripper]\n", lines + "[gripper]\n"), {}, messages};
}

std::vector<BadConfig> bad_configs() {
  const std::string network = small_network();
  return {
#include "tests/studies/config/bad_configs.inc"
#include "tests/studies/config/bad_searches.inc"
  };
}

TEST(BadConfigs, AreAnsweredWithExactlyTheseMessages) {
  const auto all = bad_configs();
  EXPECT_GE(all.size(), 220U);
  std::size_t as_promised = 0;
  for (const BadConfig& bad : all) {
    std::vector<std::string> messages = errors_of(bad.text, bad.sets);
    for (std::string& message : messages) {
      const std::size_t at = message.find(testing::config_root());
      if (at != std::string::npos) message.replace(at, testing::config_root().size(), "CONFIGS");
    }
    EXPECT_EQ(messages, bad.messages) << bad.what;
    as_promised += messages == bad.messages ? 1U : 0U;
  }
  unbruised::testing::tell_figure("bad_configs", "bad configs: " + std::to_string(as_promised) + " of " +
                                                     std::to_string(all.size()) +
                                                     " answered with their golden messages");
}

TEST(BadConfigs, AMissingFileIsNamed) {
  const auto result = read_study("no/such/study.toml", {}, "");
  EXPECT_EQ(result.error().messages, std::vector<std::string>{"no/such/study.toml: no such file"});
}

TEST(BadConfigs, AFileOverFourMebibytesIsRefusedBeforeParsing) {
  const std::string text = gripped_block("simulate") + std::string(std::size_t{4} << 20, '#');
  EXPECT_EQ(errors_of(text), std::vector<std::string>{"study.toml:1: the file is larger than 4 MiB"});
}

TEST(BadConfigs, EveryLineLeftOutOrDoubledInASearchIsSurvived) {
  for (const std::string kind : {"sample", "optimize", "robust", "pareto", "compare", "sensitivity"}) {
    std::vector<std::string> lines;
    std::stringstream text(testing::search_block(kind));
    for (std::string line; std::getline(text, line);) lines.push_back(line + "\n");
    for (std::size_t skipped = 0; skipped < lines.size(); ++skipped) {
      for (const bool doubled : {false, true}) {
        std::string other;
        for (std::size_t i = 0; i < lines.size(); ++i) {
          if (i != skipped || doubled) other += lines[i];
          if (i == skipped && doubled) other += lines[i];
        }
        for (const std::string& message : errors_of(other))
          EXPECT_TRUE(message.starts_with("study.toml:")) << message;
      }
    }
    for (const std::string wrong :
         {"product.kind=network", "product.size_m=[0.1]", "product.mass_kg=none", "variable[0].key=x",
          "random[0].key=product.load[7].time_s[9]", "random[0].key=limits.plastic_strain",
          "random[0].key=product.particle[1].position_m[4]", "random[0].mean=1", "random=1", "candidate[0]=1",
          "candidate[0].use=configs", "search=1", "variable[0].key=gripper.stroke_m",
          "search.objective=", "variable[99999999999].from=1"}) {
      const auto messages = errors_of(testing::search_block(kind), {wrong});
      for (const std::string& message : messages) EXPECT_FALSE(message.empty());
    }
  }
}

TEST(BadConfigs, EveryTruncationAndEveryChangedByteIsSurvived) {
  // A crash or an escaping exception fails the test; most of these texts are wrong, some are right.
  const std::string text =
      gripped_block("sweep") + "[[vary]]\nkey = \"product.size_m[0]\"\nvalues = [0.05, 0.06]\n";
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    wrong += errors_of(text.substr(0, i)).empty() ? 0U : 1U;
    for (const char c : {'\0', '[', ']', '"', '\'', '.', '=', '{', '#', '\n', '\xC3', '\x80', '\xFF', '-', '9'}) {
      std::string other = text;
      other[i] = c;
      wrong += errors_of(other).empty() ? 0U : 1U;
    }
  }
  EXPECT_GT(wrong, 10 * text.size());
}

}  // namespace
}  // namespace unbruised::studies
