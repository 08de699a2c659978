#pragma once

/// @file
/// The observer that fills a `Trace`.

#include "core/simulation/lane_observer.hpp"

namespace unbruised {

class TraceRecorder final : public LaneObserver {
 public:
  /// @param trace has to outlive the run
  explicit TraceRecorder(Trace& trace) : trace_(trace) {}

  void start(const LaneStep& loaded) override;
  bool observe(const LaneStep& step) override;
  void end(const LaneStep& /*last*/) override {}

 private:
  void record(const LaneStep& step);

  Trace& trace_;
  WorstPatches patches_;     ///< up to the present step
  std::int64_t stride_ = 1;  ///< steps from row to row
};

}  // namespace unbruised
