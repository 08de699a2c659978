#pragma once

/// @file
/// The observer that fills a `Curve`.

#include <array>
#include <optional>

#include "core/outcome/curve.hpp"
#include "core/simulation/lane_observer.hpp"

namespace unbruised {

class CurveRecorder final : public LaneObserver {
 public:
  /// The curve has to outlive the run.
  explicit CurveRecorder(Curve& curve) : curve_(curve) {}

  void start(const LaneStep& loaded) override;
  bool observe(const LaneStep& step) override;
  void end(const LaneStep& /*last*/) override {}

 private:
  void observe_fingers(const LaneStep& step);
  void observe_load(const LaneStep& step);

  Curve& curve_;
  std::array<double, kMostFingers> last_way_m_{};
  std::array<std::optional<double>, kMostFingers> touch_way_m_;
  std::optional<double> first_contact_s_;  ///< of the last finger to touch
};

}  // namespace unbruised
