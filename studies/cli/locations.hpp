#pragma once

/// @file
/// Where the library of products, grippers and studies is.

#include <filesystem>

namespace unbruised::studies {

/// The first of these that holds a library: the folder named `configs` that the study is in, `configs` beside the
/// study, `configs` in the working directory, the one of the program's source tree. The last also when none does.
/// @param study may be empty.
std::filesystem::path config_root_for(const std::filesystem::path& study);

}  // namespace unbruised::studies
