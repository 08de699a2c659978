#pragma once

/// @file
/// Where the palm rests between lift and transfer, from the waypoints or the tilt of a strategy, and where that
/// leaves the product.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/scenario/arc.hpp"
#include "core/scenario/attitude.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Most waypoints of a strategy.
inline constexpr std::size_t kWaypointsMost = 16;

/// Largest turn of a product within a step that steps follow: its centrifugal strain is then wrong by 0.35 x 0.1^2
/// = 0.4 %, its angle by 1e-5.
inline constexpr double kLargestStepTurn_rad = 0.1;

/// A place and an attitude in which the palm rests, or which it passes, and how it goes there.
struct PalmStop {
  std::array<double, 3> place_m{};  ///< x, y as cell.transfer_m, z as cell.lift_height_m
  Attitude attitude;
  double wait_s = 0.0;
  std::optional<std::array<double, 3>> via_m{};  ///< it is reached on the arc through it
  double blend_m = 0.0;                          ///< 0: it rests there, else it passes within so much
  std::optional<double> speed_m_s{};             ///< most, on the way there
  std::optional<double> duration_s{};            ///< least, of the way there
};
/// The arc on which the second is reached from the first; none: a straight line.
std::optional<Arc> arc_between(const PalmStop& from, const PalmStop& to);
/// Where the palm is when a share of the way is done [m].
std::array<double, 3> place_between(const PalmStop& from, const PalmStop& to, double share);

/// Where the lift ends, the palm upright.
PalmStop lifted_stop(const Scenario& scenario);
/// The stops of the waypoints, or of the tilt, in their order; empty where there are none. A waypoint has what it
/// does not say from the one before it.
std::vector<PalmStop> palm_stops(const Scenario& scenario);

/// Does the palm turn the product?
bool turns_product(const Scenario& scenario);
/// Do the pads of a palm that stays upright hold the product beside its middle, by more than a twentieth of its
/// extent? Weight and haste may then turn it between them. Of flat pads with a layer: others know where it stands.
bool hangs_off_centre(const Scenario& scenario);
/// How the product is put down: the last of its stops where that is a waypoint, else upright over the place where
/// the lift ended.
PalmStop placing_stop(const Scenario& scenario);

/// Is the product put down leaning, or on another side than it lay on, by more than 0.01 rad?
bool lands_otherwise(const Scenario& scenario);

/// How the product's centre moves where the palm turns about the centre of its pads [m].
std::array<double, 3> centre_shift_m(const Scenario& scenario, const Attitude& attitude);
/// The lowest place of a lattice product that a palm in this attitude holds, above that of the upright one [m].
double lowest_place_m(const Scenario& scenario, const Attitude& attitude);

/// Size of the largest turn from one stop to the next [rad].
double largest_turn_rad(const Scenario& scenario);

}  // namespace unbruised
