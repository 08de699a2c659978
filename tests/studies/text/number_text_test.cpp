#include "studies/text/number_text.hpp"

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

TEST(NumberText, SaysPartsInPerCentWithThreeDigits) {
  EXPECT_EQ(percent(0.95), "95 %");
  EXPECT_EQ(percent(0.012345), "1.23 %");
  EXPECT_EQ(percent(-0.2337), "-23.4 %");
  EXPECT_EQ(percent(28.88), "2,890 %");
  EXPECT_EQ(percent(0.0), "0 %");
}

TEST(NumberText, CallsNothingAHundredPerCentThatIsNotAll) {
  EXPECT_EQ(percent(0.9996), "99.96 %");
  EXPECT_EQ(percent(1.0), "100 %");
}

TEST(NumberText, GivesChangesTheirSign) {
  EXPECT_EQ(signed_percent(0.02), "+2 %");
  EXPECT_EQ(signed_percent(-0.02), "-2 %");
}

}  // namespace
}  // namespace unbruised::studies
