#include "studies/findings/held_proportion.hpp"

#include "studies/goals/event.hpp"

namespace unbruised::studies {

Proportion held_proportion(const std::vector<const ScenarioRow*>& rows, const ProductSample& products,
                           const LimitParameters& limits, double confidence) {
  std::vector<bool> held;
  std::vector<double> measure;
  for (const ScenarioRow* row : rows) {
    held.push_back(event_happens(held_event(), row->result, limits));
    measure.push_back(event_measure(held_event(), row->result, limits));
  }
  return sampled_proportion(held, products.structure(), confidence, measure);
}

}  // namespace unbruised::studies
