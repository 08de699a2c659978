#pragma once

/// @file
/// The columns that say which question of a search, or which force of a window study, a row answered: one list
/// for writer and reader.

#include <array>
#include <cstdint>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

struct PlaceColumn {
  const char* name;
  std::uint64_t SearchPlace::*field;
  const char* long_name;
};
using PlaceColumns = std::array<PlaceColumn, 3>;

inline constexpr PlaceColumns kQuestionColumns = {{
    {"/scenarios/search", &SearchPlace::search, "number of the search that asked"},
    {"/scenarios/generation", &SearchPlace::generation, "number of the question inside its search"},
    {"/scenarios/index", &SearchPlace::index, "number inside the question: finite differences, random products"},
}};
inline constexpr PlaceColumns kForceColumns = {{
    {"/scenarios/round", &SearchPlace::search, "number of the round of forces; from 100 on at half the time step"},
    {"/scenarios/combination", &SearchPlace::generation, "number of the combination of the varied keys"},
    {"/scenarios/number", &SearchPlace::index, "number of the force in its round and combination"},
}};

}  // namespace unbruised::studies
