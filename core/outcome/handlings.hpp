#pragma once

/// @file
/// The results of handlings one after another (strategy.repeat) as the one of their scenario.

#include "core/outcome/outcome.hpp"

namespace unbruised {

/// What a metric of several handlings is.
enum class OverHandlings {
  last,      ///< what the last one shows: the marks, which stay, and times
  largest,   ///< of all
  smallest,  ///< of all
  sum,       ///< of all
  farthest,  ///< from zero, of all
};
OverHandlings over_handlings(Metric metric);

class Handlings {
 public:
  Handlings() = default;
  /// @param count >= 1; that there are when all go well
  explicit Handlings(int count) : count_(count) {}

  /// Takes in the next one, which took so long.
  void add(const ScenarioResult& handling, double duration_s);
  /// Is there another one?
  [[nodiscard]] bool go_on() const { return done_ < count_ && together_.outcome == Outcome::held; }
  /// Of those so far. Times of outcomes count from the start of the first, those of metrics from that of the last.
  [[nodiscard]] const ScenarioResult& together() const { return together_; }

 private:
  int count_ = 1, done_ = 0;
  double before_s_ = 0.0;
  ScenarioResult together_;
};

}  // namespace unbruised
