#pragma once

/// @file
/// A scenario as its arm can ride it: slowed down where robot.timing = "fit" asks for it.

#include "core/robot/arm_ride.hpp"

namespace unbruised {

struct TimedScenario {
  Scenario scenario;
  ArmRide ride;
  double slowed_s = 0.0;  ///< by how much longer than as planned it moves
};

/// The scenario itself, or with timing = fit with the accelerations of lift, carrying (transfer and turns) and
/// lowering taken back, each as little as keeps every limit of the arm. A motion over one length of minimum jerk
/// whose peak acceleration falls by s^2 takes s times as long and is otherwise the same.
/// One that no slowing down mends stays as it is, with that as its breach.
/// @param scenario has a robot
TimedScenario timed_for_arm(const Scenario& scenario);

}  // namespace unbruised
