#include "studies/kinds/end_search.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

const EndSearchSettings kSettings = {.from_N = 0.1, .to_N = 10.0, .tolerance = 0.005};

/// The known bracket of an end at `at_N`.
KnownEnd known_at(WindowEnd end, double at_N) {
  const bool hold = end == WindowEnd::hold;
  return {.row = 0,
          .end = end,
          .safe_N = hold ? 1.002 * at_N : 0.998 * at_N,
          .unsafe_N = hold ? 0.998 * at_N : 1.002 * at_N};
}

EndSearchResult searched(const KnownEnd& known, double true_N) {
  return search_ends({known}, kSettings, [&](const std::vector<EndRequest>& requests) {
    std::vector<bool> answers;
    for (const EndRequest& request : requests) {
      EXPECT_GE(request.grip_force_N, kSettings.from_N);
      EXPECT_LE(request.grip_force_N, kSettings.to_N);
      answers.push_back(known.end == WindowEnd::hold ? request.grip_force_N >= true_N
                                                     : request.grip_force_N <= true_N);
    }
    return std::optional(answers);
  });
}

TEST(EndSearch, AsksTwoForcesWhereTheEndStays) {
  const EndSearchResult found = searched(known_at(WindowEnd::damage, 4.0), 4.0);
  EXPECT_EQ(found.evaluation_count, 2U);
  EXPECT_EQ(found.safe_N[0], 0.998 * 4.0);
}

TEST(EndSearch, FollowsAnEndInAndOutWithinTheTolerance) {
  for (const WindowEnd end : {WindowEnd::hold, WindowEnd::damage}) {
    for (const double true_N : {1.1, 1.9, 1.99, 2.01, 2.2, 3.1, 7.0}) {
      const double safe_N = searched(known_at(end, 2.0), true_N).safe_N[0];
      // On the safe side of the end, at most a bracket as wide as the tolerance away.
      EXPECT_LE(std::abs(std::log(safe_N / true_N)), 0.005) << true_N;
      EXPECT_TRUE(end == WindowEnd::hold ? safe_N >= true_N : safe_N <= true_N) << true_N;
    }
  }
}

TEST(EndSearch, SaysNothingOfAnEndThatLeavesTheRange) {
  EXPECT_TRUE(std::isnan(searched(known_at(WindowEnd::damage, 2.0), 0.05).safe_N[0]));
  KnownEnd open = known_at(WindowEnd::damage, 9.9);
  open.unsafe_N = kAbsent;
  const EndSearchResult found = searched(open, 50.0);
  EXPECT_EQ(found.evaluation_count, 1U);
  EXPECT_EQ(found.safe_N[0], open.safe_N);
}

TEST(EndSearch, AsksForAllEndsInTheirOrderAndReportsAnInterruption) {
  std::size_t asked = 0;
  const std::vector<KnownEnd> ends = {known_at(WindowEnd::hold, 1.0), known_at(WindowEnd::damage, 2.0)};
  const EndSearchResult found = search_ends(ends, kSettings, [&](const std::vector<EndRequest>& requests) {
    asked += requests.size();
    EXPECT_TRUE(std::ranges::is_sorted(requests, {}, &EndRequest::end));
    return asked > 4 ? std::nullopt : std::optional(std::vector<bool>(requests.size(), false));
  });
  EXPECT_TRUE(found.interrupted);
}

}  // namespace
}  // namespace unbruised::studies
