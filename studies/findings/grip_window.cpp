#include "studies/findings/grip_window.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// A peak this much above the grip force is no effect of the drive's limit: it comes from the finger's momentum.
constexpr double kImpactRatio = 1.5;

std::vector<bool> holding(std::span<const GripSample> samples) {
  std::vector<bool> result;
  bool lower_holds = false;
  for (const GripSample& sample : samples) {
    lower_holds = lower_holds || sample.holds == Verdict::yes;
    result.push_back(sample.holds == Verdict::yes || (sample.holds == Verdict::unknown && lower_holds));
  }
  return result;
}

std::vector<bool> unmarked(std::span<const GripSample> samples) {
  std::vector<bool> result(samples.size());
  bool higher_is_unmarked = false;
  for (std::size_t i = samples.size(); i-- > 0;) {
    const Verdict verdict = samples[i].undamaged;
    higher_is_unmarked = higher_is_unmarked || verdict == Verdict::yes;
    result[i] = verdict == Verdict::yes || (verdict == Verdict::unknown && higher_is_unmarked);
  }
  return result;
}

/// Index of the first force from which on all of [0, end) hold; `end` when the last one does not.
std::size_t first_of_holding_tail(const std::vector<bool>& holds, std::size_t end) {
  while (end > 0 && holds[end - 1]) --end;
  return end;
}

bool any_in(const std::vector<bool>& values, std::size_t begin, std::size_t end) {
  return std::find(values.begin() + static_cast<std::ptrdiff_t>(begin),
                   values.begin() + static_cast<std::ptrdiff_t>(end),
                   true) != values.begin() + static_cast<std::ptrdiff_t>(end);
}

class WindowReader {
 public:
  explicit WindowReader(std::vector<GripSample> samples) : samples_(std::move(samples)) {
    std::sort(samples_.begin(), samples_.end(),
              [](const GripSample& a, const GripSample& b) { return a.grip_force_N < b.grip_force_N; });
    holds_ = holding(samples_);
    unmarked_ = unmarked(samples_);
  }

  WindowRow read() {
    find_damage_end();
    find_hold_end();
    row_.exists = row_.hold_bracket_high_N <= row_.damage_bracket_low_N;
    row_.margin = row_.damage_force_N / row_.hold_force_N - 1.0;
    if (!row_.exists) row_.note = joined({"no window: ", row_.note.empty() ? ends_in_words() : row_.note});
    note_non_monotone();
    return row_;
  }

 private:
  [[nodiscard]] double force(std::size_t i) const { return samples_[i].grip_force_N; }
  [[nodiscard]] std::size_t count() const { return samples_.size(); }

  void find_damage_end() {
    first_damaging_ =
        static_cast<std::size_t>(std::find(unmarked_.begin(), unmarked_.end(), false) - unmarked_.begin());
    if (first_damaging_ > 0) row_.damage_bracket_low_N = force(first_damaging_ - 1);
    if (first_damaging_ < count()) row_.damage_bracket_high_N = force(first_damaging_);
    if (first_damaging_ == 0) {
      note_damage_at_least_force();
    } else if (first_damaging_ == count()) {
      note(joined({"no damage up to ", short_number(force(count() - 1)), " N"}));
    } else {
      row_.damage_force_N = row_.damage_bracket_low_N;
      if (samples_[first_damaging_].undamaged == Verdict::unknown) {
        note(joined(
            {"from ", short_number(force(first_damaging_)), " N on the runs leave what the simulator can tell"}));
      }
    }
  }

  void note_damage_at_least_force() {
    const GripSample& least = samples_.front();
    if (least.undamaged == Verdict::unknown) {
      note(joined(
          {"the runs leave what the simulator can tell at ", short_number(least.grip_force_N), " N already"}));
    } else if (least.peak_finger_force_N > kImpactRatio * least.grip_force_N) {
      note("the impact alone damages at this speed");
    } else {
      note(joined({"damages at ", short_number(least.grip_force_N), " N already"}));
    }
  }

  void find_hold_end() {
    // What does not hold above the first damaging force does not matter to the window below it.
    std::size_t end = std::min(first_damaging_ + 1, count());
    std::size_t first = first_of_holding_tail(holds_, end);
    if (first == end) {
      end = count();
      first = first_of_holding_tail(holds_, end);
    }
    hold_range_end_ = end;
    first_holding_ = first;
    if (first > 0) row_.hold_bracket_low_N = force(first - 1);
    if (first < end) row_.hold_bracket_high_N = force(first);
    if (first == end) {
      note(joined({"no force up to ", short_number(force(end - 1)), " N holds"}));
      if (any_in(holds_, 0, end)) note("lower ones do in part");
    } else if (first == 0) {
      note(joined({"holds at ", short_number(force(0)), " N already"}));
    } else {
      row_.hold_force_N = row_.hold_bracket_high_N;
    }
  }

  void note_non_monotone() {
    if (first_holding_ != hold_range_end_ && any_in(holds_, 0, first_holding_)) {
      note("not monotone: some forces below F_hold hold");
    }
    if (std::find(holds_.begin() + static_cast<std::ptrdiff_t>(hold_range_end_), holds_.end(), false) !=
        holds_.end()) {
      note("not monotone: some damaging forces do not hold");
    }
    if (any_in(unmarked_, first_damaging_, count()))
      note("not monotone: some forces above F_damage do not damage");
  }

  [[nodiscard]] std::string ends_in_words() const {
    return joined({"holds from ", short_number(row_.hold_bracket_high_N), " N on, damages from ",
                   short_number(row_.damage_bracket_high_N), " N on"});
  }

  void note(std::string_view text) {
    if (!row_.note.empty()) row_.note += "; ";
    row_.note += text;
  }

  std::vector<GripSample> samples_;
  std::vector<bool> holds_;
  std::vector<bool> unmarked_;
  std::size_t first_damaging_ = 0;
  std::size_t first_holding_ = 0;
  std::size_t hold_range_end_ = 0;
  WindowRow row_;
};

}  // namespace

WindowRow read_grip_window(std::vector<GripSample> samples) {
  if (samples.empty()) return WindowRow{.inputs = {}, .note = "no window: nothing was tried"};
  return WindowReader(std::move(samples)).read();
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
    if (common.damage_row == nullptr || row.damage_bracket_low_N < common.damage_row->damage_bracket_low_N) {
      common.damage_row = &row;
    }
  }
  if (common.hold_row != nullptr) {
    common.hold_force_N = common.hold_row->hold_bracket_high_N;
    common.damage_force_N = common.damage_row->damage_bracket_low_N;
    common.hold_is_bound = std::isnan(common.hold_row->hold_bracket_low_N);
    common.damage_is_bound = std::isnan(common.damage_row->damage_bracket_high_N);
    common.exists = common.exists && common.hold_force_N <= common.damage_force_N;
  }
  return common;
}

}  // namespace unbruised::studies
