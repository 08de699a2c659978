#pragma once

/// @file
/// What a study or a candidate may be called: the name becomes that of a folder.

#include <algorithm>
#include <cstddef>
#include <string>

namespace unbruised::studies {

inline constexpr std::size_t kMaxNameLength = 64;
inline constexpr const char* kNameRule = "must be 1 to 64 letters, digits, '_' or '-'";

inline bool is_name(const std::string& text) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !text.empty() && text.size() <= kMaxNameLength && std::all_of(text.begin(), text.end(), allowed);
}

}  // namespace unbruised::studies
