#pragma once

/// @file
/// The colours in which outcomes are drawn, by the report and by scripts/plot_window.py: after Okabe and Ito, told
/// apart by the common kinds of colour blindness and in grey.

#include <array>
#include <cstddef>
#include <string_view>

#include "core/outcome/outcome.hpp"

namespace unbruised::studies {

/// Of kOutcomeWords, in their order.
inline constexpr std::array<std::string_view, kOutcomeWords.size()> kOutcomeColours = {
    "#1b9e77", "#9fd0ee", "#4a7fb0", "#e0702d", "#c9ccd1", "#222222", "#c583b0", "#c9a227"};

constexpr std::string_view outcome_colour(Outcome outcome) {
  return outcome == Outcome::not_run ? "#ffffff" : kOutcomeColours[static_cast<std::size_t>(outcome)];
}

}  // namespace unbruised::studies
