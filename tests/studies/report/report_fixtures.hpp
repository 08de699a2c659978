#pragma once

/// @file
/// Studies of every kind with numbers of the right size, made without a simulator: what the report has to show.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/outcome/trace.hpp"
#include "studies/findings/set_point.hpp"
#include "studies/report/report_data.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies::testing {

/// A study with the tables its content points to.
struct ReportFixture {
  std::string name;
  ResultsContent content;
  ReportContext context;
  std::shared_ptr<WindowTable> window;
  std::shared_ptr<Trace> trace;
  ForceSetting gripper{.min_N = 0.5, .max_N = 60.0, .accuracy = 0.05, .step_N = 0.1};
};

/// Every kind, and what may go wrong: no window, none feasible, no difference, not complete, diverged scenarios,
/// texts that try to be markup or script, a table the page does not know.
std::vector<ReportFixture> report_fixtures();

/// A sweep of `rows` scenarios over grip force and approach speed.
ReportFixture large_fixture(std::size_t rows);

/// The texts in the fixture `hostile`: closing tags, event handlers, comments, line separators, bytes that are no
/// UTF-8.
std::vector<std::string> hostile_texts();

}  // namespace unbruised::studies::testing
