#include "studies/results/run_directory.hpp"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "studies/config/study.hpp"
#include "studies/results/checksum.hpp"
#include "studies/results/digest.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/results_file.hpp"
#include "studies/results/run_layout.hpp"
#include "studies/results/suspect_results.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

namespace {

ResultsError error_of(ResultsErrorKind kind, std::initializer_list<std::string_view> parts) {
  return {kind, joined(parts), {}};
}

MaybeError make_directory(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) return system_error("create", directory, error.value());
  return {};
}

MaybeError remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  return error ? MaybeError{system_error("remove", file, error.value())} : MaybeError{};
}

/// Answers of a study as files.
constexpr std::string_view kStrategyFile = "strategy.toml";
constexpr std::string_view kProductFile = "calibrated.toml";

// Entries that make a directory more than an empty one; a single-scenario file or a log may stand there.
bool is_own_extra(const std::string& name) {
  return name == "lock" || name == "log.txt" || name.starts_with("config.toml.") || name == "report.html" ||
         name == "report.html.tmp" || name == kStrategyFile || name == std::string(kStrategyFile) + ".tmp" ||
         name == kProductFile || name == std::string(kProductFile) + ".tmp" ||
         (name.starts_with("scenario_") && (name.ends_with(".h5") || name.ends_with(".html") ||
                                            name.ends_with(".html.tmp") || name.ends_with(".csv")));
}

bool holds_anything(const fs::path& directory) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    if (entry.path().filename() != "lock") return true;
  }
  return false;
}

std::string first_foreign_entry(const fs::path& directory) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    if (!is_own_extra(name)) return name;
  }
  return {};
}

std::string list_of(const std::vector<std::string>& keys) {
  constexpr std::size_t kShown = 12;
  if (keys.size() <= kShown) return comma_list(keys);
  const std::vector<std::string> shown(keys.begin(), keys.begin() + kShown);
  return joined({comma_list(shown), ", and ", std::to_string(keys.size() - kShown), " more"});
}

}  // namespace

Expected<std::unique_ptr<RunDirectory>> RunDirectory::open(const Request& request) {
  std::unique_ptr<RunDirectory> run(new RunDirectory());
  if (auto error = run->prepare(request)) return *error;
  return run;
}

Expected<std::unique_ptr<RunDirectory>> RunDirectory::open_for_compaction(const fs::path& directory) {
  auto config = read_text_file(directory / "config.toml");
  if (!config) return config.error();
  std::unique_ptr<RunDirectory> run(new RunDirectory());
  run->directory_ = directory;
  run->config_toml_ = std::move(*config);
  run->config_sha256_ = sha256_hex(run->config_toml_);
  if (auto error = run->take_lock(LockPurpose::compaction)) return *error;
  if (auto error = run->recover_journals()) return *error;
  return run;
}

RunDirectory::~RunDirectory() = default;

MaybeError RunDirectory::prepare(const Request& request) {
  directory_ = request.directory;
  config_toml_ = request.config_toml;
  config_sha256_ = sha256_hex(config_toml_);
  build_ = request.build;
  if (auto error = make_directory(directory_)) return error;
  part_ = request.part;
  if (auto error = take_lock(part_ ? LockPurpose::part : LockPurpose::run)) return error;
  if (request.fresh && holds_anything(directory_)) {
    if (auto error = move_aside()) return error;
  }
  std::error_code ignored;
  if (fs::exists(directory_ / "config.toml", ignored)) return continue_old();
  return part_ ? begin_part() : begin_new();
}

MaybeError RunDirectory::take_lock(LockPurpose purpose) {
  auto taken = RunLock::take(directory_, purpose);
  if (!taken) return taken.error();
  lock_ = std::move(*taken);
  if (!lock_.excludes_others()) {
    notes_.push_back(joined({"the file system of ", directory_.string(),
                             " has no locks: make sure that no other process uses this directory"}));
  }
  return {};
}

MaybeError RunDirectory::move_aside() {
  std::error_code error;
  // Behind a link it is the directory that moves: the new one belongs on the same disk, and the link stays right.
  const fs::path real = fs::is_symlink(directory_, error) ? fs::canonical(directory_, error) : directory_;
  std::string name = real.lexically_normal().string();
  while (name.size() > 1 && name.back() == '/') name.pop_back();
  int number = 1;
  while (fs::exists(joined({name, ".old-", std::to_string(number)}), error)) ++number;
  const std::string aside = joined({name, ".old-", std::to_string(number)});
  fs::rename(name, aside, error);
  if (error) return system_error("move aside", directory_, error.value());
  notes_.push_back(joined({"moved ", name, " aside to ", aside}));
  if (auto failure = make_directory(name)) return failure;
  return take_lock(LockPurpose::run);
}

MaybeError RunDirectory::begin_new() {
  const std::string other = first_foreign_entry(directory_);
  if (!other.empty()) {
    return error_of(ResultsErrorKind::foreign, {directory_.string(), " holds ", other,
                                                " but no config.toml: it is not a run directory; choose another "
                                                "one, or move it aside with --fresh"});
  }
  if (auto error = write_text_file(directory_ / "config.toml", config_toml_)) return error;
  if (auto error = make_directory(directory_ / "journal")) return error;
  return sync_directory(directory_);
}

/// Others may begin at the same time: whoever comes last puts the same config over the others', or finds another
/// one.
MaybeError RunDirectory::begin_part() {
  const std::string other = first_foreign_entry(directory_);
  std::error_code error;
  if (!other.empty() && !fs::exists(directory_ / "config.toml", error)) return begin_new();  // which says so
  const fs::path own = directory_ / joined({"config.toml.", host_name(), "-", std::to_string(::getpid())});
  if (auto failure = write_text_file(own, config_toml_)) return failure;
  if (fs::exists(directory_ / "config.toml", error)) {
    fs::remove(own, error);
  } else if (fs::rename(own, directory_ / "config.toml", error); error) {
    return system_error("create", directory_ / "config.toml", error.value());
  }
  if (auto failure = make_directory(directory_ / "journal")) return failure;
  if (auto failure = sync_directory(directory_)) return failure;
  return continue_old();
}

MaybeError RunDirectory::continue_old() {
  if (auto error = take_old_config()) return error;
  if (auto error = refuse_finished()) return error;
  if (auto error = make_directory(directory_ / "journal")) return error;
  if (auto error = recover_journals()) return error;
  if (auto error = refuse_other_build()) return error;
  continued_ = true;
  return {};
}

MaybeError RunDirectory::take_old_config() {
  auto old_config = read_text_file(directory_ / "config.toml");
  if (!old_config) return old_config.error();
  if (*old_config == config_toml_) return {};
  ResultsError error = error_of(ResultsErrorKind::other_config, {});
  error.keys = differing_keys(*old_config, config_toml_);
  if (error.keys == std::vector<std::string>{"study.description"}) {
    notes_.push_back(
        "only study.description has changed, which moves no number: the run goes on with the old one");
    config_toml_ = std::move(*old_config);
    config_sha256_ = sha256_hex(config_toml_);
    return {};
  }
  const std::string what = error.keys.empty() ? std::string("its text differs, though no key does")
                                              : joined({"these keys differ: ", list_of(error.keys)});
  error.message = joined({directory_.string(), " holds a study of another config: ", what,
                          ". Choose another --output, or --fresh to move the old one aside"});
  return error;
}

MaybeError RunDirectory::refuse_finished() {
  std::error_code ignored;
  if (!fs::exists(results_path(), ignored)) return {};
  const auto summary = read_hashed_summary(results_path());
  if (!summary) {
    notes_.push_back(joined({summary.error().message, "; it will be written anew from the journal"}));
    return {};
  }
  if (!summary->meta.complete) return {};
  return error_of(ResultsErrorKind::finished,
                  {directory_.string(), " holds this study, finished (digest ", summary->digest(),
                   "). Use --fresh to move it aside and run again"});
}

// The promise of equal bits holds for one build; a study of two would look like one of neither.
MaybeError RunDirectory::refuse_other_build() const {
  if (other_build_.empty()) return {};
  return error_of(ResultsErrorKind::other_build,
                  {directory_.string(), " was begun by another build (", other_build_, "); this one (", build_,
                   ") may differ from it in the last bits. Continue with that build, or --fresh to move the old "
                   "results aside and start anew"});
}

MaybeError RunDirectory::recover_journals() {
  const auto files = journal_files(directory_);
  for (const fs::path& file : files) {
    // What a killed process wrote may stand in the page cache alone; results.h5 must not outlive it.
    if (auto error = sync_file(file)) return error;
    const auto findings = index_.add(file, config_hash_prefix(config_sha256_));
    if (!findings) return findings.error();
    note_findings(*findings);
  }
  const auto twice = index_.settle();
  if (!twice) return twice.error();
  for (const TwoResults& other : *twice) {
    notes_.push_back(joined({other.path.string(), ": scenario ", std::to_string(other.id),
                             " stands in the journals with two different results; the first is kept"}));
  }
  recovered_count_ = index_.size();
  if (part_ && files.empty()) return {};
  notes_.push_back(joined({"continuing ", directory_.string(), ": ", std::to_string(recovered_count_),
                           " scenarios found in ", std::to_string(files.size()), " journal file(s)"}));
  return {};
}

void RunDirectory::note_findings(const JournalFindings& findings) {
  const std::string path = findings.path.string();
  for (const std::string& build : findings.builds) {
    if (build != build_) other_build_ = build;
  }
  for (const std::string& row : findings.misshapen) notes_.push_back(joined({path, ", ", row}));
  for (const JournalDamage& damage : findings.state.damage) {
    notes_.push_back(joined({path, " is damaged: ", std::to_string(damage.bytes), " bytes at offset ",
                             std::to_string(damage.offset), "; what stood there is run again"}));
  }
  if (findings.state.torn_tail_bytes > 0 && !part_) {  // another one may just be writing it
    notes_.push_back(joined({path, " ends in ", std::to_string(findings.state.torn_tail_bytes),
                             " bytes of an unfinished record; that one is run again"}));
  }
  if (findings.state.other_config_records > 0) {
    notes_.push_back(joined({path, " holds ", std::to_string(findings.state.other_config_records),
                             " records of another config; they are ignored"}));
  }
}

bool RunDirectory::is_done(std::uint64_t id) const {
  const std::lock_guard lock(mutex_);
  return index_.contains(id);
}

StudyRows RunDirectory::rows(RowPlaces places) const {
  const std::lock_guard lock(mutex_);
  return index_.rows(places);
}

std::size_t RunDirectory::row_count() const {
  const std::lock_guard lock(mutex_);
  return index_.size();
}

StudyRows RunDirectory::rows_and(StudyRows others, RowPlaces places) const {
  const std::lock_guard lock(mutex_);
  return places == RowPlaces::none ? index_.rows_and(std::move(others)) : index_.rows(places);
}

// The journal of this process, begun with its session record at the first use.
Expected<JournalWriter*> RunDirectory::journal() {
  const std::lock_guard lock(mutex_);
  if (journal_) return journal_.get();
  auto created = JournalWriter::create(directory_ / "journal", config_hash_prefix(config_sha256_));
  if (!created) return created.error();
  if (auto error = (*created)->append({RecordKind::session, 0, 0, build_})) return *error;
  journal_ = std::move(*created);
  return journal_.get();
}

MaybeError RunDirectory::append(const ScenarioRow& row) {
  if (is_done(row.id)) {
    return error_of(ResultsErrorKind::io, {"scenario ", std::to_string(row.id), " stands in the journal of ",
                                           directory_.string(), " already"});
  }
  auto writer = journal();
  if (!writer) return writer.error();
  std::uint64_t offset = 0;
  if (auto error = (*writer)->append({RecordKind::scenario, row.id, 0, encode_scenario_row(row)}, &offset)) {
    return error;
  }
  const std::lock_guard lock(mutex_);
  index_.add_row(row, (*writer)->path(), offset);
  return {};
}

MaybeError RunDirectory::commit() {
  JournalWriter* writer = nullptr;
  {
    const std::lock_guard lock(mutex_);
    writer = journal_.get();
  }
  return writer == nullptr ? MaybeError{} : writer->commit();
}

std::uint64_t RunDirectory::acknowledged() const {
  const std::lock_guard lock(mutex_);
  const std::uint64_t written = journal_ ? journal_->acknowledged() : 0;
  return recovered_count_ + (written > 0 ? written - 1 : 0);  // the first record is the session
}

void RunDirectory::log(std::string_view line) {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  char stamp[32] = "";
  std::strftime(stamp, sizeof stamp, "%Y-%m-%dT%H:%M:%SZ ", &utc);
  const std::string text = joined({stamp, line, "\n"});
  const int descriptor = ::open((directory_ / "log.txt").c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor < 0) return;
  [[maybe_unused]] const ssize_t written = ::write(descriptor, text.data(), text.size());
  ::close(descriptor);
}

MaybeError RunDirectory::finish(ResultsContent content) {
  StudyRows others =
      content.stored.empty() ? StudyRows(by_id(std::move(content.rows))) : std::move(content.stored);
  content.rows.clear();
  content.stored = rows_and(std::move(others), content.places);
  if (auto error = commit())
    return error;  // after the rows were taken: results.h5 knows nothing that may get lost
  content.meta.config_toml = config_toml_;
  content.meta.config_sha256 = config_sha256_;
  const std::lock_guard one_at_a_time(results_mutex_);
  return write_hashed_results(results_path(), content);
}

MaybeError RunDirectory::write_strategy(std::string_view toml) {
  return write_text_file(directory_ / kStrategyFile, toml);
}

MaybeError RunDirectory::remove_strategy() { return remove_file(directory_ / kStrategyFile); }

MaybeError RunDirectory::write_product(std::string_view toml) {
  return write_text_file(directory_ / kProductFile, toml);
}

MaybeError RunDirectory::remove_product() { return remove_file(directory_ / kProductFile); }

}  // namespace unbruised::studies
