#include "studies/kinds/window_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace unbruised::studies {
namespace {

constexpr std::size_t kFirstRoundForces = 8;       // per combination, at least
constexpr std::size_t kFirstRoundForcesMost = 16;  // per combination, when lanes would be empty otherwise
constexpr std::size_t kCutsMost = 31;              // of one bracket in one round
constexpr int kRoundsMost = 100;                   // bisection needs 30 for a ratio of 1e6 at a tolerance of 1e-3

struct Bracket {
  double low_N = 0.0;
  double high_N = 0.0;
  friend bool operator==(const Bracket&, const Bracket&) = default;
};

/// `count` forces strictly between the ends, in equal ratios.
std::vector<double> log_between(const Bracket& bracket, std::size_t count) {
  std::vector<double> forces;
  forces.reserve(count);
  const double ratio = bracket.high_N / bracket.low_N;
  for (std::size_t i = 1; i <= count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count + 1);
    const double force_N = bracket.low_N * std::pow(ratio, part);
    if (force_N > bracket.low_N && force_N < bracket.high_N) forces.push_back(force_N);
  }
  return forces;
}

class WindowSearch {
 public:
  WindowSearch(const WindowSearchSettings& settings, const ForceEvaluator& evaluate)
      : settings_(settings), evaluate_(evaluate), samples_(settings.factor_group.size()) {}

  WindowSearchResult run() {
    std::vector<ForceRequest> requests = first_round();
    while (!requests.empty() && result_.round_count < kRoundsMost) {
      if (!ask(requests)) {
        result_.interrupted = true;
        return std::move(result_);
      }
      ++result_.round_count;
      requests = next_round();
    }
    for (const std::vector<GripSample>& samples : samples_) result_.rows.push_back(read_grip_window(samples));
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::size_t combination_count() const { return samples_.size(); }

  [[nodiscard]] std::vector<std::size_t> zero_per_group() const {
    std::size_t groups = 0;
    for (const std::size_t group : settings_.factor_group) groups = std::max(groups, group + 1);
    return std::vector<std::size_t>(groups, 0);
  }

  [[nodiscard]] std::size_t lanes_for_each(std::size_t askers) const {
    return static_cast<std::size_t>(settings_.lane_count) / std::max<std::size_t>(1, askers);
  }

  std::vector<ForceRequest> first_round() {
    std::vector<std::size_t> members = zero_per_group();
    for (const std::size_t group : settings_.factor_group) ++members[group];
    std::vector<ForceRequest> requests;
    for (std::size_t combination = 0; combination < combination_count(); ++combination) {
      const std::size_t lanes = lanes_for_each(members[settings_.factor_group[combination]]);
      const std::size_t count = std::clamp(lanes, kFirstRoundForces, kFirstRoundForcesMost);
      request(combination, {settings_.from_N}, requests);
      request(combination, log_between({settings_.from_N, settings_.to_N}, count - 2), requests);
      request(combination, {settings_.to_N}, requests);
    }
    return requests;
  }

  std::vector<ForceRequest> next_round() {
    std::vector<std::vector<Bracket>> open(combination_count());
    std::vector<std::size_t> open_in_group = zero_per_group();
    for (std::size_t combination = 0; combination < combination_count(); ++combination) {
      open[combination] = open_brackets(combination);
      open_in_group[settings_.factor_group[combination]] += open[combination].size();
    }
    std::vector<ForceRequest> requests;
    for (std::size_t combination = 0; combination < combination_count(); ++combination) {
      const std::size_t lanes = lanes_for_each(open_in_group[settings_.factor_group[combination]]);
      for (const Bracket& bracket : open[combination]) {
        request(combination, log_between(bracket, cuts_of(bracket, lanes)), requests);
      }
    }
    return requests;
  }

  /// The brackets wider than the tolerance, in ascending order, one where both ends lie in the same.
  [[nodiscard]] std::vector<Bracket> open_brackets(std::size_t combination) const {
    const WindowRow row = read_grip_window(samples_[combination]);
    std::vector<Bracket> open;
    for (const Bracket& bracket : {Bracket{row.hold_bracket_low_N, row.hold_bracket_high_N},
                                   Bracket{row.damage_bracket_low_N, row.damage_bracket_high_N}}) {
      // NaN where an end lies outside the range: nothing to cut.
      const bool is_wide = bracket.high_N > bracket.low_N * (1.0 + settings_.tolerance);
      if (is_wide && std::find(open.begin(), open.end(), bracket) == open.end()) open.push_back(bracket);
    }
    std::sort(open.begin(), open.end(), [](const Bracket& a, const Bracket& b) { return a.low_N < b.low_N; });
    return open;
  }

  /// No more cuts than lanes, and no finer than the tolerance asks for.
  [[nodiscard]] std::size_t cuts_of(const Bracket& bracket, std::size_t lanes) const {
    const double parts = std::ceil(std::log(bracket.high_N / bracket.low_N) / std::log1p(settings_.tolerance));
    const std::size_t useful = parts < 2.0 ? 1 : static_cast<std::size_t>(std::min(parts, 1e6)) - 1;
    return std::clamp<std::size_t>(std::min(lanes, useful), 1, kCutsMost);
  }

  void request(std::size_t combination, const std::vector<double>& forces, std::vector<ForceRequest>& requests) {
    for (const double force_N : forces) requests.push_back({next_id_++, combination, force_N});
  }

  bool ask(const std::vector<ForceRequest>& requests) {
    std::optional<std::vector<GripSample>> answers = evaluate_(requests);
    if (!answers) return false;
    for (std::size_t i = 0; i < requests.size(); ++i) {
      GripSample sample = answers->at(i);
      sample.grip_force_N = requests[i].grip_force_N;
      samples_[requests[i].combination].push_back(sample);
    }
    result_.evaluation_count += requests.size();
    return true;
  }

  const WindowSearchSettings& settings_;
  const ForceEvaluator& evaluate_;
  std::vector<std::vector<GripSample>> samples_;
  std::uint64_t next_id_ = 0;
  WindowSearchResult result_;
};

}  // namespace

WindowSearchResult search_windows(const WindowSearchSettings& settings, const ForceEvaluator& evaluate) {
  return WindowSearch(settings, evaluate).run();
}

}  // namespace unbruised::studies
