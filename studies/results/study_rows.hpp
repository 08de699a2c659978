#pragma once

/// @file
/// The rows of a study, in the order of their ids, wherever they stand: in memory, in the journals, or in a
/// results file. Of millions only a block is in memory at a time.

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "studies/results/expected.hpp"
#include "studies/results/scenario_row.hpp"

namespace unbruised::studies {

struct RowSummary;

/// Carries a failure of the disk out of whatever goes through rows.
struct RowsFailure : std::runtime_error {
  explicit RowsFailure(ResultsError what) : std::runtime_error(what.message), error(std::move(what)) {}
  ResultsError error;
};

/// Rows that are read at a time: a multiple of the rows of a chunk in results.h5, ten megabytes.
inline constexpr std::size_t kRowsAtATime = 16384;

/// Rows beside each other, and who keeps them alive.
struct RowBlock {
  std::span<const ScenarioRow> rows;
  std::shared_ptr<const std::vector<ScenarioRow>> owner{};
};

/// Where rows come from. What it gives never changes; safe to use from several threads at once.
class RowSource {
 public:
  RowSource() = default;
  RowSource(const RowSource&) = delete;
  RowSource& operator=(const RowSource&) = delete;
  virtual ~RowSource() = default;
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// Rows from `first` < size() on: at least one, as many as are read at a time. Throws RowsFailure.
  [[nodiscard]] virtual RowBlock block(std::size_t first) const = 0;
  /// The row at `place` < size(). Throws RowsFailure.
  [[nodiscard]] virtual ScenarioRow row(std::size_t place) const { return block(place).rows.front(); }
  /// By input: is one of its values a text? Throws RowsFailure.
  [[nodiscard]] virtual std::vector<bool> text_inputs() const;
};

/// Marks the inputs of a row that are texts.
void note_text_inputs(const ScenarioRow& row, std::vector<bool>& is_text);

/// A study's rows to go through, as often as is needed; copies share them. A row that was seen is valid until the
/// iterator moves. Reading throws RowsFailure.
class StudyRows {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = ScenarioRow;
    using difference_type = std::ptrdiff_t;
    using pointer = const ScenarioRow*;
    using reference = const ScenarioRow&;
    Iterator() = default;
    reference operator*() const { return block_.rows[place_ - first_]; }
    pointer operator->() const { return &**this; }
    Iterator& operator++() {
      ++place_;
      if (place_ - first_ == block_.rows.size()) load();
      return *this;
    }
    void operator++(int) { ++*this; }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.place_ == b.place_; }

   private:
    friend class StudyRows;
    Iterator(const RowSource* source, std::size_t place) : source_(source), place_(place) { load(); }
    void load();
    const RowSource* source_ = nullptr;
    std::size_t place_ = 0;
    std::size_t first_ = 0;
    RowBlock block_;
  };

  StudyRows() = default;
  StudyRows(std::vector<ScenarioRow> rows);  // NOLINT(google-explicit-constructor)
  template <class Source>
  requires std::derived_from<Source, RowSource> StudyRows(
      std::shared_ptr<const Source> source)  // NOLINT(google-explicit-constructor)
      : StudyRows(std::shared_ptr<const RowSource>(std::move(source)), nullptr) {}
  StudyRows(std::initializer_list<ScenarioRow> rows) : StudyRows(std::vector<ScenarioRow>(rows)) {}

  [[nodiscard]] std::size_t size() const { return source_ ? source_->size() : 0; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] Iterator begin() const { return from(0); }
  [[nodiscard]] Iterator end() const;
  /// From the row at `place` on.
  [[nodiscard]] Iterator from(std::size_t place) const { return {source_.get(), place}; }
  /// As RowSource::block.
  [[nodiscard]] RowBlock block(std::size_t first) const { return source_->block(first); }
  /// The row at `place` < size().
  [[nodiscard]] ScenarioRow at(std::size_t place) const { return source_->row(place); }
  [[nodiscard]] ScenarioRow operator[](std::size_t place) const { return at(place); }
  [[nodiscard]] ScenarioRow front() const { return at(0); }
  [[nodiscard]] std::vector<bool> text_inputs() const;
  /// All of them in memory, for studies that can hold theirs.
  [[nodiscard]] std::vector<ScenarioRow> held() const;
  /// What they say together; found out in one pass, once.
  [[nodiscard]] const RowSummary& seen() const;

 private:
  struct Seen;
  StudyRows(std::shared_ptr<const RowSource> source, std::nullptr_t);
  std::shared_ptr<const RowSource> source_;
  std::shared_ptr<Seen> seen_;
};

}  // namespace unbruised::studies
