#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

#include "studies/config/search_parts.hpp"

namespace unbruised::studies {
namespace {

/// Searches share the budget; by default each has this much.
constexpr std::uint64_t kEvaluationsPerSearch = 40;

/// The goals of [search], [compare] and [sensitivity], parsed and checked.
class StudyGoals {
 public:
  explicit StudyGoals(const SearchInput& input)
      : data_(input.data), read_(input.read), base_(input.base), problems_(input.problems) {}

  void add_search() {
    SearchTable& table = data_.settings.search;
    SearchSettings& search = data_.search;
    const GoalContext context = goal_context();
    set_defaults_by_kind(table);
    if (has_several_objectives(kind())) {
      add_objectives(table, search, context);
    } else if (!is_left_out(table.objective)) {
      auto goal = parsed("search.objective", table.objective, parse_objective(table.objective, context));
      if (goal) search.objective = std::move(*goal);
    }
    for (std::size_t i = 0; i < table.constraints.size(); ++i) {
      const std::string& text = table.constraints[i];
      auto goal = parsed(element("search.constraints", i), text, parse_constraint(text, context));
      if (goal) search.constraints.push_back(std::move(*goal));
    }
    // A list that says nothing about outcomes adds to `held`: nobody wants the fastest way to drop a product.
    const bool has_outcome = std::any_of(search.constraints.begin(), search.constraints.end(),
                                         [](const Constraint& c) { return c.kind != Constraint::Kind::metric; });
    if (!has_outcome && !table.constraints.empty()) {
      table.constraints.push_back(held_rule(context));
      search.constraints.push_back(parse_constraint(held_rule(context), context).value());
      std::rotate(table.constraints.begin(), std::prev(table.constraints.end()), table.constraints.end());
      std::rotate(search.constraints.begin(), std::prev(search.constraints.end()), search.constraints.end());
    }
    search.algorithm = table.algorithm;
    search.starts = table.starts;
    search.budget = table.budget;
    search.tolerance = table.tolerance;
    search.initial_step = table.initial_step;
    search.method = table.method;
    search.points = table.points;
    check_algorithm(table);
    check_budget(table);
  }

  void add_compare() {
    const CompareTable& table = data_.settings.compare;
    data_.compare.tie = table.tie;
    if (auto metric = parsed("compare.metric", table.metric, parse_metric(table.metric))) {
      data_.compare.metric = *metric;
    }
    data_.compare.metrics = {data_.compare.metric};
    for (const Metric metric : metrics_of("compare.metrics", table.metrics)) {
      if (metric != data_.compare.metric) data_.compare.metrics.push_back(metric);
    }
  }

  void add_sensitivity() {
    const SensitivityTable& table = data_.settings.sensitivity;
    data_.sensitivity = {.method = table.method,
                         .metrics = metrics_of("sensitivity.metrics", table.metrics),
                         .samples = table.samples,
                         .levels = table.levels,
                         .bootstrap = table.bootstrap,
                         .confidence = table.confidence};
    if (table.metrics.empty() && base_.given.contains("sensitivity.metrics") && !is_left_out(table.metrics)) {
      problems_.add(base_.origin_of("sensitivity.metrics"), "sensitivity.metrics", "must name a metric");
    }
    if (table.levels % 2 != 0) {
      problems_.add(base_.origin_of("sensitivity.levels"), "sensitivity.levels", std::to_string(table.levels),
                    "must be even");
    }
    const double runs = static_cast<double>(table.samples) * static_cast<double>(data_.randoms.size() + 2);
    if (runs > static_cast<double>(kMaxScenarios)) {
      problems_.add(base_.origin_of("sensitivity.samples"), "sensitivity.samples", std::to_string(table.samples),
                    "more than 10,000,000 scenarios");
    }
  }

 private:
  [[nodiscard]] StudyKind kind() const { return data_.settings.kind; }

  template <class Goal>
  std::optional<Goal> parsed(const std::string& path, const std::string& text, Parsed<Goal> goal) {
    if (goal) return *std::move(goal);
    // The place of an element is that of its array.
    const std::string key = path.substr(0, path.find('['));
    problems_.add(base_.origin_of(key), path, toml_string(text), goal.error());
    return std::nullopt;
  }

  static std::string element(const std::string& path, std::size_t i) {
    return path + "[" + std::to_string(i) + "]";
  }

  /// An empty value beside other mistakes may be one of them: it could not be read.
  template <class Text>
  [[nodiscard]] bool is_left_out(const Text& value) const {
    return value.empty() && !problems_.empty();
  }

  void set_defaults_by_kind(SearchTable& table) const {
    const GoalContext context = goal_context();
    const bool sampled = context == GoalContext::sampled;
    const auto given = [&](const char* key) { return base_.given.contains(key); };
    if (!given("search.objective")) table.objective = sampled ? "mean(cycle_time_s)" : "cycle_time_s";
    if (!given("search.constraints")) table.constraints = {held_rule(context)};
    if (!given("search.starts")) {
      if (sampled) table.starts = 4;
      if (has_several_objectives(kind())) table.starts = 2;
    }
    if (given("search.budget")) return;
    table.budget = sampled ? std::max<std::uint64_t>(100, table.starts) : kEvaluationsPerSearch * searches(table);
  }

  [[nodiscard]] GoalContext goal_context() const {
    return is_sampled_search(kind()) ? GoalContext::sampled : GoalContext::single;
  }

  static std::string held_rule(GoalContext context) {
    return context == GoalContext::sampled ? "P(held) >= 0.99" : "held";
  }

  /// Searches of the whole study.
  [[nodiscard]] std::uint64_t searches(const SearchTable& table) const {
    if (!has_several_objectives(kind())) return table.starts;
    return pareto_search_count(table.objectives.size(), table.points, table.starts);
  }

  void add_objectives(const SearchTable& table, SearchSettings& search, GoalContext context) {
    if (table.objectives.size() < 2 || table.objectives.size() > 3) {
      if (base_.given.contains("search.objectives") && !is_left_out(table.objectives)) {
        problems_.add(base_.origin_of("search.objectives"), "search.objectives", "must be two or three");
      }
      return;
    }
    for (std::size_t i = 0; i < table.objectives.size(); ++i) {
      const std::string& text = table.objectives[i];
      auto goal = parsed(element("search.objectives", i), text, parse_objective(text, context));
      if (goal) search.objectives.push_back(std::move(*goal));
    }
  }

  void check_algorithm(const SearchTable& table) {
    SearchSettings& search = data_.search;
    if (!table.local_algorithm.empty()) {
      search.local = optimizer::algorithm_named(table.local_algorithm);
      if (!search.local) {
        const KeySpec& words = *find_key("search.algorithm").spec;
        problems_.add(base_.origin_of("search.local_algorithm"), "search.local_algorithm",
                      toml_string(table.local_algorithm),
                      *check_value(words, text_value(table.local_algorithm), 0));
        return;
      }
    }
    if (data_.variables.empty() || data_.variables.size() != read_.blocks.variable.size()) return;
    std::size_t constraints = has_several_objectives(kind()) ? 1 : 0;  // those of the method
    for (const Constraint& constraint : search.constraints) {
      constraints +=
          is_sampled_search(kind()) ? 1 : violation_names(constraint, data_.bases.front().limits).size();
    }
    const std::string why =
        optimizer::why_unsuitable(search.algorithm, search.local, data_.variables.size(), constraints);
    if (why.empty()) return;
    const bool is_local =
        search.local && (constraints == 0 || optimizer::info_of(search.algorithm).takes_constraints);
    const std::string key = is_local ? "search.local_algorithm" : "search.algorithm";
    problems_.add(base_.origin_of(key), key,
                  toml_string(optimizer::info_of(is_local ? *search.local : search.algorithm).name), why);
  }

  void check_budget(const SearchTable& table) {
    const std::uint64_t needed = searches(table);
    if (table.budget >= needed) return;
    problems_.add(base_.origin_of("search.budget"), "search.budget", std::to_string(table.budget),
                  "must be >= the number of searches, " + std::to_string(needed));
  }

  std::vector<Metric> metrics_of(const std::string& path, const std::vector<std::string>& names) {
    std::vector<Metric> metrics;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (const auto metric = parsed(element(path, i), names[i], parse_metric(names[i])))
        metrics.push_back(*metric);
    }
    return metrics;
  }

  StudyData& data_;
  const ReadBlocks& read_;
  const Assembly& base_;
  Problems& problems_;
};

}  // namespace

void add_goals(const SearchInput& input) {
  StudyGoals goals(input);
  const StudyKind kind = input.data.settings.kind;
  if (is_search(kind)) goals.add_search();
  if (kind_uses(Use::candidates, kind)) goals.add_compare();
  if (kind_uses(Use::design, kind)) goals.add_sensitivity();
}

}  // namespace unbruised::studies
