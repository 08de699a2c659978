/// @file
/// objective  := ['-'] term (('+' | '-') term)*          term := [number '*'] quantity
/// constraint := event | quantity ('<=' | '>=') number | 'P' '(' event ')' '>=' number
/// quantity   := metric | statistic '(' metric [',' level] ')'
/// event      := all ('or' all)*                          all := ['not'] word ('and' ['not'] word)*
/// What `not` means stands in event.hpp.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "studies/goals/goal.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/key_names.hpp"

namespace unbruised::studies {
namespace {

/// Why a text is no goal.
struct GoalError {
  std::string message;
};

std::vector<std::string> metric_names() {
  std::vector<std::string> names;
  for (const MetricInfo& info : kMetricTable) names.emplace_back(info.name);
  return names;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = nearest(word, known);
  return near.empty() ? std::string() : joined({"; did you mean '", near, "'?"});
}

Metric metric_called(std::string_view name) {
  for (const MetricInfo& info : kMetricTable) {
    if (info.name == name) return info.metric;
  }
  const std::string word(name);
  throw GoalError{joined({"unknown metric '", word, "'", did_you_mean(word, metric_names())})};
}

bool is_blank(char letter) { return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r'; }
bool is_word(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '_';
}

/// Reads one goal from left to right.
class GoalParser {
 public:
  GoalParser(std::string_view text, GoalContext context) : text_(text), rest_(text), context_(context) {}

  Objective objective() {
    Objective goal;
    double sign = take("-") ? -1.0 : 1.0;
    while (true) {
      goal.terms.push_back(term(sign));
      if (take("+")) {
        sign = 1.0;
      } else if (take("-")) {
        sign = -1.0;
      } else {
        break;
      }
    }
    expect_end("'+' or '-' and another term");
    goal.text = trimmed();
    return goal;
  }

  Constraint constraint() {
    Constraint goal;
    goal.text = trimmed();
    if (next_word() == "P") return probability(std::move(goal));
    if (is_event_word(next_word())) {
      goal.event = event();
      expect_end("'and' or 'or' and another outcome");
      if (context_ == GoalContext::sampled) {
        throw GoalError{joined({"say how often: P(", goal.text, ") >= 0.99"})};
      }
      return goal;
    }
    goal.kind = Constraint::Kind::metric;
    goal.term = quantity();
    goal.at_least = comparison();
    goal.bound = number();
    expect_end("nothing more");
    return goal;
  }

 private:
  [[nodiscard]] std::string trimmed() const {
    std::string_view text = text_;
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return std::string(text);
  }

  Constraint probability(Constraint goal) {
    if (context_ == GoalContext::single) {
      throw GoalError{"P(...) needs random products: kind = \"robust\""};
    }
    goal.kind = Constraint::Kind::probability;
    word();
    expect("(");
    goal.event = event();
    expect(")");
    goal.at_least = comparison();
    if (!goal.at_least) throw GoalError{"a probability is bounded from below: P(...) >= number"};
    goal.bound = number();
    if (!(goal.bound > 0.0 && goal.bound <= 1.0)) throw GoalError{"a probability must be > 0 and <= 1"};
    expect_end("nothing more");
    return goal;
  }

  GoalTerm term(double sign) {
    double weight = 1.0;
    skip_blanks();
    if (!rest_.empty() && ((rest_.front() >= '0' && rest_.front() <= '9') || rest_.front() == '.')) {
      weight = number();
      if (!take("*")) throw GoalError{joined({"expected '*' and a metric at ", place()})};
    }
    GoalTerm goal = quantity();
    goal.weight = sign * weight;
    return goal;
  }

  GoalTerm quantity() {
    GoalTerm goal;
    const std::string first(word());
    if (first.empty()) throw GoalError{joined({"expected the name of a metric at ", place()})};
    if (!take("(")) {
      goal.metric = metric_called(first);
      if (context_ == GoalContext::sampled) {
        throw GoalError{joined(
            {"say over which products: mean(", first, "), quantile(", first, ", 0.95) or worst(", first, ")"})};
      }
      return goal;
    }
    goal.statistic = statistic_called(first);
    goal.metric = metric_called(word());
    if (goal.statistic == Statistic::quantile) {
      expect(",");
      goal.level = number();
      if (!(goal.level > 0.0 && goal.level < 1.0)) throw GoalError{"the level of a quantile must be > 0 and < 1"};
    }
    expect(")");
    return goal;
  }

  Statistic statistic_called(const std::string& name) {
    static const std::vector<std::pair<std::string, Statistic>> kNames = {
        {"mean", Statistic::mean}, {"quantile", Statistic::quantile}, {"worst", Statistic::worst}};
    std::vector<std::string> known;
    for (const auto& [word, statistic] : kNames) {
      known.push_back(word);
      if (word != name) continue;
      if (context_ == GoalContext::single) {
        throw GoalError{joined({name, "(...) needs random products: kind = \"robust\""})};
      }
      return statistic;
    }
    const std::string near = did_you_mean(name, known);
    throw GoalError{
        joined({"unknown statistic '", name, "'", near.empty() ? "; known: mean, quantile, worst" : near})};
  }

  static bool is_event_word(std::string_view word) {
    if (word == "not") return true;
    for (const std::string_view outcome : kOutcomeWords) {
      if (word == outcome) return true;
    }
    // A misspelt outcome is told from a misspelt metric by what it is nearest to.
    if (word.empty()) return false;
    std::vector<std::string> known = metric_names();
    known.insert(known.end(), kOutcomeWords.begin(), kOutcomeWords.end());
    for (const char* statistic : {"mean", "quantile", "worst"}) known.emplace_back(statistic);
    const std::string near = nearest(std::string(word), known);
    return std::find(kOutcomeWords.begin(), kOutcomeWords.end(), near) != kOutcomeWords.end();
  }

  OutcomeEvent event() {
    OutcomeEvent any;
    do {
      const OutcomeEvent all = joint_event();
      if (all.endings == 0) throw GoalError{"no outcome is all of that at once"};
      any.endings |= all.endings;
    } while (take_word("or"));
    return any;
  }

  OutcomeEvent joint_event() {
    OutcomeEvent all{(1U << kEndingCount) - 1U};
    do {
      all.endings &= one_event().endings;
    } while (take_word("and"));
    return all;
  }

  OutcomeEvent one_event() {
    const bool negated = next_word() == "not";
    if (negated) word();
    const auto outcome = static_cast<Outcome>(outcome_called(std::string(word())));
    if (!negated) return event_of(outcome);
    if (outcome != Outcome::held) return event_of_not(outcome);
    throw GoalError{"'not held' does not say which ends are meant: name them, e.g. 'slipped or dropped'"};
  }

  static unsigned outcome_called(const std::string& name) {
    for (std::size_t k = 0; k < kOutcomeWords.size(); ++k) {
      if (kOutcomeWords[k] == name) return static_cast<unsigned>(k);
    }
    const std::vector<std::string> known(kOutcomeWords.begin(), kOutcomeWords.end());
    const std::string near = did_you_mean(name, known);
    throw GoalError{
        joined({"unknown outcome '", name, "'", near.empty() ? "; known: " + separated(known, ", ") : near})};
  }

  /// true: >=
  bool comparison() {
    if (take(">=")) return true;
    if (take("<=")) return false;
    throw GoalError{joined({"expected '<=' or '>=' at ", place()})};
  }

  double number() {
    skip_blanks();
    double value = 0.0;
    const char* end = rest_.data() + rest_.size();
    const bool plus = rest_.starts_with("+");
    const auto [last, error] = std::from_chars(rest_.data() + (plus ? 1 : 0), end, value);
    if (error != std::errc{} || !std::isfinite(value)) throw GoalError{joined({"expected a number at ", place()})};
    rest_.remove_prefix(static_cast<std::size_t>(last - rest_.data()));
    return value;
  }

  void skip_blanks() {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  }

  [[nodiscard]] std::string_view next_word() {
    skip_blanks();
    std::size_t length = 0;
    while (length < rest_.size() && is_word(rest_[length])) ++length;
    return rest_.substr(0, length);
  }
  std::string_view word() {
    const std::string_view next = next_word();
    rest_.remove_prefix(next.size());
    return next;
  }
  bool take_word(std::string_view wanted) {
    if (next_word() != wanted) return false;
    word();
    return true;
  }
  bool take(std::string_view symbol) {
    skip_blanks();
    if (!rest_.starts_with(symbol)) return false;
    rest_.remove_prefix(symbol.size());
    return true;
  }
  void expect(std::string_view symbol) {
    if (!take(symbol)) throw GoalError{joined({"expected '", symbol, "' at ", place()})};
  }
  void expect_end(std::string_view allowed) {
    skip_blanks();
    if (!rest_.empty()) throw GoalError{joined({"expected ", allowed, " at ", place()})};
  }
  [[nodiscard]] std::string place() {
    skip_blanks();
    return rest_.empty() ? "its end" : joined({"'", rest_.substr(0, 20), "'"});
  }

  std::string_view text_;
  std::string_view rest_;
  GoalContext context_;
};

}  // namespace

Parsed<Objective> parse_objective(std::string_view text, GoalContext context) {
  try {
    return GoalParser(text, context).objective();
  } catch (GoalError& error) {
    return std::move(error.message);
  }
}

Parsed<Constraint> parse_constraint(std::string_view text, GoalContext context) {
  try {
    return GoalParser(text, context).constraint();
  } catch (GoalError& error) {
    return std::move(error.message);
  }
}

Parsed<Metric> parse_metric(std::string_view name) {
  try {
    return metric_called(name);
  } catch (GoalError& error) {
    return std::move(error.message);
  }
}

}  // namespace unbruised::studies
