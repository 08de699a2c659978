// Which step a scenario takes next: by how its fingers move and, while the product is carried, by how near its
// pads are to sliding and how its plan goes on.

#include "core/simulation/step_level.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "benchmarks/cube512_scene.hpp"
#include "core/simulation/step_levels.hpp"

namespace unbruised {
namespace {

constexpr double kTimeStep_s = 1e-3;
constexpr double kFriction = 0.6;

Scenario lifted_cube() {
  Scenario scenario = benchmarks::cube512_scene(kTimeStep_s);
  scenario.simulation.levels = LevelUse::automatic;
  return scenario;
}

/// A cube that touches at once, and hangs from the start of its lift on.
class Carried {
 public:
  Carried() { cycle_.observe(0.0, 0.0); }

  [[nodiscard]] const MotionPlan& plan() const { return cycle_.plan(); }
  /// What the pads are like from now on. @param load of what friction holds @param sliding of ten contacts
  void grip(double load, double sliding) {
    for (FingerObservation& finger : seen_.finger) {
      finger.normal_N = 5.0;
      finger.tangent_N = {0.0, load * kFriction * finger.normal_N};
      finger.closed_contacts = 10.0;
      finger.sliding_contacts = sliding;
    }
  }
  /// How far it is above its support.
  void hang(double gap_m) { gap_m_ = gap_m; }
  /// Steps to that time. @param closing_m_s speed of its fingers @return ticks of the step that follows
  int at(double time_s, double closing_m_s = 0.0) {
    while (time_s_ + 0.5 * kTimeStep_s < time_s) {
      time_s_ += kTimeStep_s;
      seen_.support_N = time_s_ < plan().lift_start_s() ? 1.0 : 0.0;
      choice_.decide(clock_, {.time_s = time_s_,
                              .cycle = cycle_,
                              .seen = seen_,
                              .closing_m_s = closing_m_s,
                              .support_gap_m = gap_m_,
                              .weight_N = 1.0,
                              .friction = kFriction,
                              .gravity_m_s2 = scenario_.cell.gravity_m_s2});
    }
    return choice_.ticks();
  }

 private:
  const Scenario scenario_ = lifted_cube();
  const StepClock clock_{kTimeStep_s, 1, scenario_.simulation.theta};
  HandlingCycle cycle_{scenario_};
  LevelChoice choice_{step_levels(scenario_)};
  StepObservation seen_;  // of two fingers
  double time_s_ = 0.0, gap_m_ = 1.0;
};

constexpr int kLong = 6;  // of 1 ms

TEST(StepLevel, IsLongWhereOnlyTheRimOfAPatchSlides) {
  Carried cube;
  cube.grip(0.7, 6.0);
  EXPECT_EQ(cube.at(0.9), kLong);
}

TEST(StepLevel, IsShortWherePadsCarryNearlyWhatFrictionHolds) {
  Carried cube;
  cube.grip(0.91, 6.0);
  EXPECT_EQ(cube.at(0.9), 1);
  cube.grip(0.89, 6.0);  // while nothing grows
  EXPECT_EQ(cube.at(0.91), kLong);
}

TEST(StepLevel, IsShortWhereAPadSlidesAsAWholeAndForAWhileAfter) {
  Carried cube;
  cube.grip(0.7, 10.0);
  EXPECT_EQ(cube.at(0.85), 1);
  cube.grip(0.7, 9.0);
  EXPECT_EQ(cube.at(0.875), 1);
  EXPECT_EQ(cube.at(0.885), kLong);
}

// The lift of 10 cm in half a second pulls with up to 1.24 g, and falls to 0.76 g.
TEST(StepLevel, LooksAheadToWhatThePlanAsksOfFriction) {
  Carried before_rise, before_fall;
  const double lift_s = before_rise.plan().lift_start_s();
  ASSERT_NEAR(lift_s, benchmarks::kCube512LiftStart_s, 1e-9);
  const auto pull = [&](double time_s) { return 9.81 + before_rise.plan().palm(time_s).acceleration_m_s2[2]; };
  const double reach_s = 2.0 * lifted_cube().simulation.theta * kLong * kTimeStep_s;
  const double rises_s = lift_s + 0.06, falls_s = lift_s + 0.2;
  ASSERT_GT(pull(rises_s + reach_s) / pull(rises_s), 1.02);
  ASSERT_LT(pull(falls_s + reach_s) / pull(falls_s), 0.98);
  for (Carried* cube : {&before_rise, &before_fall}) cube->grip(0.84, 6.0);
  EXPECT_EQ(before_rise.at(rises_s), 1);
  EXPECT_EQ(before_fall.at(falls_s), kLong);
}

TEST(StepLevel, IsShortBeforeTheProductComesDownOnItsSupportAndNotAfterItRose) {
  Carried cube;
  cube.grip(0.1, 0.0);
  cube.hang(1.5e-3);
  const double rises_s = cube.plan().lift_start_s() + 0.1, lowers_s = cube.plan().release_start_s() - 0.2;
  const auto height_m = [&](double time_s) { return cube.plan().palm(time_s).position_m[2]; };
  ASSERT_GT(height_m(rises_s + 0.02) - height_m(rises_s), 1e-3);
  ASSERT_LT(height_m(lowers_s + 0.02) - height_m(lowers_s), -1e-3);
  EXPECT_EQ(cube.at(rises_s), kLong);
  EXPECT_EQ(cube.at(lowers_s), 1);
}

// A finger is thrown back by the drive that presses into its swing for 90 ms, unless it has come to rest.
TEST(StepLevel, IsShortAfterATouchUntilFingersHaveRestedForAWhile) {
  Carried rests, swings;
  for (Carried* cube : {&rests, &swings}) cube->grip(0.1, 0.0);
  EXPECT_EQ(rests.at(0.06), kLong);
  EXPECT_EQ(swings.at(0.058, 1e-3), 1);
  EXPECT_EQ(swings.at(0.066), 1);
  EXPECT_EQ(swings.at(0.07), kLong);
}

// Its support lets go at the start of the lift.
TEST(StepLevel, IsShortAfterTheProductHangsUntilLoadsGoStraight) {
  Carried rests, swings;
  const double lift_s = rests.plan().lift_start_s();
  for (Carried* cube : {&rests, &swings}) {
    cube->grip(0.1, 0.0);
    EXPECT_EQ(cube->at(lift_s), 1);
  }
  EXPECT_EQ(rests.at(lift_s + 0.009), 1);
  EXPECT_EQ(rests.at(lift_s + 0.012), kLong);
  for (int step = 1; step < 29; ++step) {
    swings.grip(step % 2 == 0 ? 0.1 : 0.11, 0.0);
    EXPECT_EQ(swings.at(lift_s + step * kTimeStep_s), 1) << step;
  }
  EXPECT_EQ(swings.at(lift_s + 0.031), kLong);
}

// A finger that its drive's force alone moves meets the product 0.6 ms late after steps of 6 ms.
TEST(StepLevel, IsShortWhileApproachingFingersSpeedUp) {
  const Scenario scenario = lifted_cube();
  const StepClock clock{kTimeStep_s, 1, scenario.simulation.theta};
  const HandlingCycle cycle(scenario);
  const StepObservation seen;
  LevelChoice choice(step_levels(scenario));
  const auto decide = [&](double time_s, double closing_m_s, double gap_m) {
    choice.decide(clock, {.time_s = time_s,
                          .cycle = cycle,
                          .seen = seen,
                          .pad_gap_m = gap_m,
                          .closing_m_s = closing_m_s,
                          .weight_N = 1.0});
    return choice.ticks();
  };
  EXPECT_EQ(decide(0.001, 0.01, 0.1), 1);
  EXPECT_EQ(decide(0.002, 0.02, 0.1), 1);
  EXPECT_EQ(decide(0.003, 0.02, 0.1), kLong);
  EXPECT_EQ(decide(0.004, 0.0201, 0.1), kLong);
  EXPECT_EQ(decide(0.005, 0.0201, 4e-4), 1);
}

TEST(StepLevel, IsShortBeforeTheProductHangsAsSoonAsSomeContactsSlide) {
  Carried rests, slides;
  rests.grip(0.1, 2.0);
  slides.grip(0.1, 4.0);
  EXPECT_EQ(rests.at(0.15), kLong);  // the fingers rest, and the first touch is long ago
  EXPECT_EQ(slides.at(0.15), 1);
}

}  // namespace
}  // namespace unbruised
