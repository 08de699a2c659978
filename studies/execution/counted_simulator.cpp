#include "studies/execution/counted_simulator.hpp"

#include <memory>
#include <utility>

namespace unbruised::studies {
namespace {

class CountedLanes final : public LaneEngine {
 public:
  CountedLanes(std::unique_ptr<LaneEngine> lanes, Progress& progress)
      : lanes_(std::move(lanes)), progress_(progress) {}

  void load(int lane, const Scenario& scenario) override {
    lanes_->load(lane, scenario);
    ++busy_;
  }
  void record_trace(int lane, Trace& trace) override { lanes_->record_trace(lane, trace); }
  void record_replay(int lane, Replay& replay, double interval_s) override {
    lanes_->record_replay(lane, replay, interval_s);
  }
  void step() override {
    lanes_->step();
    progress_.count_steps(busy_);
    busy_ -= lanes_->finished().size();
  }
  [[nodiscard]] const std::vector<LaneSimulation::Finished>& finished() const override {
    return lanes_->finished();
  }

 private:
  std::unique_ptr<LaneEngine> lanes_;
  Progress& progress_;
  std::size_t busy_ = 0;
};

class CountedModel final : public SharedModel {
 public:
  CountedModel(std::shared_ptr<const SharedModel> model, Progress& progress)
      : model_(std::move(model)), progress_(progress) {}

  [[nodiscard]] std::unique_ptr<LaneEngine> make_lanes() const override {
    return std::make_unique<CountedLanes>(model_->make_lanes(), progress_);
  }

 private:
  std::shared_ptr<const SharedModel> model_;
  Progress& progress_;
};

}  // namespace

ModelOrReason CountedSimulator::build(const Scenario& scenario) const {
  ModelOrReason model = simulator_.build(scenario);
  if (!model) return model;
  return std::shared_ptr<const SharedModel>(std::make_shared<CountedModel>(*std::move(model), progress_));
}

}  // namespace unbruised::studies
