#include "studies/results/suspect_results.hpp"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "studies/results/child_process.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/packed_results.hpp"
#include "studies/results/run_layout.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

namespace {

/// Busy where another program has the file open for writing: HDF5 locks what it writes.
MaybeError refuse_if_in_use(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return {};  // what reads the file says so
  const bool in_use = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  if (!in_use) return {};
  return ResultsError{
      ResultsErrorKind::busy,
      joined({path.string(), " is in use: another program has it open for writing; close it there and try again"}),
      {}};
}

template <class T>
Expected<T> read_in_child(const fs::path& path, Expected<T> (*read)(const fs::path&)) {
  if (auto error = refuse_if_in_use(path)) return *error;
  const auto text = in_child_process(path, [&] { return packed(read(path)); });
  if (!text) return text.error();
  return unpacked<T>(*text);
}

/// A running study may replace the file between the reading of hash and file, so a mismatch is looked at again.
constexpr int kLooksAtTheHash = 5;

}  // namespace

Expected<ResultsSummary> read_suspect_summary(const fs::path& path) {
  return read_in_child<ResultsSummary>(path, read_results_summary);
}

MaybeError check_file_hash(const fs::path& path) {
  for (int look = 1; look <= kLooksAtTheHash; ++look) {
    const auto before = read_text_file(hash_path(path));
    const auto bytes = before ? read_text_file(path) : before;
    if (!before || !bytes) return {};  // no hash, or nothing to read: what reads the file says so
    if (*before == hash_line(*bytes)) return {};
    const auto after = read_text_file(hash_path(path));
    if (after && *after == *before && look > 1) {
      return ResultsError{ResultsErrorKind::damaged,
                          joined({path.string(), " is damaged: it does not match ", hash_path(path).string()}),
                          {}};
    }
    ::usleep(20000);
  }
  return {};
}

Expected<ResultsSummary> read_hashed_summary(const fs::path& path) {
  if (auto error = refuse_if_in_use(path)) return *error;
  if (auto error = check_file_hash(path)) return *error;
  return read_suspect_summary(path);
}

Expected<Trace> read_suspect_trace(const fs::path& path) { return read_in_child<Trace>(path, read_trace); }

}  // namespace unbruised::studies
