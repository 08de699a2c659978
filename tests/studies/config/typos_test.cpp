// Every known key with one letter wrong: is the right key the first thing the user is told, and is no slip
// overlooked?

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>

#include "studies/config/problems.hpp"
#include "studies/config/schema.hpp"
#include "tests/figures.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::errors_of;
using testing::gripped_block;
using testing::small_network;

constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

std::vector<std::string> deletions(const std::string& word) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < word.size(); ++i) out.push_back(word.substr(0, i) + word.substr(i + 1));
  return out;
}

std::vector<std::string> swaps(const std::string& word) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i + 1 < word.size(); ++i) {
    out.push_back(word);
    std::swap(out.back()[i], out.back()[i + 1]);
  }
  return out;
}

std::vector<std::string> replacements(const std::string& word) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < word.size(); ++i) {
    for (const char letter : kLetters) {
      out.push_back(word);
      out.back()[i] = letter;
    }
  }
  return out;
}

std::vector<std::string> insertions(const std::string& word) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i <= word.size(); ++i) {
    for (const char letter : kLetters) out.push_back(word.substr(0, i) + letter + word.substr(i));
  }
  return out;
}

/// A text with one line in a table, which it has already or which comes last.
std::string with_line(const std::string& table, const std::string& line) {
  const bool of_network = table.starts_with("product.") && table != "product.limits";
  const std::string text = of_network ? small_network() : gripped_block("simulate");
  const std::string header = table_header(table);
  const std::size_t at = text.find(header + "\n");
  if (at == std::string::npos) return text + header + "\n" + line + "\n";
  const std::size_t end = at + header.size() + 1;
  return text.substr(0, end) + line + "\n" + text.substr(end);
}

struct Count {
  int all = 0;
  int right = 0;
  int ignored = 0;
  std::vector<std::string> wrong;

  [[nodiscard]] double rate() const { return static_cast<double>(right) / static_cast<double>(all); }
};

/// One misspelt key, and what is said first.
void count_answer(const KeySpec& spec, const std::string& typo, Count& count) {
  const std::size_t dot = spec.path.rfind('.');
  const std::string table(spec.path.substr(0, dot));
  const std::string path = table + "." + typo;
  const bool foreign = table == "candidate[]" && find_key("strategy." + typo).spec != nullptr;
  if (typo == spec.path.substr(dot + 1) || find_key(path).spec != nullptr || foreign)
    return;  // another word that is right
  if (table == "product" || table == "gripper") {
    if (typo == "name" || typo == "description") return;
  }
  ++count.all;
  const auto errors = errors_of(with_line(table, typo + " = 1"));
  const auto answer = std::find_if(errors.begin(), errors.end(), [&](const std::string& line) {
    return line.find("." + typo + " = 1: unknown key") != std::string::npos;
  });
  if (answer == errors.end()) {
    ++count.ignored;
    count.wrong.push_back(path + ": no answer");
    return;
  }
  const std::size_t open = answer->find("did you mean '");
  const std::string rest = open == std::string::npos ? "'" : answer->substr(open + 14);
  if (pattern_of(rest.substr(0, rest.find('\''))) == spec.path) {
    ++count.right;
  } else {
    count.wrong.push_back(path + ": " + *answer);
  }
}

/// @param each at most so many edits of a class and key, chosen by a seeded generator
Count count_typos(std::size_t each) {
  std::mt19937_64 generator(20260101);
  Count count;
  for (const KeySpec& spec : key_table()) {
    const std::string leaf(spec.path.substr(spec.path.rfind('.') + 1));
    for (const auto edits : {deletions, insertions, replacements, swaps}) {
      std::vector<std::string> typos = edits(leaf);
      std::shuffle(typos.begin(), typos.end(), generator);
      if (typos.size() > each) typos.resize(each);
      for (const std::string& typo : typos) {
        if (!typo.empty()) count_answer(spec, typo, count);
      }
    }
  }
  return count;
}

std::string summary(const Count& count) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(),
                "typos: %d keys with one wrong letter: %.2f %% answered with the right key first, %d ignored",
                count.all, 100.0 * count.rate(), count.ignored);
  return text.data();
}

void expect_answers(const Count& count) {
  std::string wrong;
  for (std::size_t i = 0; i < std::min<std::size_t>(count.wrong.size(), 40); ++i) wrong += count.wrong[i] + "\n";
  EXPECT_GE(count.rate(), 0.95) << wrong;
  EXPECT_EQ(count.ignored, 0) << wrong;
}

TEST(Typos, OfOneLetterAreAnsweredWithTheRightKey) {
  const Count count = count_typos(3);
  EXPECT_GT(count.all, 1000);
  expect_answers(count);
}

TEST(HeavyTypos, OfOneLetterAreAnsweredWithTheRightKey) {
  const Count count = count_typos(60);
  unbruised::testing::tell_figure("typos", summary(count));
  expect_answers(count);
}

TEST(Typos, InTheNameOfATableAreAnsweredWithTheRightTable) {
  Count count;
  for (const std::string& table : table_names()) {
    const std::string name = table.substr(0, table.find('['));
    if (table.find('.') != std::string::npos) continue;
    for (const auto edits : {deletions, swaps}) {
      for (const std::string& typo : edits(name)) {
        if (typo == name || typo.empty()) continue;
        ++count.all;
        const std::string misspelt = typo + table.substr(name.size());
        const auto errors = errors_of(gripped_block("simulate") + table_header(misspelt) + "\nx = 1\n");
        const bool named = std::any_of(errors.begin(), errors.end(), [&](const std::string& line) {
          return line.find("[" + typo) != std::string::npos && line.find("unknown table") != std::string::npos;
        });
        const bool right = std::any_of(errors.begin(), errors.end(), [&](const std::string& line) {
          return line.find("did you mean " + table_header(table) + "?") != std::string::npos;
        });
        count.right += right ? 1 : 0;
        count.ignored += named ? 0 : 1;
        if (!right) count.wrong.push_back(misspelt + ": " + (errors.empty() ? "accepted" : errors.front()));
      }
    }
  }
  expect_answers(count);
}

}  // namespace
}  // namespace unbruised::studies
