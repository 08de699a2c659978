#pragma once

/// @file
/// The observer that fills a `Trace`.

#include "core/simulation/balances.hpp"
#include "core/simulation/lane_observer.hpp"

namespace unbruised {

class TraceRecorder final : public LaneObserver {
 public:
  /// @param trace has to outlive the run; the contacts of the lane have to be noting events
  explicit TraceRecorder(Trace& trace) : trace_(trace) {}

  void start(const LaneStep& loaded) override;
  void next_handling(const LaneStep& loaded) override { record_events(loaded); }
  bool observe(const LaneStep& step) override;
  void end(const LaneStep& /*last*/) override {}

 private:
  void record_events(const LaneStep& step);
  void record(const LaneStep& step);

  Trace& trace_;
  WorstPatches patches_;     ///< up to the present step
  std::int64_t stride_ = 1;  ///< ticks from row to row, or more
  std::int64_t rows_ = 0;    ///< strides until the last row
};

}  // namespace unbruised
