#include "studies/findings/window_answer.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "studies/findings/grip_window.hpp"
#include "studies/findings/key_columns.hpp"
#include "studies/findings/key_roles.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/key_names.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

constexpr const char* kNoneAtHalfStep = "no window at half the time step";

/// How much the half time step narrows an end of a row: >= 1 for the lower, <= 1 for the upper one.
double hold_factor(const WindowRow& row) {
  const double factor = row.hold_force_half_step_N / row.hold_bracket_high_N;
  return std::isnan(factor) ? 1.0 : std::max(1.0, factor);
}
double damage_factor(const WindowRow& row) {
  const double factor = row.damage_force_half_step_N / row.damage_bracket_low_N;
  return std::isnan(factor) ? 1.0 : std::min(1.0, factor);
}

SafeForces safe_forces(const WindowRow& row) {
  const double least_N = row.hold_bracket_high_N * hold_factor(row);
  const double greatest_N = row.damage_bracket_low_N * damage_factor(row);
  return {.exists = row.exists && !(least_N > greatest_N), .least_N = least_N, .greatest_N = greatest_N};
}

/// The held rows of each combination of the window table: force and cycle time.
class CycleTimes {
 public:
  CycleTimes(const WindowTable& window, const std::vector<ColumnInfo>& inputs, const StudyRows& rows) {
    std::vector<std::size_t> places;
    for (const ColumnInfo& wanted : window.inputs) {
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (inputs[i].key == wanted.key) places.push_back(i);
      }
    }
    std::size_t force = inputs.size();
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (inputs[i].key == kGripForceKey) force = i;
    }
    for (const ScenarioRow& row : rows) {
      if (row.result.outcome != Outcome::held || row.inputs.size() != inputs.size() || force == inputs.size())
        continue;
      const auto* force_N = std::get_if<double>(&row.inputs[force]);
      if (force_N == nullptr) continue;
      held_[picked(row.inputs, places)].emplace_back(*force_N, row.result.metrics[Metric::cycle_time_s]);
    }
  }

  /// Of the held run whose force is nearest; NaN: none.
  [[nodiscard]] double near(const WindowRow& row, double force_N) const {
    const auto found = held_.find(row.inputs);
    if (found == held_.end()) return kAbsent;
    const auto nearest =
        std::min_element(found->second.begin(), found->second.end(), [force_N](const auto& a, const auto& b) {
          return std::abs(std::log(a.first / force_N)) < std::abs(std::log(b.first / force_N));
        });
    return nearest->second;
  }

 private:
  std::map<std::vector<InputValue>, std::vector<std::pair<double, double>>> held_;
};

void find_ends(StrategyWindow& strategy, const WindowTable& window) {
  std::vector<WindowRow> own = picked(window.rows, strategy.rows);
  const CommonWindow common = common_window(own);
  strategy.exists = common.exists;
  strategy.hold_force_N = common.hold_force_N;
  strategy.damage_force_N = common.damage_force_N;
  strategy.hold_is_bound = common.hold_is_bound;
  strategy.damage_is_bound = common.damage_is_bound;
  const auto place = [&](const WindowRow* row) {
    return strategy.rows[static_cast<std::size_t>(row - own.data())];
  };
  if (common.hold_row != nullptr) strategy.hold_row = place(common.hold_row);
  if (common.damage_row != nullptr) strategy.damage_row = place(common.damage_row);
}

/// The common window; what half the time step does to any of the rows is taken to happen to all of them.
SafeForces safe_forces(const StrategyWindow& strategy, const WindowTable& window) {
  double hold = 1.0;
  double damage = 1.0;
  bool is_judged = true;
  for (const std::size_t row : strategy.rows) {
    hold = std::max(hold, hold_factor(window.rows[row]));
    damage = std::min(damage, damage_factor(window.rows[row]));
    if (std::isnan(window.rows[row].damage_bracket_low_N)) is_judged = false;
  }
  const double least_N = strategy.hold_force_N * hold;
  const double greatest_N = is_judged ? strategy.damage_force_N * damage : kAbsent;
  return {.exists = strategy.exists && !(least_N > greatest_N), .least_N = least_N, .greatest_N = greatest_N};
}

std::string rows_text(std::size_t without, std::size_t all) {
  return all == 1
             ? std::string("no window")
             : joined({"no window in ", std::to_string(without), " of ", std::to_string(all), " combinations"});
}

void find_set_point(StrategyWindow& strategy, const WindowTable& window, const SettingOfRow& setting) {
  strategy.set_point = set_point(safe_forces(strategy, window), setting(strategy.rows.front()));
  if (strategy.exists) {
    if (!safe_forces(strategy, window).exists) strategy.set_point.sentence = kNoneAtHalfStep;
    return;
  }
  const auto without = static_cast<std::size_t>(std::count_if(
      strategy.rows.begin(), strategy.rows.end(), [&](std::size_t i) { return !window.rows[i].exists; }));
  strategy.set_point.sentence = without > 0 ? rows_text(without, strategy.rows.size()) : "no window common to all";
}

/// The values of the keys that stand apart: strategies with equal ones compete for the shortest cycle.
std::vector<InputValue> apart_values(const WindowAnswer& answer, const StrategyWindow& strategy) {
  std::vector<InputValue> values;
  for (std::size_t i = 0; i < answer.keys.size(); ++i) {
    if (key_role(answer.keys[i].key) == KeyRole::apart) values.push_back(strategy.values[i]);
  }
  return values;
}

bool is_faster(const StrategyWindow& a, const StrategyWindow& b) {
  if (std::isnan(b.cycle_time_s)) return !std::isnan(a.cycle_time_s);
  return a.cycle_time_s < b.cycle_time_s;
}

void mark_best(WindowAnswer& answer) {
  std::map<std::vector<InputValue>, StrategyWindow*> best;
  for (StrategyWindow& strategy : answer.strategies) {
    if (!strategy.set_point.exists) continue;
    StrategyWindow*& fastest = best[apart_values(answer, strategy)];
    if (fastest == nullptr || is_faster(strategy, *fastest)) fastest = &strategy;
  }
  for (const auto& [values, strategy] : best) strategy->is_best = true;
}

ResultColumn number_column(const char* name, const char* units, const char* long_name,
                           const std::vector<StrategyWindow>& strategies,
                           const std::function<double(const StrategyWindow&)>& value) {
  std::vector<double> values;
  for (const StrategyWindow& strategy : strategies) values.push_back(value(strategy));
  return {name, units, long_name, std::move(values)};
}

double as_number(const std::optional<std::size_t>& row) { return row ? static_cast<double>(*row) : kAbsent; }

}  // namespace

void add_set_points(WindowTable& window, const SettingOfRow& setting) {
  for (std::size_t i = 0; i < window.rows.size(); ++i) {
    WindowRow& row = window.rows[i];
    SetPoint found = set_point(safe_forces(row), setting(i));
    if (row.exists && !safe_forces(row).exists) found.sentence = kNoneAtHalfStep;
    row.set_point_exists = found.exists;
    row.set_point_N = found.force_N;
    row.set_point_tolerance_N = found.tolerance_N;
    row.set_point_note = found.sentence;
  }
}

WindowAnswer window_answer(const WindowTable& window, const SettingOfRow& setting,
                           const std::vector<ColumnInfo>& inputs, const StudyRows& rows) {
  const KeyPlaces places = key_places(window.inputs);
  WindowAnswer answer;
  answer.keys = picked(window.inputs, places.others);
  answer.over = picked(window.inputs, places.given);
  std::map<std::vector<InputValue>, std::size_t> place_of;
  for (std::size_t i = 0; i < window.rows.size(); ++i) {
    std::vector<InputValue> values = picked(window.rows[i].inputs, places.others);
    const auto [found, is_new] = place_of.try_emplace(values, answer.strategies.size());
    if (is_new) answer.strategies.emplace_back().values = std::move(values);
    answer.strategies[found->second].rows.push_back(i);
  }
  const CycleTimes cycles(window, inputs, rows);
  for (StrategyWindow& strategy : answer.strategies) {
    find_ends(strategy, window);
    find_set_point(strategy, window, setting);
    if (!strategy.set_point.exists) continue;
    for (const std::size_t row : strategy.rows) {
      strategy.cycle_time_s =
          std::fmax(strategy.cycle_time_s, cycles.near(window.rows[row], strategy.set_point.force_N));
    }
  }
  mark_best(answer);
  return answer;
}

const StrategyWindow* fastest_best(const WindowAnswer& answer) {
  const StrategyWindow* best = nullptr;
  for (const StrategyWindow& strategy : answer.strategies) {
    if (strategy.is_best && (best == nullptr || is_faster(strategy, *best))) best = &strategy;
  }
  return best;
}

namespace {

/// nullptr: there is no strategy at all.
const StrategyWindow* told_strategy(const WindowAnswer& answer) {
  if (const StrategyWindow* best = fastest_best(answer)) return best;
  const auto exists = std::find_if(answer.strategies.begin(), answer.strategies.end(),
                                   [](const StrategyWindow& strategy) { return strategy.exists; });
  if (exists != answer.strategies.end()) return &*exists;
  return answer.strategies.empty() ? nullptr : &answer.strategies.front();
}

/// "approach speed 0.2 m/s"; of a file its name.
std::string value_words(const ColumnInfo& key, const InputValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    return joined({key_words(key.key), " ", std::filesystem::path(*text).stem().string()});
  }
  const Unit* unit = unit_of(key.key);
  return joined({key_words(key.key), " ", short_number(std::get<double>(value)),
                 unit == nullptr ? std::string() : joined({" ", unit->display})});
}

std::string end_words(const char* name, double force_N) {
  return std::isnan(force_N) ? std::string() : joined({name, " ", short_number(force_N), " N"});
}

/// "set 2 N, may be off by 1 N either way (F_hold 1 N, F_damage 4 N; approach speed 0.2 m/s)"
std::string answer_sentence(const StrategyWindow& told, const WindowAnswer& answer) {
  std::vector<std::string> ends;
  if (told.exists) {
    for (const std::string& end :
         {end_words("F_hold", told.hold_force_N), end_words("F_damage", told.damage_force_N)}) {
      if (!end.empty()) ends.push_back(end);
    }
  }
  std::vector<std::string> at;
  for (std::size_t k = 0; k < answer.keys.size(); ++k) at.push_back(value_words(answer.keys[k], told.values[k]));
  const std::string head = told.set_point.exists || blames_gripper(told.set_point.sentence) || !told.exists
                               ? told.set_point.sentence
                               : joined({"no set-point: ", told.set_point.sentence});
  const bool both = !ends.empty() && !at.empty();
  if (ends.empty() && at.empty()) return head;
  return joined({head, " (", comma_list(ends), both ? "; " : "", comma_list(at), ")"});
}

}  // namespace

ResultTable set_points_table(const WindowAnswer& answer) {
  const std::vector<StrategyWindow>& all = answer.strategies;
  ResultTable table{.name = "set_points", .row = "strategy_number", .columns = {}, .attributes = {}};
  for (std::size_t k = 0; k < answer.keys.size(); ++k) {
    std::vector<InputValue> values;
    for (const StrategyWindow& strategy : all) values.push_back(strategy.values[k]);
    table.columns.push_back(key_column(answer.keys[k], values));
  }
  const auto add = [&](const char* name, const char* units, const char* long_name,
                       const std::function<double(const StrategyWindow&)>& value) {
    table.columns.push_back(number_column(name, units, long_name, all, value));
  };
  using S = const StrategyWindow&;
  add("exists", "1", "1: some force holds over all combinations and marks in none",
      [](S s) { return s.exists ? 1.0 : 0.0; });
  add("hold_force_N", "N", "largest F_hold of the combinations", [](S s) { return s.hold_force_N; });
  add("damage_force_N", "N", "smallest F_damage of the combinations", [](S s) { return s.damage_force_N; });
  add("hold_is_bound", "1", "1: the least force tried holds already",
      [](S s) { return s.hold_is_bound ? 1.0 : 0.0; });
  add("damage_is_bound", "1", "1: the greatest force tried does not damage",
      [](S s) { return s.damage_is_bound ? 1.0 : 0.0; });
  add("hold_row", "1", "row of /window that sets F_hold", [](S s) { return as_number(s.hold_row); });
  add("damage_row", "1", "row of /window that sets F_damage", [](S s) { return as_number(s.damage_row); });
  add("combinations", "1", "rows of /window that the answer holds over",
      [](S s) { return static_cast<double>(s.rows.size()); });
  add("set_point_exists", "1", "1: this gripper can set and keep a force in the window",
      [](S s) { return s.set_point.exists ? 1.0 : 0.0; });
  add("set_point_N", "N", "grip force to set", [](S s) { return s.set_point.force_N; });
  add("set_point_tolerance_N", "N", "the setting may be off by this either way",
      [](S s) { return s.set_point.tolerance_N; });
  add("cycle_time_s", "s", "longest of the combinations, near the set-point", [](S s) { return s.cycle_time_s; });
  add("best", "1", "1: shortest cycle of those with a set-point", [](S s) { return s.is_best ? 1.0 : 0.0; });
  std::vector<std::string> notes;
  for (const StrategyWindow& strategy : all) notes.push_back(strategy.set_point.sentence);
  table.columns.push_back({"note", "", "the set-point, or why there is none", std::move(notes)});
  table.attributes.emplace_back("over", leaves_text(answer.over));
  if (const StrategyWindow* told = told_strategy(answer)) {
    table.attributes.emplace_back("told", static_cast<double>(told - all.data()));
    table.attributes.emplace_back("answer", answer_sentence(*told, answer));
  }
  return table;
}

}  // namespace unbruised::studies
