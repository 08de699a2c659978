#include <algorithm>
#include <cerrno>
#include <exception>
#include <map>
#include <system_error>

#include "studies/results/digest.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/hdf5_columns.hpp"
#include "studies/results/place_columns.hpp"
#include "studies/results/results_file.hpp"
#include "studies/results/root_texts.hpp"
#include "studies/results/trace_columns.hpp"
#include "studies/results/window_columns.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

std::string ResultsSummary::digest() const { return digest_text(digest_of_digests(digests)); }

namespace {

ResultsError damaged(const fs::path& path, std::string_view what) {
  return {ResultsErrorKind::damaged, joined({path.string(), " is damaged: ", what}), {}};
}

ResultsError foreign(const fs::path& path, std::string_view what) {
  return {ResultsErrorKind::foreign, joined({path.string(), " ", what}), {}};
}

// Opens a file that is one of ours, or says why it is not.
Expected<Hdf5File> open_results(const fs::path& path) {
  std::error_code missing;
  if (!fs::exists(path, missing)) return system_error("open", path, ENOENT);
  if (fs::is_directory(path, missing)) return foreign(path, "is a directory, not a results file");
  if (H5Fis_hdf5(path.c_str()) <= 0) return foreign(path, "is not an HDF5 file (no signature)");
  try {
    Hdf5File file = Hdf5File::open(path);
    const auto version = file.integer_attribute("/", "format_version");
    if (!version || !file.text_attribute("/", "unbruised_version")) {
      return foreign(path, "is an HDF5 file but not one of unbruised");
    }
    if (*version > kResultsFormatVersion) {
      return foreign(path, joined({"has format version ", std::to_string(*version), ", this program reads up to ",
                                   std::to_string(kResultsFormatVersion)}));
    }
    return file;
  } catch (const std::exception& failure) {
    return damaged(path, failure.what());
  }
}

ResultsMeta read_meta(const Hdf5File& file) {
  ResultsMeta meta;
  for (const RootText& root : kRootTexts) meta.*root.text = file.text_attribute("/", root.attribute).value_or("");
  meta.complete = file.integer_attribute("/", "complete").value_or(0) == 1;
  meta.warnings = file.texts_attribute("/", "warnings").value_or(std::vector<std::string>());
  return meta;
}

// The columns below `group` that carry a position, in that order.
std::vector<ColumnInfo> input_columns(const Hdf5File& file, const std::string& group) {
  std::map<std::int64_t, std::string> names;
  for (const std::string& name : file.datasets(group)) {
    if (const auto position = file.integer_attribute(joined({group, "/", name}), "position")) {
      names[*position] = name;
    }
  }
  std::vector<ColumnInfo> columns;
  for (const auto& [position, key] : names) {
    const std::string name = joined({group, "/", key});
    columns.push_back({key, file.text_attribute(name, "units").value_or(""),
                       file.text_attribute(name, "long_name").value_or("")});
  }
  return columns;
}

/// Values of these columns from row `first` of the file on into the rows.
template <class Row>
void read_inputs(const Hdf5File& file, const std::string& group, const std::vector<ColumnInfo>& columns,
                 std::uint64_t first, std::vector<Row>& rows) {
  for (const ColumnInfo& column : columns) {
    const std::string name = joined({group, "/", column.key});
    if (file.holds_text(name)) {
      auto texts = read_text_column(file, name, {first, rows.size()});
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i].inputs.emplace_back(std::move(texts[i]));
    } else {
      const auto numbers = read_column(file, name, {first, rows.size()});
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i].inputs.emplace_back(numbers[i]);
    }
  }
}

Outcome outcome_of(std::int64_t code) {
  if (code < static_cast<std::int64_t>(Outcome::not_run) ||
      code >= static_cast<std::int64_t>(kOutcomeWords.size())) {
    throw Hdf5Failure(joined({"/scenarios/outcome holds the unknown code ", std::to_string(code)}));
  }
  return static_cast<Outcome>(code);
}

// Rows that were asked for know their places again.
void read_places(const Hdf5File& file, std::uint64_t first, std::vector<ScenarioRow>& rows) {
  for (const PlaceColumns& columns : {kQuestionColumns, kForceColumns}) {
    if (!file.exists(columns.front().name)) continue;
    for (ScenarioRow& row : rows) row.place.emplace();
    for (const PlaceColumn& column : columns) {
      const auto values = read_integer_column(file, column.name, {first, rows.size()});
      for (std::size_t i = 0; i < rows.size(); ++i) {
        (*rows[i].place).*column.field = static_cast<std::uint64_t>(values[i]);
      }
    }
  }
}

/// Rows from `first` on, of `count` that there are.
std::vector<ScenarioRow> read_rows(const Hdf5File& file, std::uint64_t first, std::size_t count) {
  const Hdf5Part part{first, count};
  const auto ids = read_integer_column(file, "/scenarios/id", part);
  const auto outcomes = read_integer_column(file, "/scenarios/outcome", part);
  auto causes = read_text_column(file, "/scenarios/cause", part);
  const auto times = read_column(file, "/scenarios/outcome_time_s", part);
  std::vector<ScenarioRow> rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    ScenarioRow& row = rows[i];
    row.id = static_cast<std::uint64_t>(ids[i]);
    row.result.outcome = outcome_of(outcomes[i]);
    row.result.cause = std::move(causes[i]);
    row.result.outcome_time_s = times[i];
  }
  for (const MetricInfo& info : kMetricTable) {
    const std::string name = joined({"/scenarios/metric/", info.name});
    if (!file.exists(name)) continue;  // a file of an earlier version: the metric stays NaN
    const auto values = read_column(file, name, part);
    for (std::size_t i = 0; i < count; ++i) rows[i].result.metrics[info.metric] = values[i];
  }
  read_inputs(file, "/scenarios/input", input_columns(file, "/scenarios/input"), first, rows);
  read_places(file, first, rows);
  return rows;
}

/// Throws Hdf5Failure where a column is longer than its table: parts of it would not show that.
void require_whole_columns(const Hdf5File& file, std::size_t count) {
  for (const std::string group : {"/scenarios", "/scenarios/metric", "/scenarios/input"}) {
    for (const std::string& leaf : file.datasets(group)) {
      const std::string name = joined({group, "/", leaf});
      const Hdf5Extents extents = file.extents(name);
      require_length(name, extents.size() == 1 ? extents.front() : 0, count);
    }
  }
}

void read_scenarios(const Hdf5File& file, ResultsSummary& summary, std::size_t rows_most) {
  summary.digests = file.read_unsigned("/scenarios/digest");
  const std::size_t count = summary.row_count();
  require_whole_columns(file, count);
  for (const std::int64_t code : file.read_integers("/scenarios/outcome")) {
    summary.rows_run += outcome_of(code) == Outcome::not_run ? 0 : 1;
  }
  summary.inputs = input_columns(file, "/scenarios/input");
  if (count <= rows_most) summary.rows = read_rows(file, 0, count);
}

ResultTable read_table(const Hdf5File& file, const std::string& name) {
  const std::string group = joined({"/", name});
  ResultTable table{
      .name = name, .row = file.text_attribute(group, "row").value_or(""), .columns = {}, .attributes = {}};
  const std::size_t count = file.extents(joined({group, "/", table.row})).at(0);
  std::map<std::int64_t, std::string> order;
  for (const std::string& dataset : file.datasets(group)) {
    const auto position = file.integer_attribute(joined({group, "/", dataset}), "position");
    if (position) order[*position] = dataset;
  }
  for (const auto& [position, dataset] : order) {
    const std::string full = joined({group, "/", dataset});
    ResultColumn column{.name = dataset,
                        .units = file.text_attribute(full, "units").value_or(""),
                        .long_name = file.text_attribute(full, "long_name").value_or(""),
                        .values = {}};
    if (file.holds_text(full)) {
      column.values = read_text_column(file, full, count);
    } else {
      column.values = read_column(file, full, count);
    }
    table.columns.push_back(std::move(column));
  }
  for (const std::string& attribute : file.attributes(group)) {
    if (attribute == "row") continue;
    if (auto text = file.text_attribute(group, attribute)) {
      table.attributes.emplace_back(attribute, std::move(*text));
    } else if (const auto number = file.number_attribute(group, attribute)) {
      table.attributes.emplace_back(attribute, *number);
    }
  }
  return table;
}

// The tables of the study kind: groups that say what a row of theirs is.
std::vector<ResultTable> read_tables(const Hdf5File& file) {
  std::vector<ResultTable> tables;
  for (const std::string& group : file.groups("/")) {
    if (file.text_attribute(joined({"/", group}), "row")) tables.push_back(read_table(file, group));
  }
  return tables;
}

// Files of earlier versions have fewer columns: the others keep their defaults.
WindowTable read_window(const Hdf5File& file) {
  WindowTable table;
  table.rows.resize(file.read_integers("/window/exists").size());
  const std::size_t count = table.rows.size();
  const auto each = [&](const char* leaf, const auto& read) {
    if (const std::string name = joined({"/window/", leaf}); file.exists(name)) read(name);
  };
  for (const WindowNumber& column : kWindowNumbers) {
    each(column.name, [&](const std::string& name) {
      const auto values = read_column(file, name, count);
      for (std::size_t i = 0; i < count; ++i) table.rows[i].*column.value = values[i];
    });
  }
  for (const WindowFlag& flag : kWindowFlags) {
    each(flag.name, [&](const std::string& name) {
      const auto values = file.read_integers(name);
      for (std::size_t i = 0; i < std::min(count, values.size()); ++i) table.rows[i].*flag.value = values[i] != 0;
    });
  }
  for (const WindowText& text : kWindowTexts) {
    each(text.name, [&](const std::string& name) {
      const auto values = read_text_column(file, name, count);
      for (std::size_t i = 0; i < count; ++i) table.rows[i].*text.value = values[i];
    });
  }
  table.inputs = input_columns(file, "/window");
  read_inputs(file, "/window", table.inputs, 0, table.rows);
  return table;
}

}  // namespace

Expected<ResultsSummary> read_results_summary(const fs::path& path, std::size_t rows_most) {
  const Hdf5Silence silence;
  auto file = open_results(path);
  if (!file) return file.error();
  try {
    ResultsSummary summary;
    summary.format_version = static_cast<int>(*file->integer_attribute("/", "format_version"));
    summary.meta = read_meta(*file);
    read_scenarios(*file, summary, rows_most);
    summary.tables = read_tables(*file);
    if (file->exists("/window")) summary.window = read_window(*file);
    summary.has_trace = file->exists("/trace");
    if (summary.has_trace) summary.trace_signals = signal_names(*file);
    return summary;
  } catch (const std::exception& failure) {
    return damaged(path, failure.what());
  }
}

Expected<std::vector<ScenarioRow>> read_results_rows(const fs::path& path, std::uint64_t first,
                                                     std::uint64_t count) {
  const Hdf5Silence silence;
  auto file = open_results(path);
  if (!file) return file.error();
  try {
    const Hdf5Extents all = file->extents("/scenarios/id");
    const std::uint64_t rows = all.size() == 1 ? all.front() : 0;
    return read_rows(*file, std::min(first, rows), std::min(count, rows - std::min(first, rows)));
  } catch (const std::exception& failure) {
    return damaged(path, failure.what());
  }
}

Expected<Trace> read_trace(const fs::path& path) {
  const Hdf5Silence silence;
  auto file = open_results(path);
  if (!file) return file.error();
  if (!file->exists("/trace")) return foreign(path, "holds no trace");
  try {
    return read_trace(*file);
  } catch (const std::exception& failure) {
    return damaged(path, failure.what());
  }
}

}  // namespace unbruised::studies
