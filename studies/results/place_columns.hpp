#pragma once

/// @file
/// The columns that say which question of a search a row answered: one list for writer and reader.

#include <array>
#include <cstdint>
#include <utility>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

inline constexpr std::array<std::pair<const char*, std::uint64_t SearchPlace::*>, 3> kPlaceColumns = {{
    {"/scenarios/search", &SearchPlace::search},
    {"/scenarios/generation", &SearchPlace::generation},
    {"/scenarios/index", &SearchPlace::index},
}};

}  // namespace unbruised::studies
