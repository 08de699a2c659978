#include "studies/results/suspect_results.hpp"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "studies/results/checksum.hpp"
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

template <class T, class Read>
Expected<T> read_in_child(const fs::path& path, const Read& read) {
  if (auto error = refuse_if_in_use(path)) return *error;
  const auto text = in_child_process(path, [&] { return packed(read()); });
  if (!text) return text.error();
  return unpacked<T>(*text);
}

/// Of a file with more rows, a child for so many at a time: forty megabytes.
constexpr std::size_t kRowsOfAChild = 4 * kRowsAtATime;

/// Which file stands under a name.
struct FileIdentity {
  dev_t device = 0;
  ino_t number = 0;
  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};
FileIdentity identity_of(const fs::path& path) {
  struct stat state {};
  return ::stat(path.c_str(), &state) == 0 ? FileIdentity{state.st_dev, state.st_ino} : FileIdentity{};
}

/// Rows of a file that are too many for one answer.
class SuspectRows : public RowSource {
 public:
  SuspectRows(fs::path path, FileIdentity file, std::size_t count)
      : path_(std::move(path)), file_(file), count_(count) {}

  [[nodiscard]] std::size_t size() const override { return count_; }
  [[nodiscard]] RowBlock block(std::size_t first) const override { return read(first, kRowsOfAChild); }
  [[nodiscard]] ScenarioRow row(std::size_t place) const override { return read(place, 1).rows.front(); }

 private:
  [[nodiscard]] RowBlock read(std::size_t first, std::size_t most) const {
    const std::size_t count = std::min(most, count_ - first);
    auto rows =
        read_in_child<std::vector<ScenarioRow>>(path_, [&] { return read_results_rows(path_, first, count); });
    if (!rows) throw RowsFailure{rows.error()};
    if (identity_of(path_) != file_ || rows->size() != count) {
      throw RowsFailure{{ResultsErrorKind::busy,
                         joined({path_.string(), " was replaced while it was read: a study writes it; try again"}),
                         {}}};
    }
    auto owner = std::make_shared<const std::vector<ScenarioRow>>(*std::move(rows));
    return {*owner, owner};
  }

  const fs::path path_;
  const FileIdentity file_;
  const std::size_t count_;
};

/// A running study may replace the file between the reading of hash and file, so a mismatch is looked at again.
constexpr int kLooksAtTheHash = 5;

}  // namespace

Expected<ResultsSummary> read_suspect_summary(const fs::path& path) {
  const FileIdentity file = identity_of(path);
  auto summary = read_in_child<ResultsSummary>(path, [&] { return read_results_summary(path, kRowsOfAChild); });
  if (summary && summary->rows.size() < summary->row_count()) {
    summary->rows = std::make_shared<const SuspectRows>(path, file, summary->row_count());
  }
  return summary;
}

namespace {

/// Nothing where it cannot be read.
std::optional<std::string> hash_of_file(const fs::path& path) {
  Sha256 hash;
  if (read_in_pieces(path, [&hash](std::string_view bytes) { hash.add(bytes); })) return std::nullopt;
  return hash.hex();
}

}  // namespace

MaybeError check_file_hash(const fs::path& path) {
  for (int look = 1; look <= kLooksAtTheHash; ++look) {
    const auto before = read_text_file(hash_path(path));
    const auto hash = before ? hash_of_file(path) : std::nullopt;
    if (!before || !hash) return {};  // no hash, or nothing to read: what reads the file says so
    if (*before == hash_line(*hash)) return {};
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

Expected<Trace> read_suspect_trace(const fs::path& path) {
  return read_in_child<Trace>(path, [&] { return read_trace(path); });
}

}  // namespace unbruised::studies
