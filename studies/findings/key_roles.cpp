#include "studies/findings/key_roles.hpp"

namespace unbruised::studies {

KeyRole key_role(std::string_view key) {
  if (key.starts_with("strategy.")) return KeyRole::chosen;
  if (key.starts_with("product.") || key.starts_with("cell.")) return KeyRole::given;
  return KeyRole::apart;
}

}  // namespace unbruised::studies
