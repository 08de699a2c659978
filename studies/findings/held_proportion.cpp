#include "studies/findings/held_proportion.hpp"

#include "studies/goals/event.hpp"

namespace unbruised::studies {

void HeldRows::add(const ScenarioResult& result, const LimitParameters& limits) {
  held_.push_back(event_happens(held_event(), result, limits));
  measure_.push_back(event_measure(held_event(), result, limits));
}

Proportion HeldRows::proportion(const ProductSample& products, double confidence) const {
  return sampled_proportion(held_, products.structure(), confidence, measure_);
}

}  // namespace unbruised::studies
