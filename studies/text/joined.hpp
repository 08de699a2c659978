#pragma once

/// @file
/// Building messages.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace unbruised::studies {

/// The parts one after the other.
inline std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text.append(part);
  return text;
}

/// "a, b, c"
inline std::string comma_list(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += joined({text.empty() ? "" : ", ", part});
  return text;
}

}  // namespace unbruised::studies
