#pragma once

/// @file
/// One specimen's fit: NLopt on the mean square of the residuals, with differences whose points are asked
/// together, then Gauss-Newton steps, then the intervals by their profiles.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/outcome/curve.hpp"
#include "studies/config/study.hpp"
#include "studies/findings/specimen_fit.hpp"

namespace unbruised::studies {

/// The curve of a test at places x (closure or time): linear between its entries and from the first contact on; a
/// press is read where it first closes by x, and beyond its end goes on along the line from the first contact (a
/// finger whose force is spent closes no further); over time the last value stays. Empty for a curve without
/// entries.
std::vector<double> values_at(const Curve& curve, CurveTest test, std::span<const double> x);

/// The curves at points in the keys' own units, in their order; nothing: the study is being stopped. An empty
/// curve stands for a scenario that gave none.
using AskCurves = std::function<std::optional<std::vector<Curve>>(const std::vector<std::vector<double>>& points)>;

/// Scenarios that one fit asks for, at most. @param budget of its search
std::size_t fit_scenarios_at_most(std::size_t keys, std::size_t budget);

/// @param keys what is fitted: ranges, scales, starts
/// @return nothing when stopped
std::optional<SpecimenFit> fit_specimen(const std::vector<SearchVariable>& keys, const CalibrateSettings& settings,
                                        const MeasuredCurve& measured, const AskCurves& ask);

}  // namespace unbruised::studies
