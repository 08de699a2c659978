#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "studies/results/checksum.hpp"
#include "studies/results/digest.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/journal_index.hpp"
#include "studies/results/results_file.hpp"
#include "studies/results/row_summary.hpp"
#include "studies/results/run_directory.hpp"
#include "studies/results/run_layout.hpp"
#include "studies/results/suspect_results.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

namespace {

/// Gathers what `verify` finds, check by check.
class Verifier {
 public:
  explicit Verifier(fs::path directory) : directory_(std::move(directory)) {}

  Expected<VerifyReport> run() {
    const auto config = read_text_file(directory_ / "config.toml");
    if (!config) {
      return ResultsError{
          ResultsErrorKind::foreign, joined({directory_.string(), " is not a run directory: no config.toml"}), {}};
    }
    config_sha256_ = sha256_hex(*config);
    // First the results: a study that runs meanwhile puts a row into the journal before it is in results.h5.
    const fs::path results = directory_ / "results.h5";
    std::error_code ignored;
    const bool has_results = fs::exists(results, ignored);
    const auto summary = has_results ? read_results(results) : std::nullopt;
    for (const fs::path& file : journal_files(directory_)) check_journal(file);
    check_twice();
    report_.journal_rows = index_.size();
    try {
      if (summary) {
        check_results(*summary);
      } else if (!has_results) {
        report_.notes.push_back("there is no results.h5 yet: the study is not finished");
        report_.digest = index_.rows().seen().digest;
      }
    } catch (const RowsFailure& failure) {
      report_.damage.push_back(failure.error.message);
    }
    return report_;
  }

 private:
  void check_journal(const fs::path& file) {
    const auto findings = index_.add(file, config_hash_prefix(config_sha256_));
    if (!findings) {
      report_.damage.push_back(findings.error().message);
      return;
    }
    for (const JournalDamage& damage : findings->state.damage) {
      report_.damage.push_back(joined({file.string(), ": ", std::to_string(damage.bytes), " bytes at offset ",
                                       std::to_string(damage.offset), " fail their checksum"}));
    }
    if (findings->state.other_config_records > 0) {
      report_.damage.push_back(joined({file.string(), ": ", std::to_string(findings->state.other_config_records),
                                       " records belong to another config than config.toml"}));
    }
    report_.notes.push_back(joined({file.string(), ": ", std::to_string(findings->records), " records, ",
                                    std::to_string(findings->state.torn_tail_bytes), " bytes of torn tail"}));
    for (const std::string& row : findings->misshapen)
      report_.damage.push_back(joined({file.string(), ": ", row}));
  }

  void check_twice() {
    const auto twice = index_.settle();
    if (!twice) {
      report_.damage.push_back(twice.error().message);
      return;
    }
    for (const TwoResults& other : *twice) {
      report_.damage.push_back(
          joined({"scenario ", std::to_string(other.id), " has two different results in the journals"}));
    }
  }

  std::optional<ResultsSummary> read_results(const fs::path& results) {
    std::error_code ignored;
    if (!fs::exists(hash_path(results), ignored)) {
      report_.notes.push_back("results.h5.sha256 is missing: the file's own hash was not checked");
    }
    if (const auto mismatch = check_file_hash(results)) report_.damage.push_back(mismatch->message);
    auto summary = read_suspect_summary(results);
    if (summary) return std::move(*summary);
    report_.damage.push_back(summary.error().message);
    return std::nullopt;
  }

  void check_results(const ResultsSummary& summary) {
    report_.results_rows = summary.rows.size();
    report_.digest = summary.digest();
    if (summary.meta.config_sha256 != config_sha256_) {
      report_.damage.push_back("results.h5 was written from another config than config.toml");
    }
    if (sha256_hex(summary.meta.config_toml) != summary.meta.config_sha256) {
      report_.damage.push_back("the config in results.h5 does not match its config_sha256");
    }
    compare_rows(summary);
  }

  /// Both go by the ids of the journal.
  void compare_rows(const ResultsSummary& summary) {
    const StudyRows truth = index_.rows();
    StudyRows::Iterator recorded = truth.begin();
    std::size_t agreeing = 0;
    std::size_t place = 0;
    for (const ScenarioRow& row : summary.rows) {
      if (result_digest(row.result) != summary.digests[place++]) {
        report_.damage.push_back(
            joined({"results.h5, scenario ", std::to_string(row.id), ": the metrics do not match their digest"}));
      }
      while (recorded != truth.end() && recorded->id < journal_id(row)) ++recorded;
      const bool is_recorded = recorded != truth.end() && recorded->id == journal_id(row);
      const ScenarioRow* known = is_recorded ? &*recorded : nullptr;
      if (row.result.outcome != Outcome::not_run && agrees(row, known)) ++agreeing;
    }
    const std::size_t missing = truth.size() - std::min(agreeing, truth.size());
    if (missing > 0) {
      // An interrupted study that was continued since: its results.h5 is older than the journals.
      auto& list = summary.meta.complete ? report_.damage : report_.notes;
      list.push_back(joined({std::to_string(missing), " rows of the journals are not in results.h5"}));
    }
    report_.notes.push_back(
        joined({"results.h5: ", std::to_string(agreeing), " rows equal those of the journals"}));
  }

  /// @param known the row of the journals; null: there is none
  bool agrees(const ScenarioRow& row, const ScenarioRow* known) {
    const bool agrees = known != nullptr && same_row(*known, row);
    if (!agrees) {
      report_.damage.push_back(joined({"results.h5, scenario ", std::to_string(row.id),
                                       known == nullptr ? " stands in no journal" : " differs from the journal"}));
    }
    return agrees;
  }

  fs::path directory_;
  std::string config_sha256_;
  VerifyReport report_;
  JournalIndex index_;
};

}  // namespace

Expected<VerifyReport> verify_run_directory(const fs::path& directory) { return Verifier(directory).run(); }

}  // namespace unbruised::studies
