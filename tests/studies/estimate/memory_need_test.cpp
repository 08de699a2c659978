#include "studies/estimate/memory_need.hpp"

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

TEST(MemoryNeed, IsRefusedWithBothFiguresWhereItIsMoreThanThereIs) {
  EXPECT_FALSE(too_much_memory("small", 1e3));
  const auto refusal = too_much_memory("large", 1e18);
  ASSERT_TRUE(refusal);
  EXPECT_NE(refusal->find("large needs about"), std::string::npos) << *refusal;
  EXPECT_NE(refusal->find("this machine gives"), std::string::npos) << *refusal;
}

TEST(MemoryNeed, OfRowsGrowsWithTheirNumberAndTheirInputs) {
  EXPECT_EQ(estimated_rows_bytes(200.0, 3), 2.0 * estimated_rows_bytes(100.0, 3));
  EXPECT_GT(estimated_rows_bytes(100.0, 4), estimated_rows_bytes(100.0, 3));
}

}  // namespace
}  // namespace unbruised::studies
