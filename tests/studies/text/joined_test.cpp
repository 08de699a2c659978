#include "studies/text/joined.hpp"

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

TEST(Joined, PutsSeparatorsBetweenPartsOnly) {
  EXPECT_EQ(comma_list(std::vector<std::string>{}), "");
  EXPECT_EQ(comma_list(std::vector<std::string>{"a"}), "a");
  EXPECT_EQ(comma_list(std::vector<std::string>{"", "b", ""}), ", b, ");  // an empty part is a part
  EXPECT_EQ(separated(std::vector<std::string>{"held", "dropped"}, " or "), "held or dropped");
  EXPECT_EQ(comma_list(std::vector<int>{1, 2}, [](int i) { return std::to_string(i); }), "1, 2");
}

TEST(Joined, PutsAPartBehindOthersWithASeparatorWhereBothAreThere) {
  std::string list;
  add_part(list, "; ", "");
  EXPECT_EQ(list, "");
  add_part(list, "; ", "a");
  add_part(list, "; ", "b");
  add_part(list, "; ", "");
  EXPECT_EQ(list, "a; b");
}

TEST(Joined, ListsWordsAsASentenceDoes) {
  EXPECT_EQ(listed({}, "or"), "");
  EXPECT_EQ(listed({"sample"}, "or"), "sample");
  EXPECT_EQ(listed({"sample", "robust"}, "or"), "sample or robust");
  EXPECT_EQ(listed_quoted({"sample", "robust", "compare"}, "and"), "\"sample\", \"robust\" and \"compare\"");
}

}  // namespace
}  // namespace unbruised::studies
