#include "studies/results/run_lock.hpp"

#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "studies/results/durable_files.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kCompactionLine = "purpose = compaction\n";
/// Between two looks at a lock that will be free soon.
constexpr std::chrono::milliseconds kPause{20};
/// Looks before the holder is believed: it may have locked the file and not yet written into it.
constexpr int kLooksAtARun = 2;
/// Looks at a compaction: a minute.
constexpr int kLooksAtACompaction = 3000;

std::string lock_text(LockPurpose purpose) {
  return joined({"host = ", host_name(), "\npid = ", std::to_string(::getpid()), "\nboot_id = ", boot_id(), "\n",
                 purpose == LockPurpose::compaction ? kCompactionLine : std::string_view{}});
}

// "host = a, pid = 12, ..." of the text in a lock file.
std::string holder_of(std::string text) {
  if (text.empty()) return "unknown";
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at)) {
    text.replace(at, 1, ", ");
  }
  return text;
}

// A directory may have been moved aside between the opening of its lock file and the locking of it.
bool still_stands(int descriptor, const fs::path& path) {
  struct stat held = {};
  struct stat named = {};
  return ::fstat(descriptor, &held) == 0 && ::stat(path.c_str(), &named) == 0 && held.st_dev == named.st_dev &&
         held.st_ino == named.st_ino;
}

MaybeError write_holder(int descriptor, const fs::path& path, LockPurpose purpose) {
  const std::string text = lock_text(purpose);
  if (::ftruncate(descriptor, 0) != 0) return system_error("truncate", path, errno);
  const ssize_t written = ::pwrite(descriptor, text.data(), text.size(), 0);
  if (written == static_cast<ssize_t>(text.size())) return {};
  return system_error("write", path, written < 0 ? errno : ENOSPC);
}

}  // namespace

Expected<RunLock> RunLock::take(const fs::path& directory, LockPurpose purpose) {
  const fs::path path = directory / "lock";
  for (int look = 1;; ++look) {
    RunLock lock;
    lock.descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (lock.descriptor_ < 0) return system_error("create", path, errno);
    const int kind = purpose == LockPurpose::part ? LOCK_SH : LOCK_EX;
    const bool locked = ::flock(lock.descriptor_, kind | LOCK_NB) == 0;
    const int reason = locked ? 0 : errno;
    if (locked && !still_stands(lock.descriptor_, path)) continue;
    if (locked || reason != EWOULDBLOCK) {
      lock.excludes_others_ = locked;
      if (auto error = write_holder(lock.descriptor_, path, purpose)) return *error;
      return lock;
    }
    const auto written = read_text_file(path);
    const std::string text = written ? *written : std::string();
    const bool compacting = text.ends_with(kCompactionLine) && purpose != LockPurpose::compaction;
    if (look >= (compacting ? kLooksAtACompaction : kLooksAtARun)) {
      return ResultsError{ResultsErrorKind::busy,
                          joined({directory.string(), " is in use by another process (", holder_of(text), ")"}),
                          {}};
    }
    std::this_thread::sleep_for(kPause);
  }
}

RunLock::RunLock(RunLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), excludes_others_(other.excludes_others_) {}

RunLock& RunLock::operator=(RunLock&& other) noexcept {
  if (this != &other) {
    release();
    descriptor_ = std::exchange(other.descriptor_, -1);
    excludes_others_ = other.excludes_others_;
  }
  return *this;
}

void RunLock::release() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

}  // namespace unbruised::studies
