#include <algorithm>
#include <array>
#include <exception>

#include "studies/results/checksum.hpp"
#include "studies/results/digest.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/hdf5_columns.hpp"
#include "studies/results/outcome_colours.hpp"
#include "studies/results/place_columns.hpp"
#include "studies/results/results_file.hpp"
#include "studies/results/root_texts.hpp"
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

// One dataset per varied key; `position` keeps the order of the study.
template <class Row>
void write_inputs(Hdf5File& file, const std::string& group, const Dimension& dimension,
                  const std::vector<ColumnInfo>& columns, const std::vector<Row>& rows) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const ColumnInfo& column = columns[k];
    const std::string name = joined({group, "/", column.key});
    const std::string long_name = column.long_name.empty() ? key_words(column.key) : column.long_name;
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

void write_outcomes(Hdf5File& file, const Dimension& scenarios, const std::vector<ScenarioRow>& rows) {
  const auto outcomes =
      column_of(rows, [](const ScenarioRow& row) { return static_cast<std::int8_t>(row.result.outcome); });
  file.write("/scenarios/outcome", outcomes, {rows.size()}, kNotRunCode);
  describe_flags(file, "/scenarios/outcome", outcome_flags(), kOutcomeColumn.long_name);
  file.set_attribute("/scenarios/outcome", "flag_colors", outcome_colour_list());
  file.attach_scale("/scenarios/outcome", scenarios.scale, 0);
  write_text_column(file, "/scenarios/cause", scenarios,
                    column_of(rows, [](const ScenarioRow& row) { return row.result.cause; }),
                    kCauseColumn.long_name);
  write_column(file, "/scenarios/outcome_time_s", scenarios,
               column_of(rows, [](const ScenarioRow& row) { return row.result.outcome_time_s; }),
               kOutcomeTimeColumn.units, kOutcomeTimeColumn.long_name);
  const auto digests = column_of(rows, [](const ScenarioRow& row) { return result_digest(row.result); });
  file.write("/scenarios/digest", digests, {rows.size()});
  describe(file, "/scenarios/digest", "", "XXH3 of outcome, outcome_time_s and every metric");
  file.attach_scale("/scenarios/digest", scenarios.scale, 0);
}

// Which question of which search, or which force, each row answered; only where rows were asked for.
void write_places(Hdf5File& file, const Dimension& scenarios, const ResultsContent& content) {
  const std::vector<ScenarioRow>& rows = content.rows;
  if (rows.empty() || !rows.front().place) return;
  for (const PlaceColumn& column : content.places == RowPlaces::forces ? kForceColumns : kQuestionColumns) {
    file.write(column.name,
               column_of(rows,
                         [&column](const ScenarioRow& row) {
                           return static_cast<std::int64_t>(row.place.value_or(SearchPlace{}).*column.field);
                         }),
               {rows.size()});
    describe(file, column.name, "", column.long_name);
    file.attach_scale(column.name, scenarios.scale, 0);
  }
}

void write_scenarios(Hdf5File& file, const ResultsContent& content) {
  const std::vector<ScenarioRow>& rows = content.rows;
  const Dimension scenarios{"/scenarios/id", rows.size()};
  const auto ids = column_of(rows, [](const ScenarioRow& row) { return static_cast<std::int64_t>(row.id); });
  file.write(scenarios.scale, ids, {rows.size()});
  file.set_attribute(scenarios.scale, "long_name", std::string(kIdColumn.long_name));
  file.make_scale(scenarios.scale);
  file.make_group("/scenarios/input");
  write_inputs(file, "/scenarios/input", scenarios, content.inputs, rows);
  for (const MetricInfo& info : kMetricTable) {
    const auto values =
        column_of(rows, [&info](const ScenarioRow& row) { return row.result.metrics[info.metric]; });
    write_column(file, joined({"/scenarios/metric/", info.name}), scenarios, values, std::string(info.units),
                 std::string(info.long_name));
  }
  write_outcomes(file, scenarios, rows);
  write_places(file, scenarios, content);
}

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

void write_content(Hdf5File& file, const ResultsContent& content) {
  write_root(file, content.meta);
  write_scenarios(file, content);
  for (const ResultTable& table : content.tables) write_table(file, table);
  if (content.window != nullptr) write_window(file, *content.window);
  if (content.trace != nullptr) write_trace(file, *content.trace);
}

ResultsContent sorted_by_id(const ResultsContent& content) {
  ResultsContent sorted = content;
  std::stable_sort(sorted.rows.begin(), sorted.rows.end(),
                   [](const ScenarioRow& a, const ScenarioRow& b) { return a.id < b.id; });
  return sorted;
}

}  // namespace

Expected<std::string> results_image(const fs::path& path, const ResultsContent& content) {
  const Hdf5Silence silence;
  try {
    Hdf5File file = Hdf5File::create(path);
    if (std::ranges::is_sorted(content.rows, {}, &ScenarioRow::id)) {
      write_content(file, content);
    } else {
      write_content(file, sorted_by_id(content));
    }
    return file.image();
  } catch (const std::exception& failure) {
    return ResultsError{ResultsErrorKind::io, failure.what(), {}};
  }
}

MaybeError write_results_file(const fs::path& path, const ResultsContent& content) {
  const auto image = results_image(path, content);
  return image ? write_text_file(path, *image) : image.error();
}

}  // namespace unbruised::studies
