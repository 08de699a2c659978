#pragma once

/// @file
/// Reading that may crash, done in a child process.

#include <filesystem>
#include <functional>
#include <string>

#include "studies/results/expected.hpp"

namespace unbruised::studies {

/// What `body` returns, computed in a child process that prints nothing; damaged, with `path` in the sentence,
/// when the child ends otherwise; io when there can be no child. To be called while no other thread uses HDF5.
Expected<std::string> in_child_process(const std::filesystem::path& path,
                                       const std::function<std::string()>& body);

}  // namespace unbruised::studies
