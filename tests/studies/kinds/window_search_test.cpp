#include "studies/kinds/window_search.hpp"

#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

/// A combination whose ends are known: holds from `hold_N` on, undamaged up to `damage_N`.
struct Truth {
  double hold_N;
  double damage_N;
};

GripSample answer_of(const Truth& truth, double force_N) {
  return {.grip_force_N = force_N,
          .holds = force_N >= truth.hold_N ? Verdict::yes : Verdict::no,
          .undamaged = force_N <= truth.damage_N ? Verdict::yes : Verdict::no,
          .peak_finger_force_N = force_N};
}

ForceEvaluator evaluator_of(const std::vector<Truth>& truths) {
  return [truths](const std::vector<ForceRequest>& requests) {
    std::vector<GripSample> answers;
    for (const ForceRequest& request : requests) {
      answers.push_back(answer_of(truths.at(request.combination()), request.grip_force_N));
    }
    return std::optional(answers);
  };
}

WindowSearchSettings settings_of(std::size_t combinations) {
  return {.from_N = 0.1,
          .to_N = 10.0,
          .tolerance = 0.005,
          .combinations = searched_combinations(std::vector<std::size_t>(combinations, 0))};
}

TEST(WindowSearch, FindsKnownEndsWithinTheTolerance) {
  const std::vector<Truth> truths = {{1.2345, 2.3456}, {0.11, 9.9}, {3.0, 3.3}, {0.5, 0.6}, {2.0, 1.0}};
  const WindowSearchResult found = search_windows(settings_of(truths.size()), evaluator_of(truths));
  ASSERT_EQ(found.rows.size(), truths.size());
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const WindowRow& row = found.rows[i];
    // The safe side of a bracket that holds the true end and is no wider than the tolerance.
    EXPECT_GE(row.hold_force_N, truths[i].hold_N) << i;
    EXPECT_LE(row.hold_force_N, truths[i].hold_N * 1.005) << i;
    EXPECT_LE(row.damage_force_N, truths[i].damage_N) << i;
    EXPECT_GE(row.damage_force_N, truths[i].damage_N / 1.005) << i;
    EXPECT_LT(row.hold_bracket_low_N, truths[i].hold_N) << i;
    EXPECT_GT(row.damage_bracket_high_N, truths[i].damage_N) << i;
    EXPECT_EQ(row.exists, truths[i].hold_N < truths[i].damage_N) << i;
    EXPECT_DOUBLE_EQ(row.margin, row.damage_force_N / row.hold_force_N - 1.0);
  }
  EXPECT_NE(found.rows[4].note.find("no window"), std::string::npos);
}

TEST(WindowSearch, NeedsFewRoundsAndFewEvaluations) {
  const std::vector<Truth> one = {{1.2345, 2.3456}};
  const WindowSearchResult found = search_windows(settings_of(1), evaluator_of(one));
  // 100^(1/15) = 1.36 after 16 forces; 62 tolerances wide; cut into 9 parts twice.
  EXPECT_LE(found.round_count, 3U);
  EXPECT_LE(found.evaluation_count, 48U);

  const std::vector<Truth> many(40, Truth{1.2345, 2.3456});
  const WindowSearchResult wide = search_windows(settings_of(many.size()), evaluator_of(many));
  // Many brackets fill the lanes by themselves, so that bisection, the cheapest, is used: 8 forces and then
  // log2(ln(100) / 7 / 0.005) = 7.04 rounds of one force for each of the two ends.
  EXPECT_LE(wide.evaluation_count, 40U * (8 + 2 * 8));
}

/// What is asked, by place.
std::map<std::uint64_t, double> asked_of(const WindowSearchSettings& settings, const std::vector<Truth>& truths) {
  std::map<std::uint64_t, double> asked;
  std::uint64_t last = 0;
  const ForceEvaluator inner = evaluator_of(truths);
  search_windows(settings, [&](const std::vector<ForceRequest>& requests) {
    for (const ForceRequest& request : requests) {
      const std::uint64_t place = journal_id(request.place);
      EXPECT_TRUE(asked.empty() || place > last) << "round, combination and number sort in the order of asking";
      last = place;
      asked[place] = request.grip_force_N;
    }
    return inner(requests);
  });
  return asked;
}

TEST(WindowSearch, ACombinationAsksTheSameForcesAmongOthersAndInAnyPartOfThem) {
  const std::vector<Truth> truths = {{1.0, 2.0}, {0.3, 7.0}, {5.0, 4.0}, {0.01, 50.0}, {1.0, 1.001}};
  const WindowSearchSettings whole = settings_of(truths.size());
  const std::map<std::uint64_t, double> asked = asked_of(whole, truths);
  for (std::size_t parts = 1; parts <= truths.size(); ++parts) {
    std::map<std::uint64_t, double> together;
    for (std::size_t part = 0; part < parts; ++part) {
      WindowSearchSettings settings = whole;
      std::erase_if(settings.combinations,
                    [&](const SearchedCombination& each) { return each.number % parts != part; });
      together.merge(asked_of(settings, truths));
    }
    EXPECT_EQ(together, asked) << parts;
  }
}

TEST(WindowSearch, NeverAsksTheSameForceTwiceNorOutsideTheRange) {
  std::set<std::pair<std::size_t, double>> seen;
  const ForceEvaluator inner = evaluator_of({{1.0, 2.0}, {0.1, 10.0}, {20.0, 0.01}});
  search_windows(settings_of(3), [&](const std::vector<ForceRequest>& requests) {
    for (const ForceRequest& r : requests) {
      EXPECT_TRUE(seen.emplace(r.combination(), r.grip_force_N).second) << r.grip_force_N;
      EXPECT_GE(r.grip_force_N, 0.1);
      EXPECT_LE(r.grip_force_N, 10.0);
    }
    return inner(requests);
  });
}

TEST(WindowSearch, SaysWhichEndLiesOutsideTheRange) {
  const WindowSearchResult found =
      search_windows(settings_of(4), evaluator_of({{0.01, 2.0}, {1.0, 50.0}, {50.0, 2.0}, {0.01, 50.0}}));
  EXPECT_TRUE(std::isnan(found.rows[0].hold_force_N));
  EXPECT_TRUE(found.rows[0].exists);
  EXPECT_NE(found.rows[0].note.find("holds at 0.1 N already"), std::string::npos);

  EXPECT_TRUE(std::isnan(found.rows[1].damage_force_N));
  EXPECT_TRUE(found.rows[1].exists);
  EXPECT_NE(found.rows[1].note.find("no damage up to 10 N"), std::string::npos);

  EXPECT_TRUE(std::isnan(found.rows[2].hold_force_N));
  EXPECT_FALSE(found.rows[2].exists);
  EXPECT_NE(found.rows[2].note.find("no window"), std::string::npos);
  EXPECT_NE(found.rows[2].note.find("no force up to 10 N holds"), std::string::npos);

  EXPECT_TRUE(found.rows[3].exists);
  EXPECT_TRUE(std::isnan(found.rows[3].margin));
}

TEST(WindowSearch, SaysWhenTheImpactAloneDamages) {
  const ForceEvaluator impact = [](const std::vector<ForceRequest>& requests) {
    std::vector<GripSample> answers;
    for (const ForceRequest& request : requests) {
      GripSample answer = answer_of({1.0, 0.0}, request.grip_force_N);
      answer.peak_finger_force_N = 12.0;  // from the momentum of the finger, whatever the drive's limit
      answers.push_back(answer);
    }
    return std::optional(answers);
  };
  const WindowSearchResult found = search_windows(settings_of(1), impact);
  EXPECT_FALSE(found.rows[0].exists);
  EXPECT_TRUE(std::isnan(found.rows[0].damage_force_N));
  EXPECT_NE(found.rows[0].note.find("the impact alone damages"), std::string::npos);
  EXPECT_NEAR(found.rows[0].hold_force_N, 1.0, 0.005);
}

TEST(WindowSearch, TakesTheLeastForceFromWhichOnEverythingHoldsAndNotesTheRest) {
  const ForceEvaluator gap = [](const std::vector<ForceRequest>& requests) {
    std::vector<GripSample> answers;
    for (const ForceRequest& request : requests) {
      GripSample answer = answer_of({0.5, 6.0}, request.grip_force_N);
      if (request.grip_force_N > 1.0 && request.grip_force_N < 2.0) answer.holds = Verdict::no;
      answers.push_back(answer);
    }
    return std::optional(answers);
  };
  const WindowSearchResult found = search_windows(settings_of(1), gap);
  EXPECT_NEAR(found.rows[0].hold_force_N, 2.0, 0.01);
  EXPECT_TRUE(found.rows[0].exists);
  EXPECT_NE(found.rows[0].note.find("not monotone"), std::string::npos);
}

TEST(WindowSearch, ReportsAnInterruption) {
  int rounds = 0;
  const ForceEvaluator inner = evaluator_of({{1.0, 2.0}});
  const WindowSearchResult found = search_windows(settings_of(1), [&](const std::vector<ForceRequest>& requests) {
    return ++rounds > 1 ? std::nullopt : inner(requests);
  });
  EXPECT_TRUE(found.interrupted);
  EXPECT_TRUE(found.rows.empty());
}

/// A weak grip slips and lands hard: damaged from `landing_N` on, but held only from `truth.hold_N` on.
ForceEvaluator slipping_evaluator(const Truth& truth, double landing_N) {
  return [=](const std::vector<ForceRequest>& requests) {
    std::vector<GripSample> answers;
    for (const ForceRequest& request : requests) {
      GripSample answer = answer_of(truth, request.grip_force_N);
      if (answer.holds == Verdict::no && request.grip_force_N >= landing_N) answer.undamaged = Verdict::no;
      answers.push_back(answer);
    }
    return std::optional(answers);
  };
}

TEST(WindowSearch, DamageOfAForceThatDoesNotHoldEndsNoWindow) {
  for (const double landing_N : {0.0, 0.5, 0.932}) {
    const WindowSearchResult found = search_windows(settings_of(1), slipping_evaluator({0.984, 1.09}, landing_N));
    const WindowRow& row = found.rows[0];
    EXPECT_TRUE(row.exists) << landing_N << ": " << row.note;
    EXPECT_GE(row.hold_force_N, 0.984);
    EXPECT_LE(row.hold_force_N, 0.984 * 1.005);  // the search's tolerance
    EXPECT_LE(row.damage_force_N, 1.09);
    EXPECT_GE(row.damage_force_N, 1.09 / 1.005);
  }
}

TEST(WindowSearch, FindsAWindowThatIsHardlyWiderThanTheTolerance) {
  const WindowSearchResult found = search_windows(settings_of(1), slipping_evaluator({0.984, 0.995}, 0.3));
  EXPECT_TRUE(found.rows[0].exists) << found.rows[0].note;
}

TEST(WindowSearch, WithoutAWindowDamageIsLookedForBelowTheLeastHeldForce) {
  const WindowSearchResult found = search_windows(settings_of(1), slipping_evaluator({5.4, 2.0}, 5.0));
  EXPECT_FALSE(found.rows[0].exists);
  EXPECT_NEAR(found.rows[0].hold_force_N, 5.4, 5.4 * 0.005);
  EXPECT_NEAR(found.rows[0].damage_force_N, 2.0, 2.0 * 0.005);
  EXPECT_TRUE(found.rows[0].intervals.empty());
}

TEST(GripWindow, IsToldAsIntervalsWhereItIsNotMonotone) {
  std::vector<GripSample> samples;
  for (const double force_N : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) samples.push_back(answer_of({2.0, 9.0}, force_N));
  samples[2].undamaged = Verdict::no;  // 3 N marks
  const WindowRow row = read_grip_window(samples);
  EXPECT_TRUE(row.exists);
  EXPECT_EQ(row.hold_force_N, 4.0);  // [4, 6] is wider than [2, 2]
  EXPECT_TRUE(std::isnan(row.damage_force_N));
  EXPECT_EQ(row.intervals, "[2, 2], [4, 6]");
  EXPECT_NE(row.note.find("not monotone: held and undamaged in [2, 2] N too"), std::string::npos) << row.note;
}

TEST(GripWindow, ARunThatEndedEarlyBetweenSafeForcesDoesNotSplitTheWindow) {
  std::vector<GripSample> samples;
  for (const double force_N : {1.0, 2.0, 3.0, 4.0}) samples.push_back(answer_of({2.0, 9.0}, force_N));
  samples[2].holds = samples[2].undamaged = Verdict::unknown;
  EXPECT_EQ(read_grip_window(samples).intervals, "[2, 4]");
}

TEST(GripWindow, AForceThatSlipsAboveTheDamagingOnesDoesNotTouchTheWindow) {
  std::vector<GripSample> samples;
  for (const double force_N : {1.0, 2.0, 3.0, 4.0, 5.0}) samples.push_back(answer_of({2.0, 3.0}, force_N));
  samples.back().holds = Verdict::no;
  const WindowRow row = read_grip_window(samples);
  EXPECT_TRUE(row.exists);
  EXPECT_EQ(row.hold_force_N, 2.0);
  EXPECT_EQ(row.hold_bracket_low_N, 1.0);
  EXPECT_EQ(row.damage_force_N, 3.0);
  EXPECT_EQ(row.damage_bracket_high_N, 4.0);
  EXPECT_EQ(row.intervals, "[2, 3]");
  EXPECT_EQ(row.note, "");
}

TEST(GripWindow, RunsThatEndEarlyAtHighForcesEndTheWindowThere) {
  std::vector<GripSample> samples;
  for (const double force_N : {1.0, 2.0, 3.0, 4.0, 5.0}) samples.push_back(answer_of({2.0, 9.0}, force_N));
  for (const std::size_t i : {3U, 4U}) samples[i].holds = samples[i].undamaged = Verdict::unknown;
  const WindowRow row = read_grip_window(samples);
  EXPECT_TRUE(row.exists);
  EXPECT_EQ(row.hold_force_N, 2.0);
  EXPECT_EQ(row.damage_force_N, 3.0);
  EXPECT_NE(row.note.find("leave what the simulator can tell"), std::string::npos);
}

TEST(GripWindow, TheCommonWindowIsTheIntersection) {
  std::vector<WindowRow> rows;
  for (const Truth truth : {Truth{2.0, 4.0}, Truth{1.0, 3.0}}) {
    std::vector<GripSample> samples;
    for (const double force_N : {0.5, 1.0, 2.0, 3.0, 4.0, 5.0}) samples.push_back(answer_of(truth, force_N));
    rows.push_back(read_grip_window(samples));
  }
  const CommonWindow common = common_window(rows);
  EXPECT_TRUE(common.exists);
  EXPECT_EQ(common.hold_force_N, 2.0);
  EXPECT_EQ(common.damage_force_N, 3.0);

  rows.push_back(rows[0]);
  rows[2].hold_bracket_high_N = 3.5;
  EXPECT_FALSE(common_window(rows).exists);
  rows[2].exists = false;
  EXPECT_FALSE(common_window(rows).exists);
  EXPECT_FALSE(common_window({}).exists);
}

}  // namespace
}  // namespace unbruised::studies
