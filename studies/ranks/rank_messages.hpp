#pragma once

/// @file
/// What ranks say to one another, as bytes.

#include <cstdint>
#include <string>
#include <variant>

#include "core/outcome/curve.hpp"
#include "core/outcome/outcome.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised::studies {

enum class Curves { none, kept };

/// Of each rank but the first, once: who it is.
struct RankHello {
  std::string build;        ///< builds with the same line give the same bits
  std::uint64_t seats = 1;  ///< scenarios that it runs at a time
};
/// A new order: what comes is run with or without curves. What is still running of an earlier one is dropped.
struct RankOrder {
  Curves curves = Curves::none;
};
struct RankQuestion {
  std::uint64_t ticket = 0;
  Scenario scenario;
};
struct RankAnswer {
  std::uint64_t ticket = 0;
  ScenarioResult result;
  Curve curve;  ///< empty where none is wanted
};
/// Nothing will be asked any more.
struct RankEnd {};

using RankWord = std::variant<RankHello, RankOrder, RankQuestion, RankAnswer, RankEnd>;

std::string bytes_of(const RankWord& word);
/// Throws std::runtime_error where the bytes are none of them: ranks of one build send no such thing.
RankWord word_of(const std::string& bytes);

}  // namespace unbruised::studies
