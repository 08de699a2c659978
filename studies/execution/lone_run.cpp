#include "studies/execution/lone_run.hpp"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace unbruised::studies {

ScenarioResult failed_result(std::string cause) {
  ScenarioResult result;
  result.outcome = Outcome::diverged;
  result.cause = std::move(cause);
  return result;
}

std::string current_exception_text() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::exception& error) {
    return std::string("internal error: ") + error.what();
  } catch (...) {
    return "internal error of unknown kind";
  }
}

ModelOrReason build_model(const Simulator& simulator, const Scenario& scenario) {
  try {
    return simulator.build(scenario);
  } catch (...) {
    return current_exception_text();
  }
}

std::optional<ScenarioResult> run_in_fresh_lanes(const SharedModel& model, const Scenario& scenario,
                                                 const Recording& kept, const std::atomic<bool>* stop) {
  try {
    const std::unique_ptr<LaneEngine> lanes = model.make_lanes();
    lanes->load(0, scenario);
    lanes->record(0, kept);
    while (!is_set(stop)) {
      lanes->step();
      if (!lanes->finished().empty()) return lanes->finished().front().result;
    }
    return std::nullopt;
  } catch (...) {
    return failed_result(current_exception_text());
  }
}

std::optional<ScenarioResult> run_alone(const Simulator& simulator, const Scenario& scenario,
                                        const Recording& kept, const std::atomic<bool>* stop) {
  const ModelOrReason model = build_model(simulator, scenario);
  if (!model) return failed_result(model.error());
  return run_in_fresh_lanes(**model, scenario, kept, stop);
}

std::optional<std::vector<ScenarioResult>> run_side_by_side(const Simulator& simulator,
                                                            const std::vector<Scenario>& scenarios,
                                                            const std::vector<Recording>& kept,
                                                            const std::atomic<bool>* stop) {
  std::vector<ScenarioResult> results(scenarios.size());
  const ModelOrReason model = build_model(simulator, scenarios.front());
  if (!model) {
    std::fill(results.begin(), results.end(), failed_result(model.error()));
    return results;
  }
  try {
    const std::unique_ptr<LaneEngine> lanes = (*model)->make_lanes();
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
      lanes->load(static_cast<int>(i), scenarios[i]);
      lanes->record(static_cast<int>(i), kept[i]);
    }
    std::size_t ended = 0;
    while (ended < scenarios.size()) {
      if (is_set(stop)) return std::nullopt;
      lanes->step();
      for (const LaneEngine::Finished& finished : lanes->finished()) {
        results[static_cast<std::size_t>(finished.place)] = finished.result;
        ++ended;
      }
    }
  } catch (...) {
    std::fill(results.begin(), results.end(), failed_result(current_exception_text()));
  }
  return results;
}

}  // namespace unbruised::studies
