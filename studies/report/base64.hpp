#pragma once

/// @file
/// Base64 (RFC 4648, section 4).

#include <string>
#include <string_view>

namespace unbruised::studies {

/// With padding, without line breaks.
std::string base64(std::string_view bytes);

}  // namespace unbruised::studies
