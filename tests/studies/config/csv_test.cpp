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

}  // namespace
}  // namespace unbruised::studies
