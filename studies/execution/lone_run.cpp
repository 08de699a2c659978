#include "studies/execution/lone_run.hpp"

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
                                                 Records records, const std::atomic<bool>* stop) {
  try {
    const std::unique_ptr<LaneEngine> lanes = model.make_lanes();
    lanes->load(0, scenario);
    if (records.trace != nullptr) lanes->record_trace(0, *records.trace);
    if (records.curve != nullptr) lanes->record_curve(0, *records.curve);
    while (!is_set(stop)) {
      lanes->step();
      if (!lanes->finished().empty()) return lanes->finished().front().result;
    }
    return std::nullopt;
  } catch (...) {
    return failed_result(current_exception_text());
  }
}

std::optional<ScenarioResult> run_alone(const Simulator& simulator, const Scenario& scenario, Trace* trace,
                                        const std::atomic<bool>* stop) {
  const ModelOrReason model = build_model(simulator, scenario);
  if (!model) return failed_result(model.error());
  return run_in_fresh_lanes(**model, scenario, {.trace = trace}, stop);
}

}  // namespace unbruised::studies
