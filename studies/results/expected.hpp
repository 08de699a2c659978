#pragma once

/// @file
/// What comes back from files: a value or a typed error. Nothing in studies/results throws across its door.

#include <optional>
#include <string>
#include <vector>

#include "studies/text/value_or.hpp"

namespace unbruised::studies {

/// Why a file or a run directory could not be used. The caller maps it to an exit status.
enum class ResultsErrorKind {
  io,            ///< the disk, the file system or HDF5 failed (exit 5)
  busy,          ///< another process holds the run directory (exit 4)
  finished,      ///< the run directory already holds complete results (exit 2)
  other_config,  ///< the run directory belongs to another config (exit 2)
  other_build,   ///< the run directory was begun by another version or numeric build (exit 2)
  foreign,       ///< not a file or directory of this program, or of a version it cannot read (exit 2)
  not_built,     ///< this build of the program lacks what is asked for (exit 2)
  damaged,       ///< checksums or contents do not agree (exit 6)
};

/// One error: its kind, a full sentence for the user (with the path in it), and the keys in question.
struct ResultsError {
  ResultsErrorKind kind = ResultsErrorKind::io;
  std::string message;
  std::vector<std::string> keys;  ///< other_config: the dotted keys that differ
};

/// The exit status interfaces promise for an error of this kind.
int exit_status(ResultsErrorKind kind);

/// Nothing on success.
using MaybeError = std::optional<ResultsError>;

/// A value of type T, or the error that prevented it.
template <class T>
using Expected = ValueOr<T, ResultsError>;

}  // namespace unbruised::studies
