#pragma once

/// @file
/// The words that answers and goals are made of, explained: metrics, outcomes, statistics, the grammar of
/// objectives and constraints. Config keys are explained by studies/config.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/outcome/damage_limits.hpp"
#include "core/outcome/outcome.hpp"

namespace unbruised::studies {

/// When a scenario ends with an outcome; docs/metrics.md has the same sentences, in this order of decision.
struct OutcomeMeaning {
  Outcome outcome;
  std::string_view when;
};
inline constexpr std::array<OutcomeMeaning, kOutcomeWords.size()> kOutcomeMeanings = {{
    {Outcome::diverged, "a number stopped being finite, or a solve did not converge"},
    {Outcome::out_of_range,
     "the state is none that the model describes: a strain or a rotation is too large (simulation.max_strain, "
     "simulation.max_rotation_rad), the product turns faster than the time step resolves, a pad or the support is "
     "pressed flat, the pads meet the product far behind its outermost place, or energy is unaccounted for"},
    {Outcome::not_grasped, "no two-finger contact at the end of the grip phase"},
    {Outcome::dropped, "no finger contact at some time between lift and release"},
    {Outcome::slipped,
     "slip_max_m > limits.slip_m or slip_max_rad > limits.slip_rad, or the product leaves a pad by more than "
     "limits.slip_m"},
    {Outcome::damaged, "a limit of damage in [limits] is exceeded"},
    {Outcome::misplaced,
     "place_error_m > limits.place_error_m or place_attitude_rad > limits.place_attitude_rad, where given"},
    {Outcome::held, "none of these"},
}};

/// What a word means, in indented lines with the word first; "metrics", "outcomes" and "goals" explain all of a
/// sort. Nothing when it is none of these words.
std::optional<std::string> explain_word(std::string_view word);
/// Every word that `explain_word` knows.
std::vector<std::string> vocabulary();

/// A unit for people: "m/s", or "none (a ratio)" of "1".
std::string unit_text(std::string_view udunits);

}  // namespace unbruised::studies
