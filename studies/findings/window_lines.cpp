#include "studies/findings/window_lines.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "studies/findings/half_step_text.hpp"
#include "studies/findings/set_point.hpp"
#include "studies/findings/summary.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// "(1.05, 1.12]": the force is above the first and at most the second.
std::string hold_bracket_text(const WindowRow& row) {
  if (std::isnan(row.hold_bracket_low_N)) return joined({"at or below ", short_number(row.hold_bracket_high_N)});
  return joined({"in (", short_number(row.hold_bracket_low_N), ", ", short_number(row.hold_bracket_high_N), "]"});
}

std::string damage_bracket_text(const WindowRow& row) {
  if (std::isnan(row.damage_bracket_high_N))
    return joined({"at or above ", short_number(row.damage_bracket_low_N)});
  return joined(
      {"in [", short_number(row.damage_bracket_low_N), ", ", short_number(row.damage_bracket_high_N), ")"});
}

/// An end of a window as it is told.
struct ToldEnd {
  double force_N = 0.0;
  bool is_bound = false;  ///< the range that was searched ends there, not the window
};

std::string ends_text(const ToldEnd& hold, const ToldEnd& damage) {
  return joined({hold.is_bound ? "[<= " : "[", short_number(hold.force_N), ", ", damage.is_bound ? ">= " : "",
                 short_number(damage.force_N), "] N"});
}

/// Wide windows are told as a factor: nobody pictures 2,888 %.
std::string margin_text(double margin) {
  constexpr double kAsFactorFrom = 2.0;
  return margin < kAsFactorFrom ? joined({"margin ", percent(margin)})
                                : joined({"F_damage is ", three_digits(margin + 1.0), " times F_hold"});
}

/// "[1.12, 2.31] N, margin 106 % (F_hold in ..., F_damage in ...)", or the note that says why there is none.
std::string window_text(const WindowRow& row) {
  if (!row.exists) return row.note;
  if (std::isnan(row.damage_bracket_low_N)) {  // damage is not judged: the note says so
    return joined({"held from ", short_number(row.hold_bracket_high_N), " N on (F_hold ", hold_bracket_text(row),
                   "); ", row.note});
  }
  std::string text = ends_text({row.hold_bracket_high_N, std::isnan(row.hold_bracket_low_N)},
                               {row.damage_bracket_low_N, std::isnan(row.damage_bracket_high_N)});
  if (!std::isnan(row.margin)) text += joined({", ", margin_text(row.margin)});
  text += joined({" (F_hold ", hold_bracket_text(row), ", F_damage ", damage_bracket_text(row), ")"});
  if (!row.note.empty()) text += joined({"; ", row.note});
  return text;
}

/// With more keys than these only those are told that differ from the first combination.
constexpr std::size_t kKeysToldAll = 3;

/// " at friction = 0.4, else as the first"; empty without keys.
std::string at_values(const std::vector<std::string>& own, const std::vector<std::string>& first) {
  if (own.empty()) return {};
  std::vector<std::string> differing;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i] != first[i]) differing.push_back(own[i]);
  }
  if (own.size() <= kKeysToldAll || differing.empty()) return joined({" at ", comma_list(own)});
  return joined({" at ", comma_list(differing), ", else as the first"});
}

std::string at_text(const WindowTable& window, const WindowRow& row) {
  return at_values(input_texts(window.inputs, row.inputs), input_texts(window.inputs, window.rows.front().inputs));
}

std::string combination_line(const WindowTable& window, const WindowRow& row) {
  if (row.exists) return joined({"grip window", at_text(window, row), ": ", window_text(row)});
  // The note begins with the words "no window" itself.
  constexpr std::string_view kBegin = "no window: ";
  const std::string_view note = row.note;
  return joined(
      {"no window", at_text(window, row), ": ", note.starts_with(kBegin) ? note.substr(kBegin.size()) : note});
}

/// "checked at half the time step, at speed = 0.1: F_hold stays at 1 N, F_damage falls from 4.81 to 3.69 N (-23
/// %)"
void add_half_step(const WindowTable& window, std::vector<std::string>& lines) {
  for (const WindowRow& row : window.rows) {
    const std::string text = comma_list(half_step_moves(row), move_text);
    if (text.empty()) continue;
    const std::string at = at_text(window, row);
    lines.push_back(joined({"checked at half the time step", at.empty() ? "" : ",", at, ": ", text}));
  }
}

/// What the lines about strategies are made from.
class SetPointLines {
 public:
  SetPointLines(const WindowTable& window, const ResultTable& table, std::size_t most)
      : window_(window), table_(table), over_(text_attribute(table, "over")), most_(most) {}

  std::vector<std::string> all() {
    const std::size_t count = row_count(table_);
    for (std::size_t i = 0; i < std::min(count, most_); ++i) {
      if (!over_.empty()) lines_.push_back(common_line(i));
      lines_.push_back(set_point_line(i));
    }
    if (count > most_)
      lines_.push_back(joined({"... and ", std::to_string(count - most_), " more in /set_points"}));
    if (count > 1) add_best();
    return std::move(lines_);
  }

 private:
  [[nodiscard]] double number(const char* column, std::size_t i) const { return number_in(table_, column, i); }
  [[nodiscard]] bool flag(const char* column, std::size_t i) const { return number(column, i) == 1.0; }

  [[nodiscard]] const WindowRow* window_row(const char* column, std::size_t i) const {
    const double row = number(column, i);
    return row >= 0.0 && row < static_cast<double>(window_.rows.size())
               ? &window_.rows[static_cast<std::size_t>(row)]
               : nullptr;
  }

  [[nodiscard]] std::string at_keys(std::size_t i) const {
    return at_values(key_texts(table_, i), key_texts(table_, 0));
  }

  [[nodiscard]] std::string common_line(std::size_t i) const {
    const WindowRow* hold = window_row("hold_row", i);
    const WindowRow* damage = window_row("damage_row", i);
    if (hold == nullptr) return joined({"no window", at_keys(i), " for any ", over_});
    const double hold_N = number("hold_force_N", i);
    if (damage == nullptr) {
      return joined({"held over all ", over_, at_keys(i), " from ", short_number(hold_N), " N on (F_hold ",
                     hold_bracket_text(*hold), at_text(window_, *hold), ")"});
    }
    const double damage_N = number("damage_force_N", i);
    if (flag("exists", i)) {
      return joined({"grip window over all ", over_, at_keys(i), ": ",
                     ends_text({hold_N, flag("hold_is_bound", i)}, {damage_N, flag("damage_is_bound", i)}),
                     " (F_hold ", hold_bracket_text(*hold), at_text(window_, *hold), "; F_damage ",
                     damage_bracket_text(*damage), at_text(window_, *damage), ")"});
    }
    if (hold_N > damage_N && (flag("hold_is_bound", i) || flag("damage_is_bound", i))) {
      return joined({"no force was tried that could suit all ", over_, at_keys(i), ": forces from ",
                     short_number(hold_N), " N on", at_text(window_, *hold), ", up to ", short_number(damage_N),
                     " N", at_text(window_, *damage)});
    }
    if (hold_N <= damage_N) return joined({"no window common to all ", over_, at_keys(i), ": ", without_text(i)});
    return joined({"no window common to all ", over_, at_keys(i), ": holding needs ", short_number(hold_N), " N",
                   at_text(window_, *hold), ", but damage begins above ", short_number(damage_N), " N",
                   at_text(window_, *damage)});
  }

  [[nodiscard]] std::string without_text(std::size_t i) const { return text_in(table_, "note", i); }

  [[nodiscard]] std::string set_point_line(std::size_t i) const {
    const std::string note = text_in(table_, "note", i);
    if (!flag("set_point_exists", i)) {
      if (!blames_gripper(note)) return joined({"no set-point", at_keys(i), ": ", note});
      const std::size_t colon = note.find(':');
      return joined({note.substr(0, colon), at_keys(i), note.substr(colon)});
    }
    const std::string over = over_.empty() ? std::string() : joined({", for all ", over_});
    return joined({"set-point", at_keys(i), ": ", note, over});
  }

  /// Nothing where no run near the set-point was held.
  [[nodiscard]] std::string cycle_text(std::size_t i) const {
    const double cycle_time_s = number("cycle_time_s", i);
    return std::isnan(cycle_time_s) ? std::string()
                                    : joined({": the shortest cycle, ", short_number(cycle_time_s), " s"});
  }

  [[nodiscard]] std::size_t count(const char* column) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < row_count(table_); ++i) count += flag(column, i) ? 1U : 0U;
    return count;
  }

  /// Where grippers stand apart each has a best of its own, and it is clear without a count what it is the best
  /// of.
  void add_best() {
    const std::size_t usable = count("set_point_exists");
    if (usable == 0) lines_.emplace_back("best: none; no strategy has a set-point");
    const std::string of_all =
        joined({", of ", std::to_string(usable), usable == 1 ? " strategy" : " strategies", " with a set-point"});
    const bool is_only = count("best") == 1;
    for (std::size_t i = 0; i < row_count(table_); ++i) {
      if (!flag("best", i)) continue;
      const std::string at = is_only ? joined({" with ", keys_text(table_, i)})
                                     : at_values(key_texts(table_, i), key_texts(table_, 0));
      lines_.push_back(joined({"best: ", text_in(table_, "note", i), at, cycle_text(i), is_only ? of_all : ""}));
    }
  }

  const WindowTable& window_;
  const ResultTable& table_;
  const std::string over_;
  const std::size_t most_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> window_lines(const WindowTable& window, const ResultTable* set_points,
                                      std::size_t most_lines) {
  std::vector<const WindowRow*> order;
  for (const WindowRow& row : window.rows) order.push_back(&row);
  const bool all = order.size() <= most_lines;
  if (!all) std::stable_partition(order.begin(), order.end(), [](const WindowRow* row) { return !row->exists; });
  order.resize(std::min(order.size(), most_lines));
  std::vector<std::string> lines;
  for (const WindowRow* row : order) lines.push_back(combination_line(window, *row));
  if (!all) {
    lines.push_back(joined({"... and ", std::to_string(window.rows.size() - order.size()), " more in /window"}));
  }
  add_half_step(window, lines);
  if (set_points == nullptr) return lines;
  for (std::string& line : SetPointLines(window, *set_points, most_lines).all()) lines.push_back(std::move(line));
  return lines;
}

}  // namespace unbruised::studies
