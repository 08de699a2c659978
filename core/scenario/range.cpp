#include "core/scenario/range.hpp"

#include <cmath>

#include "core/scenario/words.hpp"

namespace unbruised {

bool Range::contains(double value) const {
  return (min_open ? value > min : value >= min) && (max_open ? value < max : value <= max);
}

std::string Range::text() const {
  std::string out;
  if (std::isfinite(min)) out += (min_open ? "> " : ">= ") + spelled_plain(min);
  if (std::isfinite(max)) {
    out += (out.empty() ? "" : ", ") + std::string(max_open ? "< " : "<= ") + spelled_plain(max);
  }
  return out;
}

}  // namespace unbruised
