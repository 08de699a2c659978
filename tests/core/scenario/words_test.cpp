#include "core/scenario/words.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/scenario/range.hpp"

namespace unbruised {
namespace {

TEST(Words, SpellANumberSoThatItReadsBackAsTheSameBits) {
  EXPECT_EQ(spelled(1.0), "1.0");
  EXPECT_EQ(spelled(1e6), "1e6");
  EXPECT_EQ(spelled(1e-4), "1e-4");
  EXPECT_EQ(spelled(0.1), "0.1");
  EXPECT_EQ(spelled(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(spelled(-HUGE_VAL), "-inf");
  EXPECT_EQ(spelled_plain(0.0), "0");
  EXPECT_EQ(spelled_plain(1.37), "1.37");
}

TEST(Words, SayAPartInPerCent) {
  EXPECT_EQ(in_per_cent(0.05), "5 %");
  EXPECT_EQ(in_per_cent(0.8), "80 %");
}

TEST(Words, GivePeopleFourDigitsAndThousands) {
  EXPECT_EQ(for_people(1021969.3), "1,022,000");
  EXPECT_EQ(for_people(-12345.0), "-12,350");
  EXPECT_EQ(for_people(3000.0), "3000");
  EXPECT_EQ(for_people(0.0), "0");
  EXPECT_EQ(for_people(0.0833333), "0.08333");
  EXPECT_EQ(for_people(2.5e-7), "2.5e-7");
  EXPECT_EQ(for_people(5e10), "5e10");
}

TEST(Range, ContainsWhatItsWordsSay) {
  EXPECT_EQ(kPositive.text(), "> 0");
  EXPECT_EQ(kNotNegative.text(), ">= 0");
  EXPECT_EQ((Range{.min = 0.0, .max = 0.5, .max_open = true}.text()), ">= 0, < 0.5");
  EXPECT_EQ(kAnyNumber.text(), "");
  EXPECT_FALSE(kPositive.contains(0.0));
  EXPECT_TRUE(kNotNegative.contains(0.0));
  EXPECT_FALSE(kNotNegative.contains(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace unbruised
