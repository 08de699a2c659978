#pragma once

/// @file
/// The observer that decides how a run ends: by its record, and by whether its numbers still mean something.

#include <string>

#include "core/outcome/handlings.hpp"
#include "core/simulation/balances.hpp"
#include "core/simulation/lane_observer.hpp"

namespace unbruised {

class OutcomeObserver final : public LaneObserver {
 public:
  explicit OutcomeObserver(const Scenario& scenario) : record_(scenario), handlings_(scenario.strategy.repeat) {}

  void start(const LaneStep& loaded) override;
  bool observe(const LaneStep& step) override;
  void end(const LaneStep& /*last*/) override {}

  /// A handling ends with the step that was observed last. @return is there another one?
  bool end_handling(const LaneStep& last);
  void next_handling(const LaneStep& loaded) override;

  /// The step that begins at `time_s` has no solution.
  void abort(const char* cause, double time_s) { record_.abort(Outcome::diverged, cause, time_s); }
  /// After the end.
  [[nodiscard]] const ScenarioResult& result() const { return handlings_.together(); }

 private:
  HandlingRecord record_;
  double contact_sweeps_ = 0, plastic_rounds_ = 0;  ///< of all steps of a handling
  Handlings handlings_;
};

}  // namespace unbruised
