#pragma once

/// @file
/// The observer that fills a `Replay`.

#include <array>
#include <cstdint>
#include <vector>

#include "core/outcome/replay.hpp"
#include "core/simulation/lane_observer.hpp"
#include "core/simulation/replay_places.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

class ReplayRecorder final : public LaneObserver {
 public:
  /// @param replay has to outlive the run
  /// @param interval_s > 0, from frame to frame; the last step makes one too
  ReplayRecorder(Replay& replay, double interval_s) : replay_(replay), interval_s_(interval_s) {}

  void start(const LaneStep& loaded) override;
  bool observe(const LaneStep& step) override;
  void end(const LaneStep& last) override;

 private:
  void record(const LaneStep& step);
  void record_pose(const LaneStep& step);
  void record_carriers(const LaneStep& step);
  void record_forces(const LaneStep& step);
  void record_deformation(const LaneStep& step);
  void record_strain(const LaneStep& step);
  void record_pressure(const LaneStep& step);
  void record_permanent_set(const LaneStep& step);
  [[nodiscard]] std::array<double, 3> center_m(const LaneStep& step) const;

  Replay& replay_;
  double interval_s_;
  std::int64_t frames_ = 0;  ///< that have passed, whether they were made or steps were longer
  VertexWeights weights_;
  VertexContacts contacts_;
  /// Of the last frame: the particles from where the pose alone puts them, along the axes of the attitude.
  std::vector<double> deformation_m_;
  std::vector<std::array<double, 3>> shift_m_;         ///< of the particles since the start, along x, y, z
  std::array<double, kSurfaceCount> worst_strain_{};   ///< below each surface's patch, up to the present step
  std::array<double, kSurfaceCount> spread_strain_{};  ///< how much of it is in the frames
  std::vector<float> patch_strain_;                    ///< [vertex]; what the patches have left so far
};

}  // namespace unbruised
