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

TEST(MemoryNeed, OfWhatMayTouchIsBounded) {
  ModelSize size;
  size.contact_node_count = 5000;  // 1.8 GB
  EXPECT_FALSE(too_many_may_touch("fine", size));
  size.contact_node_count = 8000;  // 4.6 GB
  const auto refusal = too_many_may_touch("finer", size);
  ASSERT_TRUE(refusal);
  EXPECT_NE(refusal->find("in finer 8,000 particles may touch, whose compliance would take 4.6"),
            std::string::npos)
      << *refusal;
}

TEST(MemoryNeed, OfRowsGrowsWithTheirNumberAndTheirInputs) {
  for (const StudyKind kind : {StudyKind::sweep, StudyKind::robust}) {
    EXPECT_EQ(estimated_rows_bytes(kind, 200.0, 3), 2.0 * estimated_rows_bytes(kind, 100.0, 3));
    EXPECT_GT(estimated_rows_bytes(kind, 100.0, 4), estimated_rows_bytes(kind, 100.0, 3));
  }
  // Ten million scenarios that are known beforehand are no matter of memory: their rows stay in the journals.
  EXPECT_LT(estimated_rows_bytes(StudyKind::sweep, 1e7, 1), 1e9);
}

}  // namespace
}  // namespace unbruised::studies
