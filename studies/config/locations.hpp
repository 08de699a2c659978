#pragma once

/// @file
/// Where the library of products, grippers and studies is.

#include <filesystem>

namespace unbruised::studies {

/// The prefix that the running program was installed to.
std::filesystem::path program_prefix();

/// The first of these that holds a library: the folder named `configs` that the study is in, `configs` beside the
/// study, `$UNBRUISED_CONFIGS`, `configs` in the working directory, `unbruised/configs` below `$XDG_DATA_HOME` (by
/// default ~/.local/share), `share/unbruised/configs` of the prefix that the program was installed to, that of the
/// source tree it was built from. The last also when none does.
/// @param study may be empty. @param prefix below which `share/unbruised/configs` is looked for
std::filesystem::path config_root_for(const std::filesystem::path& study,
                                      const std::filesystem::path& prefix = program_prefix());

/// The file that a study is named by: itself, or where there is none one of that name in the first of those
/// libraries that has it, with or without `configs/` before it. What nobody has stays as it is.
std::filesystem::path study_file(const std::filesystem::path& named,
                                 const std::filesystem::path& prefix = program_prefix());

}  // namespace unbruised::studies
