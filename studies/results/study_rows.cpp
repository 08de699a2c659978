#include "studies/results/study_rows.hpp"

#include <mutex>

#include "studies/results/row_summary.hpp"

namespace unbruised::studies {
namespace {

class RowsInMemory : public RowSource {
 public:
  explicit RowsInMemory(std::vector<ScenarioRow> rows) : rows_(std::move(rows)) {}
  [[nodiscard]] std::size_t size() const override { return rows_.size(); }
  [[nodiscard]] RowBlock block(std::size_t first) const override { return {std::span(rows_).subspan(first)}; }

 private:
  const std::vector<ScenarioRow> rows_;
};

}  // namespace

std::vector<bool> RowSource::text_inputs() const {
  std::vector<bool> is_text;
  for (std::size_t at = 0; at < size();) {
    const RowBlock next = block(at);
    for (const ScenarioRow& row : next.rows) note_text_inputs(row, is_text);
    at += next.rows.size();
  }
  return is_text;
}

void note_text_inputs(const ScenarioRow& row, std::vector<bool>& is_text) {
  if (is_text.size() < row.inputs.size()) is_text.resize(row.inputs.size());
  for (std::size_t i = 0; i < row.inputs.size(); ++i) {
    if (std::holds_alternative<std::string>(row.inputs[i])) is_text[i] = true;
  }
}

struct StudyRows::Seen {
  std::once_flag once;
  RowSummary summary;
};

StudyRows::StudyRows(std::vector<ScenarioRow> rows)
    : StudyRows(std::make_shared<const RowsInMemory>(std::move(rows))) {}

StudyRows::StudyRows(std::shared_ptr<const RowSource> source, std::nullptr_t)
    : source_(std::move(source)), seen_(std::make_shared<Seen>()) {}

void StudyRows::Iterator::load() {
  first_ = place_;
  block_ = source_ != nullptr && place_ < source_->size() ? source_->block(place_) : RowBlock{};
}

StudyRows::Iterator StudyRows::end() const {
  Iterator end;
  end.place_ = size();
  return end;
}

std::vector<bool> StudyRows::text_inputs() const { return source_ ? source_->text_inputs() : std::vector<bool>{}; }

std::vector<ScenarioRow> StudyRows::held() const {
  std::vector<ScenarioRow> rows;
  rows.reserve(size());
  for (const ScenarioRow& row : *this) rows.push_back(row);
  return rows;
}

const RowSummary& StudyRows::seen() const {
  static const RowSummary kNone = summary_of({});
  if (!source_) return kNone;
  std::call_once(seen_->once, [this] { seen_->summary = summary_of(*this); });
  return seen_->summary;
}

}  // namespace unbruised::studies
