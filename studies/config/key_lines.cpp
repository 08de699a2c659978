#include "studies/config/key_lines.hpp"

#include "studies/config/schema.hpp"

namespace unbruised::studies {

std::string key_lines(std::string_view table, Scenario& scenario, int index) {
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

}  // namespace unbruised::studies
