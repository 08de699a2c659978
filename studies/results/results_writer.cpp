#include <algorithm>
#include <array>
#include <exception>
#include <functional>
#include <memory>
#include <system_error>

#include "studies/results/checksum.hpp"
#include "studies/results/digest.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/hdf5_columns.hpp"
#include "studies/results/outcome_colours.hpp"
#include "studies/results/paged_file.hpp"
#include "studies/results/place_columns.hpp"
#include "studies/results/results_file.hpp"
#include "studies/results/root_texts.hpp"
#include "studies/results/run_layout.hpp"
#include "studies/results/scenario_columns.hpp"
#include "studies/results/trace_columns.hpp"
#include "studies/results/window_columns.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/key_names.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

namespace {

constexpr auto kNotRunCode = static_cast<std::int8_t>(Outcome::not_run);

/// From `not_run` on.
Flags outcome_flags() {
  std::vector<std::string_view> words = {outcome_word(Outcome::not_run)};
  words.insert(words.end(), kOutcomeWords.begin(), kOutcomeWords.end());
  return flags_of(words, kNotRunCode);
}

/// The colours of the same codes, a blank between them.
std::string outcome_colour_list() {
  std::string colours(outcome_colour(Outcome::not_run));
  for (const std::string_view colour : kOutcomeColours) colours += joined({" ", colour});
  return colours;
}

double number_of(const InputValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? *number : kAbsent;
}

std::string text_of(const InputValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : std::string();
}

std::string long_name_of(const ColumnInfo& column) {
  return column.long_name.empty() ? key_words(column.key) : column.long_name;
}

// The same of a table that is in memory.
template <class Row>
void write_inputs(Hdf5File& file, const std::string& group, const Dimension& dimension,
                  const std::vector<ColumnInfo>& columns, const std::vector<Row>& rows) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const ColumnInfo& column = columns[k];
    const std::string name = joined({group, "/", column.key});
    const std::string long_name = long_name_of(column);
    const auto values = column_of(rows, [k](const Row& row) -> InputValue {
      return k < row.inputs.size() ? row.inputs[k] : InputValue(kAbsent);
    });
    const bool is_text =
        std::any_of(values.begin(), values.end(), [](const InputValue& v) { return v.index() == 1; });
    if (is_text) {
      write_text_column(file, name, dimension, column_of(values, text_of), long_name);
    } else {
      write_column(file, name, dimension, column_of(values, number_of), column.units, long_name);
    }
    file.set_attribute(name, "position", static_cast<std::int32_t>(k));
  }
}

void write_root(Hdf5File& file, const ResultsMeta& meta) {
  file.set_attribute("/", "format_version", std::int32_t{kResultsFormatVersion});
  for (const RootText& root : kRootTexts) {
    const bool is_missing_hash = root.text == &ResultsMeta::config_sha256 && meta.config_sha256.empty();
    file.set_attribute("/", root.attribute, is_missing_hash ? sha256_hex(meta.config_toml) : meta.*root.text);
  }
  file.set_attribute("/", "complete", std::int32_t{meta.complete ? 1 : 0});
  file.set_attribute("/", "warnings", meta.warnings);
  file.set_attribute("/", "Conventions", std::string("CF-1.8"));
}

/// The columns of the scenarios, which are filled block by block.
class ScenarioColumns {
 public:
  ScenarioColumns(Hdf5File& file, const ResultsContent& content)
      : file_(file), rows_(content.stored.empty() ? StudyRows(by_id(content.rows)) : content.stored) {
    add_ids();
    file_.make_group("/scenarios/input");
    add_inputs(content.inputs);
    for (const MetricInfo& info : kMetricTable) {
      add_number(joined({"/scenarios/metric/", info.name}), std::string(info.units), std::string(info.long_name),
                 [metric = info.metric](const ScenarioRow& row) { return row.result.metrics[metric]; });
    }
    add_outcomes();
    add_places(content.places);
  }

  /// @param look called after each block; may throw
  void fill(const std::function<void()>& look) {
    for (std::size_t first = 0; first < rows_.size();) {
      const RowBlock block = rows_.block(first);
      const auto rows = block.rows.first(std::min(block.rows.size(), kRowsAtATime));
      for (const auto& write : writers_) write(first, rows);
      first += rows.size();
      look();
    }
    for (const auto& column : columns_) column->close();
  }

 private:
  /// A column with the values of `field`, of type T.
  template <class T, class Field>
  void add(const std::string& name, Hdf5Kind kind, Field field) {
    auto column = std::make_shared<Hdf5Column>(file_.make_column(name, kind, rows_.size()));
    columns_.push_back(column);
    writers_.push_back([column, field](std::uint64_t first, std::span<const ScenarioRow> rows) {
      std::vector<T> values;
      values.reserve(rows.size());
      for (const ScenarioRow& row : rows) values.push_back(field(row));
      column->write(first, std::span<const T>(values));
    });
  }

  template <class Field>
  void add_number(const std::string& name, const std::string& units, const std::string& long_name, Field field) {
    add<double>(name, Hdf5Kind::number, field);
    file_.set_attribute(name, "_FillValue", kAbsent);
    describe(file_, name, units, long_name);
    file_.attach_scale(name, kScale, 0);
  }

  template <class Field>
  void add_text(const std::string& name, const std::string& long_name, Field field) {
    add<std::string>(name, Hdf5Kind::text, field);
    describe(file_, name, "", long_name);
    file_.attach_scale(name, kScale, 0);
  }

  void add_ids() {
    add<std::int64_t>(kScale, Hdf5Kind::integer,
                      [](const ScenarioRow& row) { return static_cast<std::int64_t>(row.id); });
    file_.set_attribute(kScale, "long_name", std::string(kIdColumn.long_name));
    file_.make_scale(kScale);
  }

  // One dataset per varied key; `position` keeps the order of the study.
  void add_inputs(const std::vector<ColumnInfo>& columns) {
    std::vector<bool> is_text = rows_.text_inputs();
    is_text.resize(std::max(is_text.size(), columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::string name = joined({"/scenarios/input/", columns[k].key});
      const auto value = [k](const ScenarioRow& row) {
        return k < row.inputs.size() ? row.inputs[k] : InputValue(kAbsent);
      };
      if (is_text[k]) {
        add_text(name, long_name_of(columns[k]), [value](const ScenarioRow& row) { return text_of(value(row)); });
      } else {
        add_number(name, columns[k].units, long_name_of(columns[k]),
                   [value](const ScenarioRow& row) { return number_of(value(row)); });
      }
      file_.set_attribute(name, "position", static_cast<std::int32_t>(k));
    }
  }

  void add_outcomes() {
    const std::string outcome = "/scenarios/outcome";
    add<std::int8_t>(outcome, Hdf5Kind::code,
                     [](const ScenarioRow& row) { return static_cast<std::int8_t>(row.result.outcome); });
    describe_flags(file_, outcome, outcome_flags(), kOutcomeColumn.long_name);
    file_.set_attribute(outcome, "flag_colors", outcome_colour_list());
    file_.attach_scale(outcome, kScale, 0);
    add_text("/scenarios/cause", kCauseColumn.long_name, [](const ScenarioRow& row) { return row.result.cause; });
    add_number("/scenarios/outcome_time_s", kOutcomeTimeColumn.units, kOutcomeTimeColumn.long_name,
               [](const ScenarioRow& row) { return row.result.outcome_time_s; });
    const std::string digest = "/scenarios/digest";
    add<std::uint64_t>(digest, Hdf5Kind::digest, [](const ScenarioRow& row) { return result_digest(row.result); });
    describe(file_, digest, "", "XXH3 of outcome, outcome_time_s and every metric");
    file_.attach_scale(digest, kScale, 0);
  }

  // Which question of which search, or which force, each row answered; only where rows were asked for.
  void add_places(RowPlaces places) {
    if (rows_.empty() || !rows_.front().place) return;
    for (const PlaceColumn& column : places == RowPlaces::forces ? kForceColumns : kQuestionColumns) {
      add<std::int64_t>(column.name, Hdf5Kind::integer, [field = column.field](const ScenarioRow& row) {
        return static_cast<std::int64_t>(row.place.value_or(SearchPlace{}).*field);
      });
      describe(file_, column.name, "", column.long_name);
      file_.attach_scale(column.name, kScale, 0);
    }
  }

  inline static const std::string kScale = "/scenarios/id";
  Hdf5File& file_;
  const StudyRows rows_;
  std::vector<std::shared_ptr<Hdf5Column>> columns_;
  std::vector<std::function<void(std::uint64_t first, std::span<const ScenarioRow> rows)>> writers_;
};

void write_window(Hdf5File& file, const WindowTable& table) {
  const Dimension windows{"/window/window", table.rows.size()};
  write_scale(file, windows, "number of the combination of the other varied keys");
  write_inputs(file, "/window", windows, table.inputs, table.rows);
  for (const WindowNumber& column : kWindowNumbers) {
    const auto values = column_of(table.rows, [&](const WindowRow& row) { return row.*column.value; });
    write_column(file, joined({"/window/", column.name}), windows, values, column.units, column.long_name);
  }
  for (const WindowFlag& flag : kWindowFlags) {
    const std::string name = joined({"/window/", flag.name});
    file.write(
        name,
        column_of(table.rows, [&](const WindowRow& row) { return static_cast<std::int8_t>(row.*flag.value); }),
        {table.rows.size()}, 0);
    describe_flags(file, name, flags_of(flag.words), flag.long_name);
    file.attach_scale(name, windows.scale, 0);
  }
  for (const WindowText& text : kWindowTexts) {
    write_text_column(file, joined({"/window/", text.name}), windows,
                      column_of(table.rows, [&](const WindowRow& row) { return row.*text.value; }),
                      text.long_name);
  }
}

std::size_t length_of(const ResultColumn& column) {
  return std::visit([](const auto& values) { return values.size(); }, column.values);
}

void write_table(Hdf5File& file, const ResultTable& table) {
  const std::string group = joined({"/", table.name});
  const Dimension rows{joined({group, "/", table.row}),
                       table.columns.empty() ? 0 : length_of(table.columns.front())};
  write_scale(file, rows, joined({"number of the ", table.row}));
  std::int32_t position = 0;
  for (const ResultColumn& column : table.columns) {
    const std::string name = joined({group, "/", column.name});
    if (length_of(column) != rows.count) {
      throw Hdf5Failure(joined({name, " has another length than its table"}));
    }
    if (const auto* numbers = std::get_if<std::vector<double>>(&column.values)) {
      write_column(file, name, rows, *numbers, column.units, column.long_name);
    } else {
      write_text_column(file, name, rows, std::get<std::vector<std::string>>(column.values), column.long_name);
    }
    file.set_attribute(name, "position", position++);
  }
  file.set_attribute(group, "row", table.row);
  for (const auto& [name, value] : table.attributes) {
    std::visit([&file, &group, &key = name](const auto& v) { file.set_attribute(group, key, v); }, value);
  }
}

/// @param look called now and then while rows are written; may throw
void write_content(Hdf5File& file, const ResultsContent& content, const std::function<void()>& look) {
  write_root(file, content.meta);
  ScenarioColumns(file, content).fill(look);
  for (const ResultTable& table : content.tables) write_table(file, table);
  if (content.window != nullptr) write_window(file, *content.window);
  if (content.trace != nullptr) write_trace(file, *content.trace);
}

/// The file as pages, on the disk but for its name.
MaybeError make_pages(PagedFile& pages, const fs::path& path, const ResultsContent& content) {
  const Hdf5Silence silence;
  const auto look = [&pages] {
    if (pages.failure()) throw Hdf5Failure(pages.failure()->message);
  };
  try {
    Hdf5File file = Hdf5File::create_in(pages, path);
    write_content(file, content, look);
    file.close();
  } catch (const RowsFailure& failure) {
    return failure.error;
  } catch (const std::exception& failure) {
    if (pages.failure()) return pages.failure();
    return ResultsError{ResultsErrorKind::io, failure.what(), {}};
  }
  return pages.finish();
}

}  // namespace

std::vector<ScenarioRow> by_id(std::vector<ScenarioRow> rows) {
  if (!std::ranges::is_sorted(rows, {}, &ScenarioRow::id)) std::ranges::stable_sort(rows, {}, &ScenarioRow::id);
  return rows;
}

Expected<std::string> results_image(const fs::path& path, const ResultsContent& content) {
  const Hdf5Silence silence;
  try {
    Hdf5File file = Hdf5File::create(path);
    write_content(file, content, [] {});
    return file.image();
  } catch (const RowsFailure& failure) {
    return failure.error;
  } catch (const std::exception& failure) {
    return ResultsError{ResultsErrorKind::io, failure.what(), {}};
  }
}

MaybeError write_results_file(const fs::path& path, const ResultsContent& content, std::size_t pages_in_memory) {
  PagedFile pages(path, pages_in_memory);
  if (auto error = make_pages(pages, path, content)) return error;
  return pages.publish();
}

MaybeError write_hashed_results(const fs::path& path, const ResultsContent& content) {
  PagedFile pages(path);
  if (auto error = make_pages(pages, path, content)) return error;
  Sha256 hash;
  pages.each_page([&hash](std::string_view bytes) { hash.add(bytes); });
  if (pages.failure()) return pages.failure();
  std::error_code ignored;
  fs::remove(hash_path(path), ignored);
  if (auto error = pages.publish()) return error;
  return write_text_file(hash_path(path), hash_line(hash.hex()));
}

}  // namespace unbruised::studies
