#pragma once

/// @file
/// What the kinds beside sweep and window found, as tables for results.h5, `info` and the report
/// (docs/results.md).

#include <string_view>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/findings/search_findings.hpp"
#include "studies/findings/strategy_judge.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// Tables of optimize, robust and pareto: searches, evaluations, best, constraints, verification, pareto, random.
/// @param rows numbered, so that the tables can name scenarios
std::vector<ResultTable> search_tables(const StrategyJudge& judge, const SearchFindings& found,
                                       const StudyRows& rows);

/// Tables of compare: candidates, comparison, random. @param rows all of the study's, by id
std::vector<ResultTable> compare_tables(const Study& study, const StudyRows& rows);

/// Column of the table sensitivity: why a metric has no effects to tell ("does not vary"); empty where it has.
inline constexpr std::string_view kEffectNoteColumn = "note";

/// Tables of sensitivity: sensitivity. @param rows all of the study's, by id
std::vector<ResultTable> sensitivity_tables(const Study& study, const StudyRows& rows);

/// Tables of sample: random, statistics. @param rows all of the study's, by id
std::vector<ResultTable> sample_tables(const Study& study, const StudyRows& rows);

}  // namespace unbruised::studies
