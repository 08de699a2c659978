#include "studies/goals/event.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/outcome/damage_limits.hpp"
#include "studies/goals/finite_violation.hpp"
#include "studies/goals/verdict.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// Of an event that did not happen although no component says why.
constexpr double kJustBroken = 1e-3;

constexpr std::uint32_t bit(Ending ending) { return 1U << static_cast<unsigned>(ending); }

constexpr std::uint32_t kKept = bit(Ending::held) | bit(Ending::slipped) | bit(Ending::damaged) |
                                bit(Ending::misplaced) | bit(Ending::slipped_and_damaged);

/// value / limit - 1, or the rank of an early end where the metric does not exist.
double over_limit(double value, double limit, Outcome outcome) {
  if (std::isnan(value)) return rank_of_early_end(outcome);
  const double over = limit > 0.0 ? value / limit - 1.0 : (value > limit ? 1.0 : 0.0);
  return finite_violation(over);
}

/// Which parts of `held` an event asks for.
struct EventParts {
  bool undamaged = false;
  bool unslipped = false;
  bool placed = false;
  bool completed = false;
};
EventParts parts_of(const OutcomeEvent& event) {
  return {.undamaged = !event.contains(Ending::damaged),
          .unslipped = !event.contains(Ending::slipped),
          .placed = !event.contains(Ending::misplaced),
          .completed = !event.contains(Ending::dropped) || !event.contains(Ending::not_grasped) ||
                       !event.contains(Ending::out_of_range) || !event.contains(Ending::diverged)};
}

/// Calls visit(limit, bound) for every limit that those parts are judged by: of damage, of slip, of the place.
template <class Visit>
void each_limit(const EventParts& parts, const LimitParameters& limits, const Visit& visit) {
  if (parts.undamaged) {
    for (const DamageLimit& limit : kDamageLimits) {
      if (const auto bound = bound_of(limit, limits)) visit(limit, *bound);
    }
  }
  if (parts.unslipped) {
    for (const SlipLimit& limit : kSlipLimits) visit(limit, limits.*(limit.limit));
  }
  if (parts.placed) {
    for (const PlaceLimit& limit : kPlaceLimits) {
      if (const auto& bound = limits.*(limit.limit)) visit(limit, *bound);
    }
  }
}

/// Events that are a part of what `held` asks for have smooth components; others are met or not.
bool is_smooth(const OutcomeEvent& event) { return event.contains(Ending::held); }

std::string words_of(std::uint32_t endings) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < kOutcomeWords.size(); ++k) {
    if ((endings & event_of(static_cast<Outcome>(k)).endings) != 0) words.emplace_back(kOutcomeWords[k]);
  }
  return separated(words, " or ");
}

/// The event as words alone; empty where that says something else: no word tells slipped from slipped and damaged.
std::string plain_words(std::uint32_t endings) {
  const bool whole =
      ((endings & bit(Ending::slipped)) != 0) == ((endings & bit(Ending::slipped_and_damaged)) != 0);
  return whole ? words_of(endings) : std::string();
}

/// Phrases with a `not`, with the words of what they leave out; the shortest that fits, empty where none does.
std::string negated_words(std::uint32_t endings) {
  const std::array<std::pair<std::string_view, std::uint32_t>, 5> phrases = {{
      {"not dropped", kKept},
      {"not slipped", event_of_not(Outcome::slipped).endings},
      {"not damaged", event_of_not(Outcome::damaged).endings},
      {"not misplaced", event_of_not(Outcome::misplaced).endings},
      {"slipped and not damaged", bit(Ending::slipped)},
  }};
  std::string shortest;
  for (const auto& [phrase, said] : phrases) {
    if ((said & ~endings) != 0) continue;
    const std::string rest = plain_words(endings & ~said);
    if (rest.empty() && (endings & ~said) != 0) continue;
    std::string words(phrase);
    add_part(words, " or ", rest);
    if (shortest.empty() || words.size() < shortest.size()) shortest = std::move(words);
  }
  return shortest;
}

}  // namespace

double rank_of_early_end(Outcome outcome) {
  switch (outcome) {
    case Outcome::dropped:
      return 1.0;
    case Outcome::not_grasped:
      return 2.0;
    case Outcome::out_of_range:
      return 3.0;
    case Outcome::diverged:
    case Outcome::not_run:
      return 4.0;
    default:
      return -1.0;
  }
}

Ending ending_of(const ScenarioResult& result, const LimitParameters& limits) {
  if (result.outcome != Outcome::slipped) return static_cast<Ending>(result.outcome);
  return undamaged(result.metrics, result.outcome, limits) == Verdict::no ? Ending::slipped_and_damaged
                                                                          : Ending::slipped;
}

OutcomeEvent held_event() { return {bit(Ending::held)}; }
OutcomeEvent kept_event() { return {kKept}; }

OutcomeEvent event_of(Outcome outcome) {
  const std::uint32_t own = bit(static_cast<Ending>(outcome));
  return {outcome == Outcome::slipped ? own | bit(Ending::slipped_and_damaged) : own};
}

OutcomeEvent event_of_not(Outcome outcome) {
  std::uint32_t left_out = event_of(outcome).endings;
  if (outcome == Outcome::damaged) left_out |= bit(Ending::slipped_and_damaged);
  return {kKept & ~left_out};
}

std::string event_words(const OutcomeEvent& event) {
  const std::string plain = plain_words(event.endings);
  const std::string negated = negated_words(event.endings);
  if (plain.empty()) return negated;
  return negated.empty() || plain.size() <= negated.size() ? plain : negated;
}

bool event_happens(const OutcomeEvent& event, const ScenarioResult& result, const LimitParameters& limits) {
  return event.contains(ending_of(result, limits));
}

double frequency(const OutcomeEvent& event, std::span<const ScenarioResult> results,
                 const LimitParameters& limits) {
  const auto count = std::count_if(results.begin(), results.end(), [&](const ScenarioResult& result) {
    return event_happens(event, result, limits);
  });
  return static_cast<double>(count) / static_cast<double>(results.size());
}

std::vector<double> event_violations(const OutcomeEvent& event, const ScenarioResult& result,
                                     const LimitParameters& limits) {
  const bool met = event_happens(event, result, limits);
  if (!is_smooth(event)) return {met ? -1.0 : 1.0};
  const EventParts parts = parts_of(event);
  std::vector<double> all;
  const Outcome outcome = result.outcome;
  each_limit(parts, limits, [&](const auto& limit, double bound) {
    all.push_back(over_limit(result.metrics[limit.metric], bound, outcome));
  });
  if (parts.completed) all.push_back(met ? -1.0 : rank_of_early_end(outcome));
  // The outcome has the last word: an outcome earlier in the list hides the later ones, whatever their metrics
  // say.
  if (all.empty()) return {met ? -1.0 : 1.0};
  if (met) {
    for (double& part : all) part = std::min(part, 0.0);
  } else if (*std::max_element(all.begin(), all.end()) <= 0.0) {
    all.back() = kJustBroken;
  }
  return all;
}

std::vector<std::string> event_violation_names(const OutcomeEvent& event, const std::string& text,
                                               const LimitParameters& limits) {
  if (!is_smooth(event)) return {text};
  const EventParts parts = parts_of(event);
  std::vector<std::string> names;
  each_limit(parts, limits,
             [&](const auto& limit, double /*bound*/) { names.push_back(text + ": " + std::string(limit.rule)); });
  if (parts.completed) names.push_back(text + ": the cycle is completed");
  return names.empty() ? std::vector<std::string>{text} : names;
}

double event_measure(const OutcomeEvent& event, const ScenarioResult& result, const LimitParameters& limits) {
  const std::vector<double> parts = event_violations(event, result, limits);
  return std::clamp(*std::max_element(parts.begin(), parts.end()), -1.0, 1.0);
}

}  // namespace unbruised::studies
