#include "core/simulation/outcome_observer.hpp"

#include <cmath>

namespace unbruised {

bool OutcomeObserver::observe(const LaneStep& step) {
  contact_sweeps_ += step.contact_sweeps;
  plastic_rounds_ += step.plastic_rounds;
  const bool goes_on = record_.observe(step.seen, step.cycle);
  check_validity(step);
  return goes_on && !record_.aborted();
}

/// Ends runs whose numbers are not finite or whose deformation linear strain does not describe.
void OutcomeObserver::check_validity(const LaneStep& step) {
  const LaneView& view = step.view;
  const SimulationParameters& bounds = step.scenario.simulation;
  double size = 0.0;
  for (const auto* sums : {&view.body.mass_u(), &view.body.mass_a()}) {
    for (const Lane& sum : *sums) size += sum[step.lane];
  }
  const double strain = view.material.largest_strain()[step.lane];
  if (!std::isfinite(size) || !std::isfinite(strain)) {
    record_.abort(Outcome::diverged, "the motion is not finite", step.time_s);
  } else if (strain > bounds.max_strain) {
    record_.abort(Outcome::out_of_range, "a cell's strain > simulation.max_strain", step.time_s);
  } else if (view.model.body.is_solid && view.body.rotation_rad(step.lane) > bounds.max_rotation_rad) {
    record_.abort(Outcome::out_of_range, "the product's rotation > simulation.max_rotation_rad", step.time_s);
  }
}

void OutcomeObserver::end(const LaneStep& last) {
  Metrics& metrics = record_.metrics;
  metrics[Metric::step_count] = static_cast<double>(last.count);
  metrics[Metric::contact_iterations] = contact_sweeps_;
  metrics[Metric::plasticity_iterations] = plastic_rounds_;
  if (!record_.aborted()) last.view.measure_permanent_set(last.lane, last.scenario.limits, metrics);
  if (!record_.diverged()) balances_.measure(last.lane, last.time_s, last.view, last.scenario, metrics);
  result_ = record_.finish(last.cycle, last.time_s);
}

}  // namespace unbruised
