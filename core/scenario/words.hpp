#pragma once

/// @file
/// Numbers inside the sentences of rules.

#include <string>

namespace unbruised {

/// The shortest text that reads back to the same bits, as a TOML number: "1.0", "1e6", "2.5e-4", "nan".
std::string spelled(double number);

/// The same without the ".0" of whole numbers: "0", "1.37".
std::string spelled_plain(double number);

/// A part of 1 in per cent: "5 %".
std::string in_per_cent(double part);

/// Four digits that a person reads: "1,022,000", "0.08333", "2.5e-7".
std::string for_people(double number);

}  // namespace unbruised
