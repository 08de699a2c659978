#pragma once

/// @file
/// Errors drawn around the value that a key has in its scenario, be it searched, a candidate's own or written:
/// what a robot is told and what it does. They travel under a name of their own beside the values of other keys.

#include <optional>
#include <string>

#include "studies/config/schema.hpp"

namespace unbruised::studies {

enum class ErrorKind {
  relative,  ///< value x (1 + error)
  absolute,  ///< value + error
};

/// A key and how its error acts.
struct KeyError {
  std::string key;
  ErrorKind kind;
};

/// "strategy.grip_force_N_relative_error", "cell.grip_offset_m_error"
std::string error_name(const KeyError& error);
/// The key a value of this name acts on: that of the error, or the name itself.
std::string key_behind(const std::string& name);

/// Writes a value into the field of a key; of the name of an error, moves the value that is there.
void apply_named(Scenario& scenario, const std::string& name, double value);

/// Does the block draw an error, and of which kind? With both kinds given it is relative.
std::optional<ErrorKind> error_kind(const RandomBlock& block);
/// The distribution of the error of such a block: within +- `relative` or `absolute`, even, peaked at 0, or normal
/// with half of that as standard deviation, cut off there.
Distribution error_distribution(const RandomBlock& block);

}  // namespace unbruised::studies
