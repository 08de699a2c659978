#include "studies/kinds/window_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace unbruised::studies {
namespace {

/// Evaluations of one factor group that are asked together, at least: a multiple of the lanes of every machine,
/// and the same on all of them, so that all of them find the same window.
constexpr std::size_t kAskedTogether = 16;
constexpr std::size_t kFirstRoundForces = 8;       // per combination, at least
constexpr std::size_t kFirstRoundForcesMost = 16;  // per combination, when lanes would be empty otherwise
constexpr std::size_t kCutsMost = 31;              // of one bracket in one round
constexpr int kRoundsMost = 100;                   // bisection needs 30 for a ratio of 1e6 at a tolerance of 1e-3

/// `count` forces strictly between the ends, in equal ratios.
std::vector<double> log_between(const ForceBracket& bracket, std::size_t count) {
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

  static std::size_t share_of_each(std::size_t askers) {
    return kAskedTogether / std::max<std::size_t>(1, askers);
  }

  std::vector<ForceRequest> first_round() {
    std::vector<std::size_t> members = zero_per_group();
    for (const std::size_t group : settings_.factor_group) ++members[group];
    std::vector<ForceRequest> requests;
    for (std::size_t combination = 0; combination < combination_count(); ++combination) {
      const std::size_t share = share_of_each(members[settings_.factor_group[combination]]);
      const std::size_t count = std::clamp(share, kFirstRoundForces, kFirstRoundForcesMost);
      request(combination, {settings_.from_N}, requests);
      request(combination, log_between({settings_.from_N, settings_.to_N}, count - 2), requests);
      request(combination, {settings_.to_N}, requests);
    }
    return requests;
  }

  std::vector<ForceRequest> next_round() {
    std::vector<std::vector<ForceBracket>> open(combination_count());
    std::vector<std::size_t> open_in_group = zero_per_group();
    for (std::size_t combination = 0; combination < combination_count(); ++combination) {
      open[combination] = open_brackets(combination);
      open_in_group[settings_.factor_group[combination]] += open[combination].size();
    }
    std::vector<ForceRequest> requests;
    for (std::size_t combination = 0; combination < combination_count(); ++combination) {
      const std::size_t share = share_of_each(open_in_group[settings_.factor_group[combination]]);
      for (const ForceBracket& bracket : open[combination]) {
        request(combination, log_between(bracket, cuts_of(bracket, share)), requests);
      }
    }
    return requests;
  }

  /// The deciding brackets that are wider than the tolerance.
  [[nodiscard]] std::vector<ForceBracket> open_brackets(std::size_t combination) const {
    std::vector<ForceBracket> open;
    for (const ForceBracket& bracket : deciding_brackets(samples_[combination])) {
      if (bracket.high_N > bracket.low_N * (1.0 + settings_.tolerance)) open.push_back(bracket);
    }
    return open;
  }

  /// No more cuts than its share, and no finer than the tolerance asks for.
  [[nodiscard]] std::size_t cuts_of(const ForceBracket& bracket, std::size_t share) const {
    const double parts = std::ceil(std::log(bracket.high_N / bracket.low_N) / std::log1p(settings_.tolerance));
    const std::size_t useful = parts < 2.0 ? 1 : static_cast<std::size_t>(std::min(parts, 1e6)) - 1;
    return std::clamp<std::size_t>(std::min(share, useful), 1, kCutsMost);
  }

  void request(std::size_t combination, const std::vector<double>& forces, std::vector<ForceRequest>& requests) {
    for (const double force_N : forces)
      requests.push_back({next_id_++, combination, force_N, StepSize::as_written});
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
