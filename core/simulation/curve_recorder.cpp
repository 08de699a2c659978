#include "core/simulation/curve_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/scenario/gripper.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {

void CurveRecorder::start(const LaneStep& loaded) {
  if (!has_gripper(loaded.scenario)) observe_load(loaded);
}

bool CurveRecorder::observe(const LaneStep& step) {
  if (has_gripper(step.scenario)) {
    observe_fingers(step);
  } else {
    observe_load(step);
  }
  return true;
}

void CurveRecorder::observe_fingers(const LaneStep& step) {
  const auto count = static_cast<double>(step.seen.finger_count);
  double closure_m = 0.0, force_N = 0.0, slide_N = 0.0;
  bool all_touched = true;
  double touched_s = step.start_s;
  for (std::size_t f = 0; f < step.seen.finger_count; ++f) {
    const FingerObservation& finger = step.seen.finger[f];
    const double way_m = step.view.gripper.way(static_cast<int>(f))[step.lane];
    if (!touch_way_m_[f] && finger.closed_contacts > 0.0) {
      const double part = std::clamp((finger.touched_s - step.start_s) / (step.time_s - step.start_s), 0.0, 1.0);
      touch_way_m_[f] = last_way_m_[f] + part * (way_m - last_way_m_[f]);
      touched_s = std::max(touched_s, step.start_s + part * (step.time_s - step.start_s));
    }
    last_way_m_[f] = way_m;
    all_touched = all_touched && touch_way_m_[f].has_value();
    closure_m += 2.0 / count * (way_m - touch_way_m_[f].value_or(way_m));
    force_N += finger.normal_N / count;
    slide_N += std::hypot(finger.tangent_N[0], finger.tangent_N[1]) / count;
  }
  if (!all_touched) return;
  if (!first_contact_s_) first_contact_s_ = touched_s;
  curve_.time_s.push_back(step.before_s + step.time_s - *first_contact_s_);
  curve_.closure_m.push_back(closure_m);
  curve_.force_N.push_back(force_N);
  curve_.slide_N.push_back(slide_N);
}

void CurveRecorder::observe_load(const LaneStep& step) {
  const NetworkLoad* written = first_load(step.scenario.product);
  if (written == nullptr) return;
  const NetworkLoad& load = *written;
  std::array<double, 3> along{};  // where the load is largest
  for (const std::array<double, 3>& force : load.force_N) {
    if (std::hypot(force[0], force[1], force[2]) > std::hypot(along[0], along[1], along[2])) along = force;
  }
  const double size = std::hypot(along[0], along[1], along[2]);
  if (size == 0.0) return;
  const auto first = static_cast<std::size_t>(3 * load.particle);
  const BodyState state = step.view.body.state(step.lane);
  const std::vector<double> force_N = written_load_N(step.scenario.product, step.view.model.body, step.time_s);
  double closure_m = 0.0, along_N = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    closure_m += state.displacement_m[first + i] * along[i] / size;
    along_N += force_N[first + i] * along[i] / size;
  }
  curve_.time_s.push_back(step.before_s + step.time_s);
  curve_.closure_m.push_back(closure_m);
  curve_.force_N.push_back(along_N);
  curve_.slide_N.push_back(0.0);
}

}  // namespace unbruised
