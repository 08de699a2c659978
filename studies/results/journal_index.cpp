#include "studies/results/journal_index.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>

#include "studies/results/run_layout.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

namespace {

using Entry = JournalIndex::Entry;
using Entries = std::vector<Entry>;
using Files = std::vector<fs::path>;

/// Of a place: the journal above, the offset in it (a tebibyte at most) below.
constexpr unsigned kOffsetBits = 40;
constexpr std::uint64_t kOffsetMask = (std::uint64_t{1} << kOffsetBits) - 1;
/// Rows of this process that are put into order together.
constexpr std::size_t kRecentMost = 65536;

constexpr std::uint64_t place_of(std::uint64_t file, std::uint64_t offset) { return file << kOffsetBits | offset; }

/// Reads rows in the order of the journals, each journal with few long reads.
class RowsByPlace {
 public:
  explicit RowsByPlace(const Files& files) : files_(files) {}

  /// Rows of some entries, in their order. Throws RowsFailure.
  std::vector<ScenarioRow> read(std::span<const Entry> entries) {
    std::vector<std::uint32_t> order(entries.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return entries[i].place; });
    std::vector<ScenarioRow> rows(entries.size());
    std::uint64_t read_to = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::uint64_t place = entries[order[k]].place;
      if (place >= read_to) read_to = end_of_stretch(entries, order, k);
      rows[order[k]] = read_one(entries[order[k]], read_to - place);
    }
    return rows;
  }

 private:
  static constexpr std::uint64_t kNoFile = ~std::uint64_t{0};
  /// Rows that stand closer than this are read together, up to so many bytes.
  static constexpr std::uint64_t kGapMost = 8192;
  static constexpr std::uint64_t kStretchMost = std::uint64_t{1} << 20;

  static std::uint64_t end_of_stretch(std::span<const Entry> entries, const std::vector<std::uint32_t>& order,
                                      std::size_t from) {
    const std::uint64_t begin = entries[order[from]].place;
    std::uint64_t last = begin;
    for (std::size_t k = from + 1; k < order.size(); ++k) {
      const std::uint64_t next = entries[order[k]].place;
      if (next - last > kGapMost || next - begin > kStretchMost) break;
      last = next;
    }
    return last + kGapMost;
  }

  ScenarioRow read_one(const Entry& entry, std::uint64_t ahead) {
    const std::uint64_t file = entry.place >> kOffsetBits;
    if (file != file_) reader_.emplace(files_[file]);
    file_ = file;
    auto row = reader_->read(entry.id, entry.place & kOffsetMask, ahead);
    if (!row) throw RowsFailure{row.error()};
    return *std::move(row);
  }

  const Files& files_;
  std::uint64_t file_ = kNoFile;
  std::optional<JournalRowReader> reader_;
};

/// The rows of an index at one moment.
class JournalRows : public RowSource {
 public:
  JournalRows(std::shared_ptr<const Files> files, std::shared_ptr<const Entries> entries,
              std::vector<bool> text_inputs, RowPlaces places)
      : files_(std::move(files)),
        entries_(std::move(entries)),
        text_inputs_(std::move(text_inputs)),
        places_(places) {}

  [[nodiscard]] std::size_t size() const override { return entries_->size(); }
  [[nodiscard]] RowBlock block(std::size_t first) const override { return read(first, kRowsAtATime); }
  [[nodiscard]] ScenarioRow row(std::size_t place) const override { return read(place, 1).rows.front(); }
  [[nodiscard]] std::vector<bool> text_inputs() const override { return text_inputs_; }

 private:
  [[nodiscard]] RowBlock read(std::size_t first, std::size_t most) const {
    const std::size_t count = std::min(most, entries_->size() - first);
    std::vector<ScenarioRow> rows = RowsByPlace(*files_).read(std::span(*entries_).subspan(first, count));
    if (places_ != RowPlaces::none) {
      for (std::size_t i = 0; i < count; ++i) number_placed_row(rows[i], first + i);
    }
    auto owner = std::make_shared<const std::vector<ScenarioRow>>(std::move(rows));
    return {*owner, owner};
  }

  const std::shared_ptr<const Files> files_;
  const std::shared_ptr<const Entries> entries_;
  const std::vector<bool> text_inputs_;
  const RowPlaces places_;
};

/// Rows of an index, and between them others with ids that it does not have.
class MergedRows : public RowSource {
 public:
  MergedRows(StudyRows known, std::shared_ptr<const Entries> entries, StudyRows others)
      : known_(std::move(known)), entries_(std::move(entries)), others_(std::move(others)) {
    auto at = entries_->begin();
    std::size_t place = 0;
    for (const ScenarioRow& row : others_) {
      at = std::lower_bound(at, entries_->end(), Entry{row.id, 0});
      if (at == entries_->end() || at->id != row.id) between_.push_back({row.id, place});
      ++place;
    }
  }

  [[nodiscard]] std::size_t size() const override { return entries_->size() + between_.size(); }

  [[nodiscard]] RowBlock block(std::size_t first) const override {
    std::size_t known = known_among(first);
    std::size_t other = first - known;
    StudyRows::Iterator next = known_.from(known);
    auto rows = std::make_shared<std::vector<ScenarioRow>>();
    while (rows->size() < kRowsAtATime && first + rows->size() < size()) {
      if (is_known(known, other)) {
        rows->push_back(*next);
        ++next;
        ++known;
      } else {
        rows->push_back(others_.at(between_[other++].place));
      }
    }
    return {*rows, rows};
  }

  [[nodiscard]] ScenarioRow row(std::size_t place) const override {
    const std::size_t known = known_among(place);
    const std::size_t other = place - known;
    return is_known(known, other) ? known_.at(known) : others_.at(between_[other].place);
  }

  [[nodiscard]] std::vector<bool> text_inputs() const override {
    std::vector<bool> is_text = known_.text_inputs();
    if (!between_.empty()) note_text_inputs(others_.at(between_.front().place), is_text);
    return is_text;
  }

 private:
  struct Other {
    std::uint64_t id = 0;
    std::size_t place = 0;  ///< in others_
  };

  /// Does a known row come next, behind so many of each?
  [[nodiscard]] bool is_known(std::size_t known, std::size_t other) const {
    return other == between_.size() || (known < entries_->size() && (*entries_)[known].id < between_[other].id);
  }

  /// How many of the first `count` rows are known ones.
  [[nodiscard]] std::size_t known_among(std::size_t count) const {
    std::size_t least = count > between_.size() ? count - between_.size() : 0;
    std::size_t most = std::min(count, entries_->size());
    while (least < most) {  // the first known row that is not among them
      const std::size_t middle = least + (most - least) / 2;
      const std::uint64_t id = (*entries_)[middle].id;
      const auto before =
          static_cast<std::size_t>(std::ranges::lower_bound(between_, id, {}, &Other::id) - between_.begin());
      if (middle + before < count) {
        least = middle + 1;
      } else {
        most = middle;
      }
    }
    return least;
  }

  const StudyRows known_;
  const std::shared_ptr<const Entries> entries_;
  const StudyRows others_;
  std::vector<Other> between_;
};

}  // namespace

std::uint64_t JournalIndex::file_number(const fs::path& path) {
  for (std::size_t number = files_->size(); number-- > 0;) {  // that of this process is the last one
    if ((*files_)[number] == path) return number;
  }
  auto more = std::make_shared<Files>(*files_);
  more->push_back(path);
  files_ = std::move(more);
  return files_->size() - 1;
}

Expected<JournalFindings> JournalIndex::add(const fs::path& path, std::uint64_t config_prefix) {
  JournalFindings findings{.path = path, .state = {}, .builds = {}};
  const std::uint64_t file = file_number(path);
  auto state = walk_journal(path, config_prefix, [&](const SeenRecord& record) {
    ++findings.records;
    if (record.kind == RecordKind::session) {
      const std::string build(record.payload);
      if (std::ranges::find(findings.builds, build) == findings.builds.end()) findings.builds.push_back(build);
    }
    if (record.kind != RecordKind::scenario) return;
    const auto row = decode_scenario_row(record.id, record.payload);
    if (!row) {
      findings.misshapen.push_back(joined({"scenario ", std::to_string(record.id), ": ", row.error().message}));
      return;
    }
    ++findings.rows;
    note_text_inputs(*row, text_inputs_);
    added_.push_back({record.id, place_of(file, record.offset)});
  });
  if (!state) return state.error();
  findings.state = *std::move(state);
  return findings;
}

Expected<std::vector<TwoResults>> JournalIndex::settle() {
  settle_recent();
  added_.insert(added_.end(), settled_->begin(), settled_->end());
  settled_ = std::make_shared<const Entries>();
  std::ranges::sort(added_);
  std::vector<TwoResults> differing;
  try {
    RowsByPlace reader(*files_);
    const auto is_twice = [](const Entry& a, const Entry& b) { return a.id == b.id; };
    std::optional<ScenarioRow> first;
    for (auto at = std::ranges::adjacent_find(added_, is_twice); at != added_.end();
         at = std::adjacent_find(std::next(at), added_.end(), is_twice)) {
      if (!first || first->id != at->id) first = reader.read({&*at, 1}).front();
      const Entry& second = *std::next(at);
      if (same_row(*first, reader.read({&second, 1}).front())) continue;
      differing.push_back({second.id, (*files_)[second.place >> kOffsetBits]});
    }
  } catch (const RowsFailure& failure) {
    return failure.error;
  }
  const auto again = std::ranges::unique(added_, {}, &Entry::id);
  added_.erase(again.begin(), again.end());
  added_.shrink_to_fit();
  settled_ = std::make_shared<const Entries>(std::move(added_));
  added_.clear();
  return differing;
}

void JournalIndex::add_row(const ScenarioRow& row, const fs::path& path, std::uint64_t offset) {
  note_text_inputs(row, text_inputs_);
  recent_.emplace(row.id, place_of(file_number(path), offset));
  if (recent_.size() >= kRecentMost + settled_->size() / 8) settle_recent();
}

bool JournalIndex::contains(std::uint64_t id) const {
  return recent_.contains(id) || std::ranges::binary_search(*settled_, id, {}, &Entry::id);
}

void JournalIndex::settle_recent() {
  if (recent_.empty()) return;
  Entries recent;
  for (const auto& [id, place] : recent_) recent.push_back({id, place});
  std::ranges::sort(recent);
  auto all = std::make_shared<Entries>();
  all->reserve(settled_->size() + recent.size());
  std::ranges::merge(*settled_, recent, std::back_inserter(*all));
  settled_ = std::move(all);
  recent_.clear();
}

StudyRows JournalIndex::rows(RowPlaces places) {
  settle_recent();
  return std::make_shared<const JournalRows>(files_, settled_, text_inputs_, places);
}

StudyRows JournalIndex::rows_and(StudyRows others) {
  StudyRows known = rows();
  if (others.empty()) return known;
  return std::make_shared<const MergedRows>(std::move(known), settled_, std::move(others));
}

}  // namespace unbruised::studies
