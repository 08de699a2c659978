#pragma once

/// @file
/// What is said about a study before it runs, and travels with its answer: on stderr, in the log, in results.h5
/// and on the page.

#include <string>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// Sentences, one per doubt: those of reading the study (`Study::warnings`), then those that look at its
/// scenarios. The same from `check` and `run`; empty when there is nothing to say.
std::vector<std::string> study_warnings(const Study& study);

}  // namespace unbruised::studies
