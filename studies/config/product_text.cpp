#include "studies/config/product_text.hpp"

#include <variant>

#include "studies/config/key_lines.hpp"
#include "studies/config/schema.hpp"

namespace unbruised::studies {

std::string product_lines(const Scenario& scenario) {
  Scenario copy = scenario;
  const bool is_network = std::holds_alternative<NetworkParameters>(copy.product);
  std::string text = is_network ? "kind = \"network\"\n" : "kind = \"lattice\"\n";
  text += key_lines("product.", copy, 0);
  for (const std::string list : {"particle", "spring", "load"}) {
    const std::string path = "product." + list + "[].";
    for (std::size_t i = 0; i < scenario_list_size(copy, path).value_or(0); ++i) {
      text += "\n[[" + list + "]]\n" + key_lines(path, copy, static_cast<int>(i));
    }
  }
  return text + "\n[limits]\n" + key_lines("limits.", copy, 0);
}

}  // namespace unbruised::studies
