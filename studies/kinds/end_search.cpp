#include "studies/kinds/end_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace unbruised::studies {
namespace {

/// How far beyond the bracket is looked, first near by, then farther.
constexpr std::array<double, 4> kNear = {1.02, 1.05, 1.1, 1.2};
constexpr std::array<double, 4> kFar = {1.4, 1.8, 2.5, 4.0};
constexpr std::size_t kCuts = 4;  ///< of a bracket in one round
constexpr int kRoundsMost = 12;

/// One end and what is known of it now: a safe force, an unsafe one, or only one of them.
class EndSearch {
 public:
  EndSearch(const KnownEnd& known, const EndSearchSettings& settings) : known_(known), settings_(settings) {}

  /// The forces of the next round; none when the end is found.
  std::vector<double> next() {
    if (rounds_ == 0) return first();
    if (std::isnan(safe_N_)) return rounds_ == 1 ? inwards(kNear) : rounds_ == 2 ? inwards(kFar) : none();
    if (std::isnan(unsafe_N_)) return rounds_ == 1 ? outwards(kNear) : rounds_ == 2 ? outwards(kFar) : none();
    return cuts();
  }

  void learn(double force_N, bool is_safe) { tried_.emplace_back(force_N, is_safe); }

  /// The innermost unsafe force, and the safe one next to it on its inner side: what lies beyond does not count.
  void end_round() {
    ++rounds_;
    for (const auto& [force_N, is_safe] : tried_) {
      if (!is_safe && (std::isnan(unsafe_N_) || is_further_out(unsafe_N_, force_N))) unsafe_N_ = force_N;
    }
    safe_N_ = kAbsent;
    for (const auto& [force_N, is_safe] : tried_) {
      if (!is_safe || (!std::isnan(unsafe_N_) && !is_further_out(unsafe_N_, force_N))) continue;
      if (std::isnan(safe_N_) || is_further_out(force_N, safe_N_)) safe_N_ = force_N;
    }
  }

  [[nodiscard]] double safe_N() const { return safe_N_; }

 private:
  /// Out of the window: downwards at the lower end, upwards at the upper one.
  enum class Way { outwards, inwards };

  [[nodiscard]] bool is_hold() const { return known_.end == WindowEnd::hold; }
  [[nodiscard]] bool is_further_out(double a_N, double b_N) const { return is_hold() ? a_N < b_N : a_N > b_N; }
  [[nodiscard]] double moved(double force_N, double factor, Way way) const {
    const double to = is_hold() == (way == Way::outwards) ? force_N / factor : force_N * factor;
    return std::clamp(to, settings_.from_N, settings_.to_N);
  }
  static std::vector<double> none() { return {}; }

  [[nodiscard]] std::vector<double> first() const {
    if (std::isnan(known_.unsafe_N)) return {known_.safe_N};
    return {known_.safe_N, known_.unsafe_N};
  }

  [[nodiscard]] std::vector<double> stepped(double start_N, const std::array<double, 4>& factors, Way way) const {
    std::vector<double> forces;
    for (const double factor : factors) {
      const double force_N = moved(start_N, factor, way);
      if (force_N != start_N && (forces.empty() || forces.back() != force_N)) forces.push_back(force_N);
    }
    return forces;
  }
  [[nodiscard]] std::vector<double> inwards(const std::array<double, 4>& factors) const {
    return stepped(known_.safe_N, factors, Way::inwards);
  }
  /// Where the range ended before the window did, there is nothing to look for.
  [[nodiscard]] std::vector<double> outwards(const std::array<double, 4>& factors) const {
    return std::isnan(known_.unsafe_N) ? none() : stepped(known_.unsafe_N, factors, Way::outwards);
  }

  [[nodiscard]] std::vector<double> cuts() const {
    const double low = std::min(safe_N_, unsafe_N_);
    const double ratio = std::max(safe_N_, unsafe_N_) / low;
    std::vector<double> forces;
    // The bracket as known may be a rounding error wider than the tolerance.
    if (ratio <= (1.0 + settings_.tolerance) * (1.0 + 1e-9) || rounds_ >= kRoundsMost) return forces;
    for (std::size_t i = 1; i <= kCuts; ++i) {
      forces.push_back(low * std::pow(ratio, static_cast<double>(i) / static_cast<double>(kCuts + 1)));
    }
    return forces;
  }

  const KnownEnd& known_;
  const EndSearchSettings& settings_;
  std::vector<std::pair<double, bool>> tried_;
  double safe_N_ = kAbsent;
  double unsafe_N_ = kAbsent;
  int rounds_ = 0;
};

}  // namespace

EndSearchResult search_ends(const std::vector<KnownEnd>& ends, const EndSearchSettings& settings,
                            const EndEvaluator& evaluate) {
  std::vector<EndSearch> searches;
  for (const KnownEnd& end : ends) searches.emplace_back(end, settings);
  EndSearchResult result;
  while (true) {
    std::vector<EndRequest> requests;
    for (std::size_t i = 0; i < searches.size(); ++i) {
      for (const double force_N : searches[i].next()) requests.push_back({i, force_N});
    }
    if (requests.empty()) break;
    const std::optional<std::vector<bool>> answers = evaluate(requests);
    if (!answers) {
      result.interrupted = true;
      return result;
    }
    for (std::size_t i = 0; i < requests.size(); ++i) {
      searches[requests[i].end].learn(requests[i].grip_force_N, answers->at(i));
    }
    for (EndSearch& search : searches) search.end_round();
    result.evaluation_count += requests.size();
  }
  for (const EndSearch& search : searches) result.safe_N.push_back(search.safe_N());
  return result;
}

}  // namespace unbruised::studies
