#pragma once

/// @file
/// The few POSIX calls the promises about `kill -9` and power loss rest on, with errors that name the path.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "studies/results/expected.hpp"

namespace unbruised::studies {

/// An io error: "cannot <action> <path>: <reason of errno>".
ResultsError system_error(std::string_view action, const std::filesystem::path& path, int error_number);

/// Makes names created in or renamed into `directory` durable.
MaybeError sync_directory(const std::filesystem::path& directory);

/// Makes the contents of `path` durable.
MaybeError sync_file(const std::filesystem::path& path);

/// Writes `text` to `path` atomically and durably: to `<path>.tmp`, synced, renamed, the directory synced. A
/// failure leaves an old `path` untouched and no temporary file.
MaybeError write_text_file(const std::filesystem::path& path, std::string_view text);

/// `<path>.tmp`: where a file is made before it takes its name.
std::filesystem::path temporary_of(const std::filesystem::path& path);

/// Gives a synced temporary file its name, durably.
MaybeError publish_file(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// Shows a file piece by piece, some of it in memory at a time.
MaybeError read_in_pieces(const std::filesystem::path& path, const std::function<void(std::string_view)>& look);

/// The whole file.
Expected<std::string> read_text_file(const std::filesystem::path& path);

std::string host_name();
/// The kernel's boot id; "unknown" where there is none.
std::string boot_id();

}  // namespace unbruised::studies
