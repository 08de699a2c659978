#pragma once

/// @file
/// Where each scenario of a study stands in the journals: sixteen bytes a row, so that millions need not be in
/// memory to be put into order.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "studies/results/expected.hpp"
#include "studies/results/journal.hpp"
#include "studies/results/study_rows.hpp"

namespace unbruised::studies {

/// What one journal is, beside its rows.
struct JournalFindings {
  std::filesystem::path path;
  JournalState state;
  std::size_t records = 0;               ///< of this config
  std::size_t rows = 0;                  ///< of these, scenarios
  std::vector<std::string> builds;       ///< each once, in the order of the file
  std::vector<std::string> misshapen{};  ///< why records that are whole are no rows: "scenario 7: ..."
};

/// A scenario that stands in the journals with another result than its first one.
struct TwoResults {
  std::uint64_t id = 0;
  std::filesystem::path path;  ///< of the later one
};

class JournalIndex {
 public:
  /// Reads a journal through, and knows its rows from then on; of equal ids the first counts. Errors: io.
  Expected<JournalFindings> add(const std::filesystem::path& path, std::uint64_t config_prefix);
  /// Puts what was added into order. Errors: io, damaged (a journal changed meanwhile).
  Expected<std::vector<TwoResults>> settle();
  /// A row that this process has just written at `offset` of a journal. Its id is new.
  void add_row(const ScenarioRow& row, const std::filesystem::path& path, std::uint64_t offset);

  [[nodiscard]] bool contains(std::uint64_t id) const;
  [[nodiscard]] std::size_t size() const { return settled_->size() + recent_.size(); }
  /// The rows known now, by their ids; as places numbered 0, 1, ... where they have some.
  [[nodiscard]] StudyRows rows(RowPlaces places = RowPlaces::none);
  /// These and what `others` has beside, by their ids.
  [[nodiscard]] StudyRows rows_and(StudyRows others);

  struct Entry {
    std::uint64_t id = 0;
    std::uint64_t place = 0;  ///< number of the journal, offset in it
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

 private:
  [[nodiscard]] std::uint64_t file_number(const std::filesystem::path& path);
  void settle_recent();

  using Files = std::vector<std::filesystem::path>;
  std::shared_ptr<const Files> files_ = std::make_shared<const Files>();
  std::shared_ptr<const std::vector<Entry>> settled_ = std::make_shared<const std::vector<Entry>>();
  std::vector<Entry> added_;                                 ///< not in order yet
  std::unordered_map<std::uint64_t, std::uint64_t> recent_;  ///< place by id
  std::vector<bool> text_inputs_;
};

}  // namespace unbruised::studies
