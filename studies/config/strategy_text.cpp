#include "studies/config/strategy_text.hpp"

#include "studies/config/key_lines.hpp"

namespace unbruised::studies {

std::string strategy_lines(const Scenario& scenario) {
  Scenario copy = scenario;
  std::string text = key_lines("strategy.", copy, 0);
  for (std::size_t i = 0; i < copy.strategy.waypoint.size(); ++i) {
    text += "\n[[waypoint]]\n" + key_lines("strategy.waypoint[].", copy, static_cast<int>(i));
  }
  return text;
}

}  // namespace unbruised::studies
