// Lists of particles and springs as spreadsheets write them.

#include "studies/config/library.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

std::vector<Entry> particles(const std::string& text) {
  Problems problems;
  auto entries =
      csv_entries("product.particle", text, std::make_shared<const std::string>("list.csv"), 1, problems);
  EXPECT_EQ(problems.lines(), std::vector<std::string>{});
  return entries;
}

TEST(Csv, MayBeginWithAByteOrderMark) {
  const std::string rows = "position_x_m,mass_kg\n0.5,0.1\n";
  const auto marked = particles("\xEF\xBB\xBF" + rows);
  const auto plain = particles(rows);
  ASSERT_EQ(marked.size(), plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(marked[i].path, plain[i].path);
    EXPECT_EQ(marked[i].value.number, plain[i].value.number);
  }
}

TEST(Csv, MayWriteAPlusBeforeANumber) {
  const auto entries = particles("position_x_m,mass_kg\n+0,+1.5e-1\n");
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_TRUE(entries[0].value.is_number());
  EXPECT_EQ(entries[0].value.number, 0.0);
  EXPECT_EQ(entries[1].value.number, 0.15);
}

TEST(Csv, DoesNotTakeTwoSignsForANumber) {
  for (const std::string cell : {"+-1", "++1", "+"}) {
    EXPECT_FALSE(particles("mass_kg\n" + cell + "\n")[0].value.is_number()) << cell;
  }
}

std::vector<std::string> said_of_profile(const std::string& text) {
  Problems problems;
  profile_entries(text, std::make_shared<const std::string>("tip.csv"), 1, problems);
  return problems.lines();
}

TEST(ProfileCsv, IsTwoListsOfNumbers) {
  Problems problems;
  const auto entries = profile_entries("# a tip\nplace_m,height_m\n-0.01,0\n0,1e-3\n\n0.01,0.0\n",
                                       std::make_shared<const std::string>("tip.csv"), 1, problems);
  EXPECT_EQ(problems.lines(), std::vector<std::string>{});
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].path, "gripper.pad.profile_place_m");
  ASSERT_EQ(entries[1].value.items.size(), 3U);
  EXPECT_EQ(entries[1].value.items[1].number, 1e-3);
}

TEST(ProfileCsv, IsRefusedWithFileAndLine) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(said_of_profile("place,height\n0,0\n"),
            Lines{"tip.csv:1: gripper.pad.profile_file: the first line must be \"place_m,height_m\""});
  EXPECT_EQ(said_of_profile("place_m,height_m\n0,0\n0.01\n"),
            Lines{"tip.csv:3: gripper.pad.profile_file: a row must have two cells, a place and a height, not 1"});
  EXPECT_EQ(said_of_profile("place_m,height_m\n0,0\n0.01,1 mm\n"),
            Lines{"tip.csv:3: height_m = \"1 mm\": must be a number"});
  EXPECT_EQ(
      said_of_profile("place_m,height_m\n0.01,0\n0.0,0\n"),
      Lines{"tip.csv:3: place_m = 0.0: must be > the place before it, 0.01: a profile has one height at each "
            "place"});
  EXPECT_EQ(said_of_profile("place_m,height_m\n0.01,0\n"),
            Lines{"tip.csv:1: gripper.pad.profile_file: the file must have two rows at least"});
}

}  // namespace
}  // namespace unbruised::studies
