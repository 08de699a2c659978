#include "studies/findings/grip_window.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// A peak this much above the grip force is no effect of the drive's limit: it comes from the finger's momentum.
constexpr double kImpactRatio = 1.5;
/// Intervals whose ends are searched for: more of them are noise of the simulator, not windows.
constexpr std::size_t kIntervalsSearched = 3;

GripState state_of(const GripSample& sample) {
  if (sample.holds == Verdict::no) return GripState::fails;
  if (sample.undamaged == Verdict::no) return GripState::marks;
  const bool told = sample.holds == Verdict::yes && sample.undamaged == Verdict::yes;
  return told ? GripState::safe : GripState::untold;
}

void sort_by_force(std::vector<GripSample>& samples) {
  std::sort(samples.begin(), samples.end(),
            [](const GripSample& a, const GripSample& b) { return a.grip_force_N < b.grip_force_N; });
}

/// The samples in order, and what can be asked about them.
class Samples {
 public:
  explicit Samples(std::vector<GripSample> samples) : samples_(std::move(samples)) {
    sort_by_force(samples_);
    states_ = grip_states(samples_);
    intervals_ = safe_intervals(states_);
  }

  [[nodiscard]] std::size_t count() const { return samples_.size(); }
  [[nodiscard]] double force(std::size_t i) const { return samples_[i].grip_force_N; }
  [[nodiscard]] const GripSample& sample(std::size_t i) const { return samples_[i]; }
  /// Why nothing may be said about damage; empty where it is judged.
  [[nodiscard]] std::string_view damage_remark() const { return studies::damage_remark(samples_.front().damage); }
  [[nodiscard]] GripState state(std::size_t i) const { return states_[i]; }
  [[nodiscard]] const std::vector<SafeInterval>& intervals() const { return intervals_; }
  [[nodiscard]] double ratio(const SafeInterval& interval) const {
    return force(interval.last) / force(interval.first);
  }

  /// The intervals, the widest first.
  [[nodiscard]] std::vector<SafeInterval> by_width() const {
    std::vector<SafeInterval> sorted = intervals_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [this](const SafeInterval& a, const SafeInterval& b) { return ratio(a) > ratio(b); });
    return sorted;
  }

  /// The first force that is known to hold, which marks where nothing is safe; `count()`: none.
  [[nodiscard]] std::size_t first_marking() const {
    const auto found = std::find(states_.begin(), states_.end(), GripState::marks);
    return static_cast<std::size_t>(found - states_.begin());
  }

  /// The greatest force below `end` that leaves the product unmarked, held or not; `count()`: none.
  [[nodiscard]] std::size_t last_unmarked(std::size_t end) const {
    while (end > 0 && samples_[end - 1].undamaged != Verdict::yes) --end;
    return end > 0 ? end - 1 : count();
  }

 private:
  std::vector<GripSample> samples_;
  std::vector<GripState> states_;
  std::vector<SafeInterval> intervals_;
};

/// A window that some force lies in.
class WindowInWords {
 public:
  WindowInWords(const Samples& samples, const SafeInterval& interval) : samples_(samples), interval_(interval) {}

  WindowRow read() {
    row_.exists = true;
    lower_end();
    upper_end();
    row_.margin = row_.damage_force_N / row_.hold_force_N - 1.0;
    other_intervals();
    return row_;
  }

 private:
  void lower_end() {
    const std::size_t first = interval_.first;
    row_.hold_bracket_high_N = samples_.force(first);
    if (first == 0) return note({"holds at ", short_number(samples_.force(0)), " N already"});
    row_.hold_bracket_low_N = samples_.force(first - 1);
    row_.hold_force_N = row_.hold_bracket_high_N;
    const std::string below = short_number(row_.hold_bracket_low_N);
    if (samples_.state(first - 1) == GripState::marks) note({"below, at ", below, " N, it is held but damaged"});
    if (samples_.state(first - 1) == GripState::untold) {
      note({"up to ", below, " N the runs leave what the simulator can tell"});
    }
  }

  void upper_end() {
    if (!samples_.damage_remark().empty()) return note({samples_.damage_remark()});
    const std::size_t last = interval_.last;
    row_.damage_bracket_low_N = samples_.force(last);
    if (last + 1 == samples_.count()) return note({"no damage up to ", short_number(samples_.force(last)), " N"});
    row_.damage_bracket_high_N = samples_.force(last + 1);
    row_.damage_force_N = row_.damage_bracket_low_N;
    const std::string above = short_number(row_.damage_bracket_high_N);
    if (samples_.state(last + 1) == GripState::fails) note({"above, at ", above, " N, it is not held again"});
    if (samples_.state(last + 1) == GripState::untold) {
      note({"from ", above, " N on the runs leave what the simulator can tell"});
    }
  }

  void other_intervals() {
    for (const SafeInterval& each : samples_.intervals()) {
      const std::string ends = joined(
          {"[", short_number(samples_.force(each.first)), ", ", short_number(samples_.force(each.last)), "]"});
      add_part(row_.intervals, ", ", ends);
      if (each.first != interval_.first) note({"not monotone: held and undamaged in ", ends, " N too"});
    }
  }

  void note(std::initializer_list<std::string_view> parts) { add_part(row_.note, "; ", joined(parts)); }

  const Samples& samples_;
  const SafeInterval interval_;
  WindowRow row_;
};

/// Why no force lies in a window.
class NoWindowInWords {
 public:
  explicit NoWindowInWords(const Samples& samples) : samples_(samples) {}

  WindowRow read() {
    hold_end();
    damage_end();
    row_.margin = row_.damage_force_N / row_.hold_force_N - 1.0;
    row_.note = joined({"no window: ", row_.note.empty() ? ends_in_words() : row_.note});
    return row_;
  }

 private:
  void hold_end() {
    held_ = samples_.first_marking();
    if (held_ == samples_.count()) {
      row_.hold_bracket_low_N = samples_.force(samples_.count() - 1);
      return note({"no force up to ", short_number(row_.hold_bracket_low_N), " N holds"});
    }
    row_.hold_bracket_high_N = samples_.force(held_);
    if (held_ == 0) return note({"holds at ", short_number(samples_.force(0)), " N already"});
    row_.hold_bracket_low_N = samples_.force(held_ - 1);
    row_.hold_force_N = row_.hold_bracket_high_N;
  }

  void damage_end() {
    if (!samples_.damage_remark().empty()) return note({samples_.damage_remark()});
    const std::size_t last = samples_.last_unmarked(held_);
    if (last == samples_.count()) return damage_at_least_force();
    row_.damage_bracket_low_N = samples_.force(last);
    if (last + 1 == samples_.count()) return note({"no damage up to ", short_number(samples_.force(last)), " N"});
    if (samples_.sample(last + 1).undamaged == Verdict::unknown) {
      return note(
          {"from ", short_number(samples_.force(last + 1)), " N on the runs leave what the simulator can tell"});
    }
    row_.damage_bracket_high_N = samples_.force(last + 1);
    row_.damage_force_N = row_.damage_bracket_low_N;
  }

  void damage_at_least_force() {
    const GripSample& least = samples_.sample(0);
    if (least.undamaged == Verdict::unknown) {
      return note(
          {"the runs leave what the simulator can tell at ", short_number(least.grip_force_N), " N already"});
    }
    row_.damage_bracket_high_N = least.grip_force_N;
    if (least.peak_finger_force_N > kImpactRatio * least.grip_force_N) {
      return note({"the impact alone damages at this speed"});
    }
    note({"damages at ", short_number(least.grip_force_N), " N already"});
  }

  [[nodiscard]] std::string ends_in_words() const {
    return joined({"holds from ", short_number(row_.hold_bracket_high_N), " N on, damages from ",
                   short_number(row_.damage_bracket_high_N), " N on"});
  }

  void note(std::initializer_list<std::string_view> parts) { add_part(row_.note, "; ", joined(parts)); }

  const Samples& samples_;
  std::size_t held_ = 0;
  WindowRow row_;
};

/// Which ends lie next to a run whose impact the step does not resolve.
void mark_impacts(const Samples& samples, WindowRow& row) {
  for (std::size_t i = 0; i < samples.count(); ++i) {
    if (!samples.sample(i).unresolved_impact) continue;
    const double force_N = samples.force(i);
    row.hold_on_impact |= force_N == row.hold_bracket_low_N || force_N == row.hold_bracket_high_N;
    row.damage_on_impact |= force_N == row.damage_bracket_low_N || force_N == row.damage_bracket_high_N;
  }
}

/// Adds the forces `i - 1` and `i` as a bracket, where both were tried.
void add_bracket(const Samples& samples, std::size_t i, std::vector<ForceBracket>& brackets) {
  if (i == 0 || i >= samples.count()) return;
  const ForceBracket bracket{samples.force(i - 1), samples.force(i)};
  if (std::find(brackets.begin(), brackets.end(), bracket) == brackets.end()) brackets.push_back(bracket);
}

/// Where no force is safe: a window may lie between a force that fails and the next, which marks.
void add_hidden(const Samples& samples, std::vector<ForceBracket>& brackets) {
  for (std::size_t i = 1; i < samples.count() && brackets.size() < kIntervalsSearched; ++i) {
    const bool begins = samples.state(i - 1) == GripState::fails && samples.state(i) == GripState::marks;
    if (begins) add_bracket(samples, i, brackets);
  }
  const std::size_t unmarked = samples.last_unmarked(samples.first_marking());
  if (unmarked < samples.count()) add_bracket(samples, unmarked + 1, brackets);
}

}  // namespace

std::vector<GripState> grip_states(const std::vector<GripSample>& samples) {
  std::vector<GripState> states;
  for (const GripSample& sample : samples) states.push_back(state_of(sample));
  for (std::size_t i = 1; i < states.size(); ++i) {
    if (states[i] != GripState::untold || states[i - 1] != GripState::safe) continue;
    std::size_t end = i;
    while (end < states.size() && states[end] == GripState::untold) ++end;
    if (end == states.size() || states[end] != GripState::safe) continue;
    std::fill(states.begin() + static_cast<std::ptrdiff_t>(i), states.begin() + static_cast<std::ptrdiff_t>(end),
              GripState::safe);
  }
  return states;
}

std::vector<SafeInterval> safe_intervals(const std::vector<GripState>& states) {
  std::vector<SafeInterval> intervals;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] != GripState::safe) continue;
    if (intervals.empty() || intervals.back().last + 1 != i) intervals.push_back({i, i});
    intervals.back().last = i;
  }
  return intervals;
}

std::vector<ForceBracket> deciding_brackets(std::vector<GripSample> samples) {
  const Samples sorted(std::move(samples));
  std::vector<ForceBracket> brackets;
  const std::vector<SafeInterval> widest = sorted.by_width();
  for (std::size_t i = 0; i < std::min(widest.size(), kIntervalsSearched); ++i) {
    add_bracket(sorted, widest[i].first, brackets);
    add_bracket(sorted, widest[i].last + 1, brackets);
  }
  if (widest.empty()) add_hidden(sorted, brackets);
  std::sort(brackets.begin(), brackets.end(),
            [](const ForceBracket& a, const ForceBracket& b) { return a.low_N < b.low_N; });
  return brackets;
}

WindowRow read_grip_window(std::vector<GripSample> samples) {
  if (samples.empty()) return WindowRow{.inputs = {}, .note = "no window: nothing was tried"};
  const Samples sorted(std::move(samples));
  WindowRow row = sorted.intervals().empty() ? NoWindowInWords(sorted).read()
                                             : WindowInWords(sorted, sorted.by_width().front()).read();
  mark_impacts(sorted, row);
  return row;
}

CommonWindow common_window(const std::vector<WindowRow>& rows) {
  CommonWindow common;
  common.exists = !rows.empty();
  for (const WindowRow& row : rows) {
    common.exists = common.exists && row.exists;
    if (!row.exists) continue;
    if (common.hold_row == nullptr || row.hold_bracket_high_N > common.hold_row->hold_bracket_high_N) {
      common.hold_row = &row;
    }
    if (std::isnan(row.damage_bracket_low_N)) continue;  // not judged
    if (common.damage_row == nullptr || row.damage_bracket_low_N < common.damage_row->damage_bracket_low_N) {
      common.damage_row = &row;
    }
  }
  if (common.hold_row != nullptr) {
    common.hold_force_N = common.hold_row->hold_bracket_high_N;
    common.hold_is_bound = std::isnan(common.hold_row->hold_bracket_low_N);
  }
  if (common.damage_row != nullptr) {
    common.damage_force_N = common.damage_row->damage_bracket_low_N;
    common.damage_is_bound = std::isnan(common.damage_row->damage_bracket_high_N);
    common.exists = common.exists && common.hold_force_N <= common.damage_force_N;
  }
  return common;
}

}  // namespace unbruised::studies
