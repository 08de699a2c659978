#include "studies/execution/counted_simulator.hpp"

#include <memory>
#include <utility>

namespace unbruised::studies {
namespace {

class CountedLanes final : public LaneEngine {
 public:
  CountedLanes(std::unique_ptr<LaneEngine> lanes, Progress& progress)
      : lanes_(std::move(lanes)), progress_(progress) {}

  void load(int place, const Scenario& scenario) override { lanes_->load(place, scenario); }
  void record(int place, const Recording& kept) override { lanes_->record(place, kept); }
  void step(bool on_two_threads) override {
    lanes_->step(on_two_threads);
    progress_.count_steps(static_cast<std::uint64_t>(lanes_->stepped()));
  }
  [[nodiscard]] int stepped() const override { return lanes_->stepped(); }
  [[nodiscard]] int stepped_batches() const override { return lanes_->stepped_batches(); }
  [[nodiscard]] const std::vector<Finished>& finished() const override { return lanes_->finished(); }

 private:
  std::unique_ptr<LaneEngine> lanes_;
  Progress& progress_;
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
