#pragma once

/// @file
/// Always-on checks at the doors of modules: sizes that must agree, lanes that must exist, a factor that must be
/// there. Not for inner loops.

#include <stdexcept>

namespace unbruised {

/// Stops a caller who breaks what a door asks for, in every build.
/// @param sentence "BodyLanes::load: there is no such lane"
/// @throws std::logic_error
inline void require(bool holds, const char* sentence) {
  if (!holds) throw std::logic_error(sentence);
}

}  // namespace unbruised
