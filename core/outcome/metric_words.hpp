#pragma once

/// @file
/// What people call the metrics: short enough for a headline, an axis or a sentence.

#include <array>
#include <string_view>

#include "core/outcome/outcome.hpp"

namespace unbruised {

/// In the order of `Metric`, lower case, without a unit.
inline constexpr std::array<std::string_view, kMetricCount> kMetricWords = {
    "permanent set",
    "permanent set, r.m.s.",
    "plastic strain",
    "bruised volume",
    "absorbed energy",
    "contact yield ratio",
    "peak finger force",
    "peak pressure",
    "compression",
    "slip",
    "friction margin",
    "hold drift",
    "peak sensor force",
    "peak sensor torque",
    "peak acceleration",
    "cycle time",
    "time of first contact",
    "start of the lift",
    "energy put in",
    "energy balance error",
    "impulse balance error",
    "time steps",
    "contact iterations",
    "plasticity iterations",
    "grip impulse",
    "angle of slip",
    "steps of the peak's rise",
};

/// "contact yield ratio"
constexpr std::string_view metric_words(Metric metric) { return kMetricWords[static_cast<std::size_t>(metric)]; }

}  // namespace unbruised
