#include "studies/config/measured_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "studies/config/csv_rows.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

constexpr std::string_view kClosure = "closure_m";
constexpr std::string_view kTime = "time_s";
constexpr std::string_view kForce = "force_N";
constexpr std::string_view kSpecimen = "specimen";
/// No product is closed by more; what is larger are millimetres.
constexpr double kLargestClosure_m = 0.3;

/// A text with a first line of names; cells are asked for by name.
class NamedRows {
 public:
  NamedRows(std::string_view content, const std::shared_ptr<const std::string>& file, int rank, Problems& problems)
      : csv_(content, file, rank), start_{file, rank, 1}, problems_(problems) {
    if (csv_.next()) {
      names_ = csv_.cells();
      start_ = csv_.origin();
    }
  }

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const Origin& start() const { return start_; }
  [[nodiscard]] const Origin& origin() const { return csv_.origin(); }

  [[nodiscard]] bool has(std::string_view name) const { return place(name) < names_.size(); }
  [[nodiscard]] const std::string& cell(std::string_view name) const { return csv_.cells()[place(name)]; }

  /// Goes on to the next row. @return false: there is none, or it is none of this text
  bool next(std::string_view key) {
    if (!csv_.next()) return false;
    if (csv_.cells().size() != names_.size()) {
      problems_.add(csv_.origin(), key,
                    "a row must have as many cells as the first line has (" + std::to_string(names_.size()) +
                        "), not " + std::to_string(csv_.cells().size()));
      return false;
    }
    if (rows_++ < kMaxDataRows) return true;
    problems_.add(csv_.origin(), key, "more than 10,000 rows");
    return false;
  }

  /// A finite number; none is a problem.
  std::optional<double> number(std::string_view name) {
    const std::optional<double> value = cell_number(cell(name));
    if (value && std::isfinite(*value)) return value;
    problems_.add(csv_.origin(), name, value ? spelled(*value) : toml_string(cell(name)),
                  "must be a finite number");
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::size_t place(std::string_view name) const {
    return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }

  CsvRows csv_;
  Origin start_;
  std::vector<std::string> names_;
  std::size_t rows_ = 0;
  Problems& problems_;
};

/// A name without its unit: "closure" of "closure_mm".
std::string_view stem(std::string_view name) { return name.substr(0, name.find('_')); }

class CurveReader {
 public:
  CurveReader(NamedRows& rows, const CalibrateTable& settings, const Origin& start, Problems& problems)
      : rows_(rows),
        outcome_(settings.outcome),
        over_(column_over(settings.test)),
        measured_(column_measured(settings.test)),
        start_(start),
        problems_(problems) {}

  std::vector<SpecimenBlock> read() {
    const std::size_t before = problems_.count();
    for (const std::string_view name : {over_, measured_}) need(name);
    if (!outcome_.empty()) need(outcome_);
    while (problems_.count() == before && rows_.next(measured_)) read_row();
    if (problems_.count() == before && blocks_.empty()) problems_.add(start_, measured_, "the file has no rows");
    return problems_.count() == before ? std::move(blocks_) : std::vector<SpecimenBlock>{};
  }

 private:
  void need(std::string_view name) {
    if (rows_.has(name)) return;
    for (const std::string& other : rows_.names()) {
      if (stem(other) != stem(name) || name == outcome_) continue;
      problems_.add(start_, other, "has another unit; give " + std::string(name));
      return;
    }
    problems_.add(start_, name, "no such column; the file has " + listed(rows_.names(), "and"));
  }

  void read_row() {
    const std::optional<double> x = rows_.number(over_);
    const std::optional<double> y = rows_.number(measured_);
    if (!x || !y) return;
    SpecimenBlock& block = block_of_row();
    std::vector<double>& over = over_ == kTime ? block.time_s : block.closure_m;
    if (!over.empty() && !(*x > over.back())) {
      complain(over_, *x,
               "must be > the one before it, " + spelled(over.back()) + ": a specimen's rows are in this order");
      return;
    }
    if (*x < 0.0) return complain(over_, *x, "must be >= 0: it counts from the first contact");
    for (const auto& [name, value] : {std::pair{over_, *x}, std::pair{measured_, *y}}) {
      if (name == kClosure && std::abs(value) > kLargestClosure_m)
        return complain(name, value, "must be <= 0.3: are these millimetres?");
    }
    over.push_back(*x);
    (measured_ == kForce ? block.force_N : block.closure_m).push_back(*y);
    if (!outcome_.empty()) read_outcome(block);
  }

  void complain(std::string_view name, double value, const std::string& rule) {
    problems_.add(rows_.origin(), name, spelled(value), rule);
  }

  SpecimenBlock& block_of_row() {
    const std::string name =
        rows_.has(kSpecimen) ? rows_.cell(kSpecimen) : std::filesystem::path(*start_.file).stem().string();
    const auto found = std::find_if(blocks_.begin(), blocks_.end(),
                                    [&](const SpecimenBlock& block) { return block.name == name; });
    if (found != blocks_.end()) return *found;
    blocks_.emplace_back();
    blocks_.back().name = name;
    blocks_.back().origin = rows_.origin();
    return blocks_.back();
  }

  void read_outcome(SpecimenBlock& block) {
    if (rows_.cell(outcome_).empty()) return;
    const std::optional<double> value = rows_.number(outcome_);
    if (!value) return;
    if (block.outcome && *block.outcome != *value) {
      return complain(outcome_, *value, "must be the same in all rows of a specimen, " + spelled(*block.outcome));
    }
    block.outcome = value;
  }

  NamedRows& rows_;
  const std::string outcome_;
  const std::string_view over_, measured_;
  const Origin start_;
  Problems& problems_;
  std::vector<SpecimenBlock> blocks_;
};

}  // namespace

std::vector<double> column_numbers(std::string_view content, const std::string& column, const std::string& key,
                                   const std::shared_ptr<const std::string>& file, int rank, Problems& problems) {
  const std::size_t before = problems.count();
  NamedRows rows(content, file, rank, problems);
  if (!rows.has(column)) {
    problems.add(rows.start(), column,
                 rows.names().empty() ? "no such column; the file has no rows"
                                      : "no such column; the file has " + listed(rows.names(), "and"));
    return {};
  }
  std::vector<double> numbers;
  while (rows.next(key)) {
    const std::optional<double> number = rows.number(column);
    if (!number) return {};
    numbers.push_back(*number);
  }
  if (problems.count() > before) return {};
  if (numbers.size() >= kFewestDataRows) return numbers;
  problems.add({file, rank, 1}, key,
               "the file must have three rows at least, not " + std::to_string(numbers.size()));
  return {};
}

std::string_view column_over(CurveTest test) { return test == CurveTest::press ? kClosure : kTime; }

std::string_view column_measured(CurveTest test) { return test == CurveTest::creep ? kClosure : kForce; }

std::vector<SpecimenBlock> measured_curves(std::string_view content, const CalibrateTable& settings,
                                           const std::shared_ptr<const std::string>& file, int rank,
                                           Problems& problems) {
  NamedRows rows(content, file, rank, problems);
  if (rows.names().empty()) {
    problems.add({file, rank, 1}, column_measured(settings.test), "the file has no rows");
    return {};
  }
  return CurveReader(rows, settings, rows.start(), problems).read();
}

}  // namespace unbruised::studies
