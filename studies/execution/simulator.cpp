#include "studies/execution/simulator.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "core/motion/motion_plan.hpp"
#include "studies/execution/arm_run.hpp"
#include "studies/execution/helper_thread.hpp"

namespace unbruised::studies {
namespace {

class CoreLanes final : public LaneEngine {
 public:
  CoreLanes(std::shared_ptr<const Model> model, LevelSimulation::Longer longer)
      : lanes_(std::move(model), std::move(longer)) {}
  void load(int place, const Scenario& scenario) override {
    if (!has_robot(scenario)) return lanes_.load(place, scenario);
    const auto carried = arms_.insert_or_assign(place, Carried{ArmRun(scenario), nullptr}).first;
    lanes_.load(place, carried->second.arm.scenario());
  }
  void record(int place, const Recording& kept) override {
    lanes_.record(place, kept);
    if (const auto carried = arms_.find(place); carried != arms_.end()) carried->second.trace = kept.trace;
  }
  void step(bool on_two_threads) override {
    on_two_threads ? step_on_two_threads() : lanes_.step();
    judged_.clear();
    if (!arms_.empty()) judge_finished();
  }
  int stepped() const override { return lanes_.stepped(); }
  int stepped_batches() const override { return lanes_.stepped_batches(); }
  const std::vector<Finished>& finished() const override { return judged_.empty() ? lanes_.finished() : judged_; }

 private:
  struct Carried {
    ArmRun arm;
    Trace* trace;
  };

  void step_on_two_threads() {
    if (!helper_) helper_.emplace();
    lanes_.step({.both = [this](std::function<void()> first,
                                const std::function<void()>& second) { helper_->run(std::move(first), second); },
                 .alone =
                     [this](const std::function<void()>& act) {
                       const std::lock_guard lock(mutex_);
                       act();
                     }});
  }

  void judge_finished() {
    judged_ = lanes_.finished();
    for (Finished& finished : judged_) {
      const auto carried = arms_.find(finished.place);
      if (carried == arms_.end()) continue;
      carried->second.arm.judge(finished.result);
      if (Trace* trace = carried->second.trace) carried->second.arm.add_joints(finished.result, *trace);
      arms_.erase(carried);
    }
  }

  LevelSimulation lanes_;
  std::mutex mutex_;
  std::optional<HelperThread> helper_;
  std::map<int, Carried> arms_;   ///< by place
  std::vector<Finished> judged_;  ///< what finished in the last step, where one of them has an arm
};

class CoreModel final : public SharedModel {
 public:
  explicit CoreModel(std::shared_ptr<const Model> model) : model_(std::move(model)) {}
  std::unique_ptr<LaneEngine> make_lanes() const override {
    return std::make_unique<CoreLanes>(
        model_, [this](int ticks, const Scenario& scenario) { return with_ticks(ticks, scenario); });
  }

 private:
  /// The one of all threads.
  std::shared_ptr<const Model> with_ticks(int ticks, const Scenario& scenario) const {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<const Model>& longer = longer_[ticks];
    if (!longer) longer = model_->with_ticks(ticks, scenario);
    return longer;
  }

  std::shared_ptr<const Model> model_;
  mutable std::mutex mutex_;
  mutable std::map<int, std::shared_ptr<const Model>> longer_;  ///< by ticks
};

class CoreSimulator final : public Simulator {
 public:
  int lane_count() const override { return unbruised::lane_count(); }
  int place_count() const override { return level_place_count(); }
  std::string factor_key(const Scenario& scenario) const override { return unbruised::factor_key(scenario); }
  double duration_s(const Scenario& scenario) const override { return planned_end_s(scenario); }
  ModelOrReason build(const Scenario& scenario) const override {
    std::string error;
    std::shared_ptr<const Model> model = Model::build(scenario, error);
    if (!model) return error.empty() ? std::string("the model cannot be built") : error;
    return std::shared_ptr<const SharedModel>(std::make_shared<CoreModel>(std::move(model)));
  }
};

}  // namespace

const Simulator& core_simulator() {
  static const CoreSimulator simulator;
  return simulator;
}

}  // namespace unbruised::studies
