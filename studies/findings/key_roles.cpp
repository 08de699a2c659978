#include "studies/findings/key_roles.hpp"

namespace unbruised::studies {

KeyRole key_role(std::string_view key) {
  // Nobody chooses when the button is hit, nor the luck of an instrument.
  if (key == "strategy.stop_time_s" || key.ends_with(".noise_seed")) return KeyRole::given;
  if (key.starts_with("strategy.")) return KeyRole::chosen;
  if (key.starts_with("product.") || key.starts_with("cell.")) return KeyRole::given;
  return KeyRole::apart;
}

}  // namespace unbruised::studies
