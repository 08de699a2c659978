#pragma once

/// @file
/// One scenario alone, in the same kernels as any batch; and what becomes of exceptions: causes of rows.

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/outcome/curve.hpp"
#include "core/outcome/outcome.hpp"
#include "core/outcome/replay.hpp"
#include "core/outcome/trace.hpp"
#include "core/scenario/scenario.hpp"
#include "studies/execution/simulator.hpp"

namespace unbruised::studies {

/// A result that says why there is none: `diverged` with the cause.
ScenarioResult failed_result(std::string cause);
/// The exception being handled, as the cause of a row.
std::string current_exception_text();
/// The model of a scenario, or why it cannot be built: an exception is a reason too.
ModelOrReason build_model(const Simulator& simulator, const Scenario& scenario);
/// One scenario in fresh lanes until it ends; nothing when stopped. @param stop may be null.
std::optional<ScenarioResult> run_in_fresh_lanes(const SharedModel& model, const Scenario& scenario,
                                                 const Recording& kept, const std::atomic<bool>* stop);
/// The same with a model of its own.
/// @return nothing when stopped; a `diverged` result with the cause where there is no model or an exception.
std::optional<ScenarioResult> run_alone(const Simulator& simulator, const Scenario& scenario,
                                        const Recording& kept, const std::atomic<bool>* stop);
/// Scenarios of one factor key beside each other in fresh lanes, as many as there are lanes at most.
/// @return their results; nothing when stopped
std::optional<std::vector<ScenarioResult>> run_side_by_side(const Simulator& simulator,
                                                            const std::vector<Scenario>& scenarios,
                                                            const std::vector<Recording>& kept,
                                                            const std::atomic<bool>* stop);

/// Does the flag say so? Never when null.
inline bool is_set(const std::atomic<bool>* flag) {
  return flag != nullptr && flag->load(std::memory_order_relaxed);
}

}  // namespace unbruised::studies
