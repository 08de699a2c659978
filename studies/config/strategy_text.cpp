#include "studies/config/strategy_text.hpp"

#include <string_view>

#include "studies/config/schema.hpp"

namespace unbruised::studies {

namespace {

/// The keys right below a table, one a line. @param index of its place in a list
std::string lines_of(std::string_view table, Scenario& scenario, int index) {
  std::string text;
  for (const KeySpec& spec : key_table()) {
    const std::size_t leaf = spec.path.rfind('.') + 1;
    if (spec.path.substr(0, leaf) != table || spec.field == nullptr) continue;
    if (!scenario_uses(spec.use, scenario, {})) continue;
    const std::string value = spelled(spec, spec.field(scenario, index));
    if (!value.empty()) text += std::string(spec.path.substr(leaf)) + " = " + value + "\n";
  }
  return text;
}

}  // namespace

std::string strategy_lines(const Scenario& scenario) {
  Scenario copy = scenario;
  std::string text = lines_of("strategy.", copy, 0);
  for (std::size_t i = 0; i < copy.strategy.waypoint.size(); ++i) {
    text += "\n[[waypoint]]\n" + lines_of("strategy.waypoint[].", copy, static_cast<int>(i));
  }
  return text;
}

}  // namespace unbruised::studies
