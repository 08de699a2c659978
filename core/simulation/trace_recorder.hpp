#pragma once

/// @file
/// The observer that fills a `Trace`.

#include "core/simulation/balances.hpp"
#include "core/simulation/lane_observer.hpp"

namespace unbruised {

class TraceRecorder final : public LaneObserver {
 public:
  /// Both have to outlive the run; the contacts of the lane have to be noting events.
  TraceRecorder(Trace& trace, const Balances& balances) : trace_(trace), balances_(balances) {}

  void start(const LaneStep& loaded) override;
  bool observe(const LaneStep& step) override;
  void end(const LaneStep& /*last*/) override {}

 private:
  void record_events(const LaneStep& step);
  void record(const LaneStep& step);

  Trace& trace_;
  const Balances& balances_;
  WorstPatches patches_;     ///< up to the present step
  std::int64_t stride_ = 1;  ///< steps from row to row
};

}  // namespace unbruised
