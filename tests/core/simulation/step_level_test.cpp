// Which step a scenario takes next while its product is carried: by how near its pads are to sliding.

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
  /// Steps to that time. @return ticks of the step that follows
  int at(double time_s) {
    while (time_s_ + 0.5 * kTimeStep_s < time_s) {
      time_s_ += kTimeStep_s;
      seen_.support_N = time_s_ < plan().lift_start_s() ? 1.0 : 0.0;
      choice_.decide(clock_, {.time_s = time_s_,
                              .cycle = cycle_,
                              .seen = seen_,
                              .support_gap_m = 1.0,
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
  double time_s_ = 0.0;
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

TEST(StepLevel, IsShortBeforeTheProductHangsAsSoonAsSomeContactsSlide) {
  Carried rests, slides;
  rests.grip(0.1, 2.0);
  slides.grip(0.1, 4.0);
  EXPECT_EQ(rests.at(0.15), kLong);  // the fingers rest, and the first touch is long ago
  EXPECT_EQ(slides.at(0.15), 1);
}

}  // namespace
}  // namespace unbruised
