#include "studies/execution/simulator.hpp"

#include <utility>

namespace unbruised::studies {
namespace {

class CoreLanes final : public LaneEngine {
 public:
  explicit CoreLanes(std::shared_ptr<const Model> model) : lanes_(std::move(model)) {}
  void load(int lane, const Scenario& scenario) override { lanes_.load(lane, scenario); }
  void record_trace(int lane, Trace& trace) override { lanes_.record_trace(lane, trace); }
  void record_replay(int lane, Replay& replay, double interval_s) override {
    lanes_.record_replay(lane, replay, interval_s);
  }
  void step() override { lanes_.step(); }
  const std::vector<LaneSimulation::Finished>& finished() const override { return lanes_.finished(); }

 private:
  LaneSimulation lanes_;
};

class CoreModel final : public SharedModel {
 public:
  explicit CoreModel(std::shared_ptr<const Model> model) : model_(std::move(model)) {}
  std::unique_ptr<LaneEngine> make_lanes() const override { return std::make_unique<CoreLanes>(model_); }

 private:
  std::shared_ptr<const Model> model_;
};

class CoreSimulator final : public Simulator {
 public:
  int lane_count() const override { return unbruised::lane_count(); }
  std::string factor_key(const Scenario& scenario) const override { return unbruised::factor_key(scenario); }
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
