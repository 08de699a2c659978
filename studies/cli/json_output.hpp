#pragma once

/// @file
/// What `info --json` and `check --json` print; docs/json.md is the schema. Names and meanings stay within a
/// schema number; fields may be added.

#include <string>
#include <vector>

#include "studies/cli/recorded.hpp"
#include "studies/config/study.hpp"
#include "studies/estimate/study_cost.hpp"
#include "studies/findings/trace_curves.hpp"

namespace unbruised::studies {

/// All that `info` says of a run directory or results file, in one document. @param program as it was called
std::string info_json(const RecordedStudy& recorded, const std::string& program);

/// The signals of a trace at one time. @param source the file it was read from
std::string instant_json(const TraceInstant& instant, const std::string& source);

/// All that `check` says of a valid study. @param refusal why it would not run here; may be empty
std::string check_json(const Study& study, const StudyCost& cost, const std::vector<std::string>& warnings,
                       const std::vector<std::string>& notes, const std::string& refusal);
/// The same of one that is not valid.
std::string check_json_of_problems(const std::vector<std::string>& problems);

}  // namespace unbruised::studies
