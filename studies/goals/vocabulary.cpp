#include "studies/goals/vocabulary.hpp"

#include <algorithm>

#include "core/outcome/damage_limits.hpp"
#include "studies/goals/goal.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// A word of the grammar, or of an answer.
struct PlainWord {
  std::string_view word;
  std::string_view meaning;
  std::string_view example;  ///< as it is written; may be empty
};

constexpr PlainWord kGoalWords[] = {
    {"objective",
     "what is to be least: [-] term + term ..., each term a metric or a number times a metric; of "
     "random products a statistic of a metric. A leading minus asks for the most",
     "\"cycle_time_s + 0.5 * peak_finger_force_N\", \"mean(cycle_time_s)\""},
    {"constraint", "what has to hold: an outcome, a metric with <= or >= and a number, or P(outcome) >= a number",
     "\"held\", \"friction_margin_min >= 0.2\", \"P(held) >= 0.95\""},
    {"P",
     "the part of the random products for which an outcome happens; it is bounded from below, 0 < bound <= 1 "
     "(robust studies)",
     "\"P(held) >= 0.95\", \"P(not damaged and not dropped) >= 0.99\""},
    {"mean", "the mean of a metric over the random products that have it (robust studies)",
     "\"mean(cycle_time_s)\""},
    {"quantile",
     "the value that the given part of the random products stays below, 0 < level < 1; a product "
     "without the metric counts as the worst (robust studies)",
     "\"quantile(permanent_set_max_m, 0.95) <= 1e-4\""},
    {"worst",
     "the worst value of a metric over the random products; a product without the metric counts as the "
     "worst (robust studies)",
     "\"worst(peak_finger_force_N) <= 5\""},
    {"not", "turns an outcome round", "\"not damaged\""},
    {"and", "both outcomes at once", "\"not dropped and not slipped\""},
};

constexpr PlainWord kAnswerWords[] = {
    {"F_hold",
     "lower end of the grip window: the least grip force in N at which the product is held "
     "(window/hold_force_N in results.h5)",
     ""},
    {"F_damage",
     "upper end of the grip window: the greatest grip force in N at which no damage limit is exceeded "
     "(window/damage_force_N in results.h5)",
     ""},
    {"margin", "width of the grip window against its lower end: F_damage / F_hold - 1", ""},
    {"bracket", "the two forces between which an end of the window is known to lie", ""},
    {"digest",
     "one number over every bit of every scenario: the same study gives the same digest, whatever the "
     "threads, the order and the interruptions",
     ""},
};

std::string entry(std::string_view word, std::string_view meaning, std::string_view example) {
  std::string text = joined({word, "\n  ", meaning, "\n"});
  if (!example.empty()) text += joined({"  as in: ", example, "\n"});
  return text;
}

std::string explain(const MetricInfo& metric) {
  std::string text = joined({metric.name, "\n  metric of a scenario: ", metric.long_name, "\n"});
  text += joined({"  unit: ", unit_text(metric.units), "\n"});
  for (const DamageLimit& limit : kDamageLimits) {
    if (limit.metric == metric.metric)
      text += joined({"  limit: ", limit.rule, ", else the product is damaged\n"});
  }
  for (const SlipLimit& limit : kSlipLimits) {
    if (limit.metric == metric.metric) text += joined({"  limit: ", limit.rule, ", else it has slipped\n"});
  }
  const bool more = more_is_better(metric.metric);
  return text + joined({"  better: ", more ? "more" : "less", "; as in: \"", metric.name,
                        more ? " >= " : " <= ", "NUMBER\", of random products \"mean(", metric.name, ")\"\n"});
}

std::string explain(const OutcomeMeaning& meaning) {
  const std::string_view word = outcome_word(meaning.outcome);
  const std::string_view when = meaning.outcome == Outcome::held
                                    ? "not dropped, not slipped, no limit exceeded, the run went to its end"
                                    : meaning.when;
  const std::string code = std::to_string(static_cast<int>(meaning.outcome));
  // What is not held has no one meaning: dropped, damaged ... are words of their own.
  const std::string turned = meaning.outcome == Outcome::held ? std::string() : joined({"\"not ", word, "\", "});
  return joined({word, "\n  outcome ", code, " of a scenario: ", when, "\n  as in: \"", word, "\", ", turned,
                 "of random products \"P(", word, ") >= 0.95\"\n"});
}

std::string explain(const PlainWord& word) { return entry(word.word, word.meaning, word.example); }

/// All rows of a table, a blank line between them.
template <class Table>
std::string explain_all_of(const Table& table) {
  return separated(table, "\n", [](const auto& row) { return explain(row); });
}

}  // namespace

std::string unit_text(std::string_view udunits) {
  if (udunits == "1") return "none (a ratio or a count)";
  std::string text(udunits);
  for (std::size_t at = text.find(" s-"); at != std::string::npos; at = text.find(" s-"))
    text.replace(at, 3, "/s");
  if (text.ends_with("/s1")) text.pop_back();
  return text;
}

std::optional<std::string> explain_word(std::string_view word) {
  if (word == "metrics") return explain_all_of(kMetricTable);
  if (word == "outcomes") return explain_all_of(kOutcomeMeanings);
  if (word == "goals") return explain_all_of(kGoalWords);
  for (const MetricInfo& metric : kMetricTable) {
    if (metric.name == word) return explain(metric);
  }
  for (const OutcomeMeaning& meaning : kOutcomeMeanings) {
    if (outcome_word(meaning.outcome) == word) return explain(meaning);
  }
  for (const PlainWord& plain : kGoalWords) {
    if (plain.word == word) return explain(plain);
  }
  for (const PlainWord& plain : kAnswerWords) {
    if (plain.word == word) return explain(plain);
  }
  return std::nullopt;
}

std::vector<std::string> vocabulary() {
  std::vector<std::string> words = {"metrics", "outcomes", "goals"};
  for (const MetricInfo& metric : kMetricTable) words.emplace_back(metric.name);
  for (const OutcomeMeaning& meaning : kOutcomeMeanings) words.emplace_back(outcome_word(meaning.outcome));
  for (const PlainWord& plain : kGoalWords) words.emplace_back(plain.word);
  for (const PlainWord& plain : kAnswerWords) words.emplace_back(plain.word);
  return words;
}

}  // namespace unbruised::studies
