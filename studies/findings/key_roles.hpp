#pragma once

/// @file
/// What a varied key is to the answer of a study: something that is chosen, something that the answer has to hold
/// over, or something that each has an answer of its own.

#include <string_view>

namespace unbruised::studies {

enum class KeyRole {
  chosen,  ///< strategy.*: typed into the robot; the answer picks a value
  /// product.*, cell.*, the moment of a stop, the noise of instruments: nature and the cell; the answer holds over
  /// all values, or says for which not
  given,
  apart,  ///< gripper.* (hardware that is bought, not set), limits.*, simulation.*: an answer for each value
};

/// The role of a dotted key, e.g. "product.youngs_modulus_Pa".
KeyRole key_role(std::string_view key);

}  // namespace unbruised::studies
