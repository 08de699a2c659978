// Work in a child ends with its answer, at the limit of its time or of its memory, or with a word how else.

#include "studies/process/child_work.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

TEST(ChildWork, Answers) {
  const ChildEnd end = work_in_child([] { return std::string("seven"); }, {});
  EXPECT_EQ(end.answer, "seven");
  EXPECT_EQ(end.no_child, 0);
}

TEST(ChildWork, ThatDoesNotComeToAnEndIsStopped) {
  const ChildEnd end = work_in_child(
      []() -> std::string {
        volatile unsigned turns = 0;
        for (;;) turns = turns + 1;
      },
      {.seconds_most = 1});
  EXPECT_FALSE(end.answer);
  EXPECT_EQ(end.how, "did not come to an end with it");
}

#ifndef UNBRUISED_SANITIZER  // which takes all address space there is
TEST(ChildWork, ThatTakesTooMuchMemoryIsRefusedIt) {
  constexpr std::size_t kMuch = std::size_t{256} << 20;
  const auto take = [] { return std::string(kMuch, 'x').substr(0, 1); };
  EXPECT_EQ(work_in_child(take, {.seconds_most = 60, .bytes_more = 4 * kMuch}).answer, "x");
  const ChildEnd end = work_in_child(take, {.seconds_most = 60, .bytes_more = kMuch / 4});
  EXPECT_FALSE(end.answer);
  EXPECT_EQ(end.how, "gave up on it");
}
#endif

}  // namespace
}  // namespace unbruised::studies
