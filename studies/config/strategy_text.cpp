#include "studies/config/strategy_text.hpp"

#include <string_view>

#include "studies/config/schema.hpp"

namespace unbruised::studies {

std::string strategy_lines(const Scenario& scenario) {
  constexpr std::string_view kTable = "strategy.";
  Scenario copy = scenario;
  std::string text;
  for (const KeySpec& spec : key_table()) {
    const bool is_list = spec.path.find("[]") != std::string_view::npos;
    if (!spec.path.starts_with(kTable) || spec.field == nullptr || is_list) continue;
    if (!scenario_uses(spec.use, copy, {})) continue;
    const std::string value = spelled(spec, spec.field(copy, 0));
    if (!value.empty()) text += std::string(spec.path.substr(kTable.size())) + " = " + value + "\n";
  }
  return text;
}

}  // namespace unbruised::studies
