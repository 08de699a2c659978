#pragma once

/// @file
/// A trace on its way into the page: few enough rows to draw, without losing a peak.

#include <cstddef>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/outcome/trace.hpp"
#include "studies/report/packed_columns.hpp"

namespace unbruised::studies {

/// Times and signals as curves with names; signals with very many columns are left out.
nlohmann::json trace_json(PackedColumns& packed, const Trace& trace);

/// Most rows of a trace that go into a page.
inline constexpr std::size_t kTraceRowsMost = 4000;

/// For curves with more than kTraceRowsMost rows: which pairs of rows stand for the others. Rows are cut into
/// kTraceRowsMost / 2 equal parts; each part becomes two rows, the lesser and the greater value of every curve in
/// the order in which they occur, so that no peak is lost.
std::vector<double> thinned_keeping_peaks(const std::vector<double>& values);
/// The times that go with them: first and middle row of each part.
std::vector<double> thinned_times(const std::vector<double>& time_s);

}  // namespace unbruised::studies
