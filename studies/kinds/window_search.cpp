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
      : settings_(settings), evaluate_(evaluate), samples_(settings.combinations.size()) {}

  WindowSearchResult run() {
    std::vector<ForceRequest> requests = first_round();
    while (!requests.empty() && result_.round_count < kWindowRoundsMost) {
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
  /// Of what is asked together in a factor group, the part of each of `parts` of the combination in this place.
  [[nodiscard]] std::size_t share_of_each(std::size_t at, std::size_t parts) const {
    return kAskedTogether / std::max<std::size_t>(1, settings_.combinations[at].group_size * parts);
  }

  std::vector<ForceRequest> first_round() {
    std::vector<ForceRequest> requests;
    for (std::size_t at = 0; at < samples_.size(); ++at) {
      const std::size_t count = std::clamp(share_of_each(at, 1), kFirstRoundForces, kFirstRoundForcesMost);
      std::vector<double> forces = {settings_.from_N};
      const std::vector<double> between = log_between({settings_.from_N, settings_.to_N}, count - 2);
      forces.insert(forces.end(), between.begin(), between.end());
      forces.push_back(settings_.to_N);
      request(at, forces, requests);
    }
    return requests;
  }

  std::vector<ForceRequest> next_round() {
    std::vector<ForceRequest> requests;
    for (std::size_t at = 0; at < samples_.size(); ++at) {
      const std::vector<ForceBracket> open = open_brackets(at);
      std::vector<double> forces;
      for (const ForceBracket& bracket : open) {
        const std::vector<double> cuts = log_between(bracket, cuts_of(bracket, share_of_each(at, open.size())));
        forces.insert(forces.end(), cuts.begin(), cuts.end());
      }
      request(at, forces, requests);
    }
    return requests;
  }

  /// The deciding brackets that are wider than the tolerance.
  [[nodiscard]] std::vector<ForceBracket> open_brackets(std::size_t at) const {
    std::vector<ForceBracket> open;
    for (const ForceBracket& bracket : deciding_brackets(samples_[at])) {
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

  /// All forces of one combination in this round.
  void request(std::size_t at, const std::vector<double>& forces, std::vector<ForceRequest>& requests) {
    for (std::uint64_t number = 0; number < forces.size(); ++number) {
      asker_.push_back(at);
      requests.push_back({.place = {result_.round_count, settings_.combinations[at].number, number},
                          .grip_force_N = forces[number]});
    }
  }

  bool ask(const std::vector<ForceRequest>& requests) {
    std::optional<std::vector<GripSample>> answers = evaluate_(requests);
    if (!answers) return false;
    for (std::size_t i = 0; i < requests.size(); ++i) {
      GripSample sample = answers->at(i);
      sample.grip_force_N = requests[i].grip_force_N;
      samples_[asker_[i]].push_back(sample);
    }
    asker_.clear();
    result_.evaluation_count += requests.size();
    return true;
  }

  const WindowSearchSettings& settings_;
  const ForceEvaluator& evaluate_;
  std::vector<std::vector<GripSample>> samples_;  ///< of each combination
  std::vector<std::size_t> asker_;                ///< of each request of this round, the place of its combination
  WindowSearchResult result_;
};

}  // namespace

std::vector<SearchedCombination> searched_combinations(const std::vector<std::size_t>& factor_group) {
  std::vector<std::size_t> sizes;
  for (const std::size_t group : factor_group) {
    if (sizes.size() <= group) sizes.resize(group + 1, 0);
    ++sizes[group];
  }
  std::vector<SearchedCombination> combinations;
  for (std::size_t i = 0; i < factor_group.size(); ++i) combinations.push_back({i, sizes[factor_group[i]]});
  return combinations;
}

WindowSearchResult search_windows(const WindowSearchSettings& settings, const ForceEvaluator& evaluate) {
  return WindowSearch(settings, evaluate).run();
}

}  // namespace unbruised::studies
