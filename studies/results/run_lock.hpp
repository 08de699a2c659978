#pragma once

/// @file
/// Who may write into a run directory, held by flock, so nothing stale is left by a kill: one process that runs
/// its study, or several that run parts of it.

#include <filesystem>
#include <string>

#include "studies/results/expected.hpp"

namespace unbruised::studies {

/// What a process holds a run directory for.
enum class LockPurpose {
  run,         ///< to run its study: whoever comes later is refused
  part,        ///< to run a part of it, beside others who do the same
  compaction,  ///< to write results.h5 from the journals: over in a moment, so a run waits for it
};

/// The lock file of a run directory, locked; host, process and boot id of the holder stand in it.
class RunLock {
 public:
  /// Busy (names the holder) when another process has it; io. The directory must be there.
  static Expected<RunLock> take(const std::filesystem::path& directory, LockPurpose purpose);
  RunLock() = default;
  RunLock(RunLock&& other) noexcept;
  RunLock& operator=(RunLock&& other) noexcept;
  ~RunLock() { release(); }
  void release();
  /// False where the file system has no locks.
  [[nodiscard]] bool excludes_others() const { return excludes_others_; }

 private:
  int descriptor_ = -1;
  bool excludes_others_ = true;
};

}  // namespace unbruised::studies
