#pragma once

/// @file
/// The winner of a study whose scenarios are known beforehand (sweep, compare), looked at again at half the time
/// step: how the numbers that decide moved, and whether it is still the winner.

#include <string>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/findings/grid_answer.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// The study's rows once as they are, and once with those repeated that the answer rests on.
struct RowsTwice {
  const StudyRows& found;
  const StudyRows& again;
  std::size_t repeated = 0;  ///< rows that differ
};

/// Table `verification` of a sweep's best strategy: is it held in the same combinations? @param found has a best
ResultTable grid_check(const Study& study, const GridAnswer& found, const RowsTwice& rows);

/// Table `verification` of a comparison that has a winner. @param tables compare_tables of the rows as found
ResultTable compare_check(const Study& study, const std::vector<ResultTable>& tables, const RowsTwice& rows);

}  // namespace unbruised::studies
