#pragma once

/// @file
/// Events: sets of ways in which a run can end, e.g. `held`, `not damaged`, `held or dropped`.
///
/// A `not` speaks of products that were kept to the end of the cycle: `not damaged` is kept and without damage,
/// `not dropped` is kept, whether it slipped, was damaged or neither. A product that was never grasped, was
/// dropped or cannot be told about (diverged, out of range) counts only where its word is written.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/outcome/outcome.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised::studies {

/// How a run ended, finer than its outcome: a product that slipped may have been damaged as well. The first eight
/// have the codes of the outcomes.
enum class Ending : std::int8_t {
  not_run = -1,
  held = 0,
  slipped = 1,  ///< and no limit of damage exceeded
  dropped = 2,
  damaged = 3,
  not_grasped = 4,
  diverged = 5,
  out_of_range = 6,
  misplaced = 7,
  slipped_and_damaged = 8,
};
inline constexpr unsigned kEndingCount = 9;

/// Decided from the outcome, and for a product that slipped from the metrics and limits too.
Ending ending_of(const ScenarioResult& result, const LimitParameters& limits);

struct OutcomeEvent {
  std::uint32_t endings = 0;  ///< bit k: the ending of code k belongs to it

  [[nodiscard]] bool contains(Ending ending) const {
    return ending != Ending::not_run && ((endings >> static_cast<unsigned>(ending)) & 1U) != 0;
  }
  friend bool operator==(const OutcomeEvent&, const OutcomeEvent&) = default;
};

OutcomeEvent held_event();
/// Kept to the end of the cycle: held, slipped, damaged or misplaced.
OutcomeEvent kept_event();
/// All runs that end with this outcome.
OutcomeEvent event_of(Outcome outcome);
/// Kept, and not so. @param outcome any but `held`
OutcomeEvent event_of_not(Outcome outcome);
/// "held", "not damaged", "held or dropped": the shorter way to say it; an event that words make reads back.
std::string event_words(const OutcomeEvent& event);

bool event_happens(const OutcomeEvent& event, const ScenarioResult& result, const LimitParameters& limits);
/// The part of the results in which the event happens.
double frequency(const OutcomeEvent& event, std::span<const ScenarioResult> results,
                 const LimitParameters& limits);

/// How far the event is from not happening, limit by limit; <= 0 exactly when it happens, always finite. Of events
/// with `held` in them: metric / limit - 1, of damage, slip and place, and one that is -1 when the cycle ran to
/// its end, else the rank of what ended it (dropped 1, not grasped 2, out of range 3, diverged 4). Where the run
/// ended before a metric existed its component has that rank too. Other events: -1 or 1.
std::vector<double> event_violations(const OutcomeEvent& event, const ScenarioResult& result,
                                     const LimitParameters& limits);
/// As long as `event_violations`: what each component speaks of, after `text`.
std::vector<std::string> event_violation_names(const OutcomeEvent& event, const std::string& text,
                                               const LimitParameters& limits);
/// The largest of them, kept within [-1, 1].
double event_measure(const OutcomeEvent& event, const ScenarioResult& result, const LimitParameters& limits);

/// How bad it is that a run ended early (1 to 4); -1 for one that ran to its end.
double rank_of_early_end(Outcome outcome);

}  // namespace unbruised::studies
