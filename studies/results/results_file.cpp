#include "studies/results/results_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <numeric>
#include <system_error>

#include "studies/results/checksum.hpp"
#include "studies/results/digest.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/hdf5_file.hpp"
#include "studies/results/root_texts.hpp"
#include "studies/results/window_columns.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

namespace {

constexpr std::int8_t kNotRunCode = -1;
constexpr std::array<std::int8_t, 8> kOutcomeFlags = {-1, 0, 1, 2, 3, 4, 5, 6};
constexpr std::array<std::int8_t, 2> kYesNoFlags = {0, 1};
constexpr std::array<std::int8_t, 4> kEventFlags = {0, 1, 2, 3};

std::string outcome_meanings() {
  std::string meanings = "not_run";
  for (const std::string_view word : kOutcomeWords) meanings.append(" ").append(word);
  return meanings;
}

std::vector<std::int64_t> indices(std::size_t count) {
  std::vector<std::int64_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::int64_t{0});
  return numbers;
}

void describe(Hdf5File& file, const std::string& name, const std::string& units, const std::string& long_name) {
  if (!units.empty()) file.set_attribute(name, "units", units);
  if (!long_name.empty()) file.set_attribute(name, "long_name", long_name);
}

void describe_flags(Hdf5File& file, const std::string& name, std::span<const std::int8_t> values,
                    const std::string& meanings, const std::string& long_name) {
  file.set_attribute(name, "flag_values", values);
  file.set_attribute(name, "flag_meanings", meanings);
  file.set_attribute(name, "long_name", long_name);
}

/// A table's dimension: its scale, and the number of its rows.
struct Dimension {
  std::string scale;
  std::size_t count;
};

void write_scale(Hdf5File& file, const Dimension& dimension, const std::string& long_name) {
  file.write(dimension.scale, indices(dimension.count), {dimension.count});
  file.set_attribute(dimension.scale, "long_name", long_name);
  file.make_scale(dimension.scale);
}

void write_column(Hdf5File& file, const std::string& name, const Dimension& dimension,
                  std::span<const double> values, const std::string& units, const std::string& long_name) {
  file.write(name, values, {dimension.count});
  file.set_attribute(name, "_FillValue", kAbsent);
  describe(file, name, units, long_name);
  file.attach_scale(name, dimension.scale, 0);
}

void write_text_column(Hdf5File& file, const std::string& name, const Dimension& dimension,
                       const std::vector<std::string>& texts, const std::string& long_name) {
  file.write(name, texts);
  describe(file, name, "", long_name);
  file.attach_scale(name, dimension.scale, 0);
}

template <class Row, class Field>
auto column_of(const std::vector<Row>& rows, Field field) {
  std::vector<std::decay_t<decltype(field(rows.front()))>> values;
  values.reserve(rows.size());
  for (const Row& row : rows) values.push_back(field(row));
  return values;
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
    const auto values = column_of(rows, [k](const Row& row) -> InputValue {
      return k < row.inputs.size() ? row.inputs[k] : InputValue(kAbsent);
    });
    const bool is_text =
        std::any_of(values.begin(), values.end(), [](const InputValue& v) { return v.index() == 1; });
    if (is_text) {
      write_text_column(file, name, dimension, column_of(values, text_of), column.long_name);
    } else {
      write_column(file, name, dimension, column_of(values, number_of), column.units, column.long_name);
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
  describe_flags(file, "/scenarios/outcome", kOutcomeFlags, outcome_meanings(), "how the scenario ended");
  file.attach_scale("/scenarios/outcome", scenarios.scale, 0);
  write_text_column(file, "/scenarios/cause", scenarios,
                    column_of(rows, [](const ScenarioRow& row) { return row.result.cause; }),
                    "what decided the outcome");
  write_column(file, "/scenarios/outcome_time_s", scenarios,
               column_of(rows, [](const ScenarioRow& row) { return row.result.outcome_time_s; }), "s",
               "first crossing of the limit that decided the outcome");
  const auto digests = column_of(rows, [](const ScenarioRow& row) { return result_digest(row.result); });
  file.write("/scenarios/digest", digests, {rows.size()});
  describe(file, "/scenarios/digest", "", "XXH3 of outcome, outcome_time_s and every metric");
  file.attach_scale("/scenarios/digest", scenarios.scale, 0);
}

constexpr std::array<std::pair<const char*, std::uint64_t SearchPlace::*>, 3> kPlaceColumns = {{
    {"/scenarios/search", &SearchPlace::search},
    {"/scenarios/generation", &SearchPlace::generation},
    {"/scenarios/index", &SearchPlace::index},
}};

// Which question of which search each row answered; only where a search asked.
void write_places(Hdf5File& file, const Dimension& scenarios, const std::vector<ScenarioRow>& rows) {
  if (rows.empty() || !rows.front().place) return;
  for (const auto& [name, field] : kPlaceColumns) {
    const auto member = field;
    file.write(name,
               column_of(rows,
                         [member](const ScenarioRow& row) {
                           return static_cast<std::int64_t>(row.place.value_or(SearchPlace{}).*member);
                         }),
               {rows.size()});
    file.attach_scale(name, scenarios.scale, 0);
  }
  describe(file, "/scenarios/search", "", "number of the search that asked");
  describe(file, "/scenarios/generation", "", "number of the question inside its search");
  describe(file, "/scenarios/index", "", "number inside the question: finite differences, random products");
}

void write_scenarios(Hdf5File& file, const ResultsContent& content) {
  const std::vector<ScenarioRow>& rows = content.rows;
  const Dimension scenarios{"/scenarios/id", rows.size()};
  const auto ids = column_of(rows, [](const ScenarioRow& row) { return static_cast<std::int64_t>(row.id); });
  file.write(scenarios.scale, ids, {rows.size()});
  file.set_attribute(scenarios.scale, "long_name", std::string("number of the scenario in the study's order"));
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
  write_places(file, scenarios, rows);
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
    describe_flags(file, name, kYesNoFlags, flag.meanings, flag.long_name);
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

/// Writes /trace: knows which dimension scales exist already.
class TraceWriter {
 public:
  TraceWriter(Hdf5File& file, const Trace& trace) : file_(file), trace_(trace) {}

  void write() {
    const std::size_t times = trace_.time_s.size();
    const auto particles = static_cast<std::size_t>(trace_.particle_count);
    file_.write("/trace/time_s", trace_.time_s, {times});
    describe(file_, "/trace/time_s", "s", "time since the start of the scenario");
    file_.make_scale("/trace/time_s");
    const std::vector<std::string> motion = {scale("particle", particles), scale("component", 3)};
    write_array("rest_position_m", "m", "rest position", trace_.rest_position_m, {particles, 3}, motion);
    write_over_time("displacement_m", "m", "displacement from rest", trace_.displacement_m, {particles, 3},
                    motion);
    write_over_time("velocity_m_s", "m s-1", "velocity", trace_.velocity_m_s, {particles, 3}, motion);
    write_over_time("acceleration_m_s2", "m s-2", "acceleration", trace_.acceleration_m_s2, {particles, 3},
                    motion);
    for (const TraceSignal& signal : trace_.signals) write_signal(signal);
  }

 private:
  // The scale of a dimension; one whose name is taken by another extent is called <name>_<extent>.
  std::string scale(const std::string& dimension, std::size_t extent) {
    const auto known = extents_.find(dimension);
    if (known != extents_.end() && known->second != extent) {
      return scale(joined({dimension, "_", std::to_string(extent)}), extent);
    }
    const std::string name = joined({"/trace/", dimension});
    if (known == extents_.end()) {
      write_scale(file_, {name, extent}, joined({"index of the ", dimension}));
      extents_[dimension] = extent;
    }
    return name;
  }

  void write_array(const std::string& name, const std::string& units, const std::string& long_name,
                   const std::vector<double>& values, const Hdf5Extents& extents,
                   const std::vector<std::string>& scales) {
    const std::string full_name = joined({"/trace/", name});
    std::uint64_t expected = 1;
    for (const std::uint64_t extent : extents) expected *= extent;
    if (expected != values.size()) {
      throw Hdf5Failure(joined({"the trace's ", name, " has ", std::to_string(values.size()), " values where ",
                                std::to_string(expected), " are due"}));
    }
    file_.write(full_name, values, extents);
    describe(file_, full_name, units, long_name);
    for (std::size_t axis = 0; axis < scales.size(); ++axis) {
      file_.attach_scale(full_name, scales[axis], static_cast<unsigned>(axis));
    }
  }

  void write_over_time(const std::string& name, const std::string& units, const std::string& long_name,
                       const std::vector<double>& values, const Hdf5Extents& row_extents,
                       const std::vector<std::string>& row_scales) {
    Hdf5Extents extents{trace_.time_s.size()};
    std::vector<std::string> scales{"/trace/time_s"};
    extents.insert(extents.end(), row_extents.begin(), row_extents.end());
    scales.insert(scales.end(), row_scales.begin(), row_scales.end());
    write_array(name, units, long_name, values, extents, scales);
  }

  void write_signal(const TraceSignal& signal) {
    Hdf5Extents extents(signal.extents.begin(), signal.extents.end());
    std::vector<std::string> scales;
    for (std::size_t k = 0; k < extents.size(); ++k) {
      const bool named = k < signal.dimensions.size();
      scales.push_back(scale(named ? signal.dimensions[k] : joined({"axis_", std::to_string(k)}), extents[k]));
    }
    write_over_time(signal.name, signal.units, signal.long_name, signal.values, extents, scales);
  }

  Hdf5File& file_;
  const Trace& trace_;
  std::map<std::string, std::size_t> extents_;
};

void write_events(Hdf5File& file, const std::vector<ContactEvent>& events) {
  const Dimension dimension{"/contact_events/event", events.size()};
  write_scale(file, dimension, "number of the event in the order of time");
  write_column(file, "/contact_events/time_s", dimension,
               column_of(events, [](const ContactEvent& e) { return e.time_s; }), "s",
               "time of the event, interpolated inside the step");
  const auto write_index = [&](const std::string& name, int ContactEvent::*field, const std::string& long_name) {
    file.write(name, column_of(events, [&](const ContactEvent& e) { return std::int32_t{e.*field}; }),
               {events.size()});
    describe(file, name, "", long_name);
    file.attach_scale(name, dimension.scale, 0);
  };
  write_index("/contact_events/node", &ContactEvent::node, "index of the particle");
  write_index("/contact_events/surface", &ContactEvent::surface, "0 left pad, 1 right pad, 2 support");
  file.write("/contact_events/kind",
             column_of(events, [](const ContactEvent& e) { return static_cast<std::int8_t>(e.kind); }),
             {events.size()}, 0);
  describe_flags(file, "/contact_events/kind", kEventFlags, "make break stick slip", "change of the contact");
  file.attach_scale("/contact_events/kind", dimension.scale, 0);
}

void write_content(Hdf5File& file, const ResultsContent& content) {
  write_root(file, content.meta);
  write_scenarios(file, content);
  for (const ResultTable& table : content.tables) write_table(file, table);
  if (content.window != nullptr) write_window(file, *content.window);
  if (content.trace == nullptr) return;
  file.make_group("/trace");
  TraceWriter(file, *content.trace).write();
  write_events(file, content.trace->events);
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
    write_content(file, sorted_by_id(content));
    return file.image();
  } catch (const std::exception& failure) {
    return ResultsError{ResultsErrorKind::io, failure.what(), {}};
  }
}

MaybeError write_results_file(const fs::path& path, const ResultsContent& content) {
  const auto image = results_image(path, content);
  return image ? write_text_file(path, *image) : image.error();
}

std::string ResultsSummary::digest() const { return digest_text(digest_of_digests(digests)); }

std::size_t ResultsSummary::count(Outcome outcome) const {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [outcome](const ScenarioRow& row) { return row.result.outcome == outcome; }));
}

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

void require_length(const std::string& name, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  throw Hdf5Failure(
      joined({name, " has ", std::to_string(length), " rows where ", std::to_string(expected), " are due"}));
}

std::vector<double> read_column(const Hdf5File& file, const std::string& name, std::size_t count) {
  auto values = file.read_doubles(name);
  require_length(name, values.size(), count);
  return values;
}

std::vector<std::string> read_text_column(const Hdf5File& file, const std::string& name, std::size_t count) {
  auto texts = file.read_texts(name);
  require_length(name, texts.size(), count);
  return texts;
}

std::vector<std::int64_t> read_integer_column(const Hdf5File& file, const std::string& name, std::size_t count) {
  auto values = file.read_integers(name);
  require_length(name, values.size(), count);
  return values;
}

// The columns below `group` that carry a position, in that order, and their values into the rows.
template <class Row>
std::vector<ColumnInfo> read_inputs(const Hdf5File& file, const std::string& group, std::vector<Row>& rows) {
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
    if (file.holds_text(name)) {
      const auto texts = read_text_column(file, name, rows.size());
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i].inputs.emplace_back(texts[i]);
    } else {
      const auto numbers = read_column(file, name, rows.size());
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i].inputs.emplace_back(numbers[i]);
    }
  }
  return columns;
}

Outcome outcome_of(std::int64_t code) {
  if (code < kNotRunCode || code >= static_cast<std::int64_t>(kOutcomeWords.size())) {
    throw Hdf5Failure(joined({"/scenarios/outcome holds the unknown code ", std::to_string(code)}));
  }
  return static_cast<Outcome>(code);
}

void read_scenarios(const Hdf5File& file, ResultsSummary& summary) {
  const auto ids = file.read_integers("/scenarios/id");
  const std::size_t count = ids.size();
  const auto outcomes = read_integer_column(file, "/scenarios/outcome", count);
  const auto causes = read_text_column(file, "/scenarios/cause", count);
  const auto times = read_column(file, "/scenarios/outcome_time_s", count);
  summary.rows.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    ScenarioRow& row = summary.rows[i];
    row.id = static_cast<std::uint64_t>(ids[i]);
    row.result.outcome = outcome_of(outcomes[i]);
    row.result.cause = causes[i];
    row.result.outcome_time_s = times[i];
  }
  for (const MetricInfo& info : kMetricTable) {
    const std::string name = joined({"/scenarios/metric/", info.name});
    if (!file.exists(name)) continue;  // a file of an earlier version: the metric stays NaN
    const auto values = read_column(file, name, count);
    for (std::size_t i = 0; i < count; ++i) summary.rows[i].result.metrics[info.metric] = values[i];
  }
  summary.inputs = read_inputs(file, "/scenarios/input", summary.rows);
  summary.digests = file.read_unsigned("/scenarios/digest");
  require_length("/scenarios/digest", summary.digests.size(), count);
}

// Rows of a search know their places again.
void read_places(const Hdf5File& file, std::vector<ScenarioRow>& rows) {
  if (!file.exists(kPlaceColumns.front().first)) return;
  for (ScenarioRow& row : rows) row.place.emplace();
  for (const auto& [name, field] : kPlaceColumns) {
    const auto values = read_integer_column(file, name, rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) (*rows[i].place).*field = static_cast<std::uint64_t>(values[i]);
  }
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
  table.inputs = read_inputs(file, "/window", table.rows);
  return table;
}

TraceSignal read_signal(const Hdf5File& file, const std::string& name) {
  const std::string full_name = joined({"/trace/", name});
  TraceSignal signal;
  signal.name = name;
  signal.units = file.text_attribute(full_name, "units").value_or("");
  signal.long_name = file.text_attribute(full_name, "long_name").value_or("");
  const auto extents = file.extents(full_name);
  for (std::size_t axis = 1; axis < extents.size(); ++axis)
    signal.extents.push_back(static_cast<int>(extents[axis]));
  signal.dimensions = file.dimension_names(full_name);
  if (!signal.dimensions.empty()) signal.dimensions.erase(signal.dimensions.begin());
  signal.values = file.read_doubles(full_name);
  return signal;
}

// Datasets of /trace that run over time and are not the motion itself.
std::vector<std::string> signal_names(const Hdf5File& file) {
  const auto is_motion = [](const std::string& name) {
    return name == "displacement_m" || name == "velocity_m_s" || name == "acceleration_m_s2" || name == "time_s";
  };
  std::vector<std::string> names;
  for (const std::string& name : file.datasets("/trace")) {
    const auto dimensions = file.dimension_names(joined({"/trace/", name}));
    if (!is_motion(name) && !dimensions.empty() && dimensions.front() == "time_s") names.push_back(name);
  }
  return names;
}

// Every time has a value per freedom, and per element of every signal.
void require_whole(const Trace& trace) {
  const std::size_t times = trace.time_s.size();
  const std::size_t freedoms = 3 * static_cast<std::size_t>(trace.particle_count);
  require_length("/trace/rest_position_m", trace.rest_position_m.size(), freedoms);
  require_length("/trace/displacement_m", trace.displacement_m.size(), times * freedoms);
  require_length("/trace/velocity_m_s", trace.velocity_m_s.size(), times * freedoms);
  require_length("/trace/acceleration_m_s2", trace.acceleration_m_s2.size(), times * freedoms);
  for (const TraceSignal& signal : trace.signals) {
    std::size_t width = 1;
    for (const int extent : signal.extents) width *= static_cast<std::size_t>(extent);
    require_length(joined({"/trace/", signal.name}), signal.values.size(), times * width);
  }
}

std::vector<ContactEvent> read_events(const Hdf5File& file) {
  const auto times = file.read_doubles("/contact_events/time_s");
  const auto nodes = read_integer_column(file, "/contact_events/node", times.size());
  const auto surfaces = read_integer_column(file, "/contact_events/surface", times.size());
  const auto kinds = read_integer_column(file, "/contact_events/kind", times.size());
  std::vector<ContactEvent> events(times.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (kinds[i] < 0 || kinds[i] > static_cast<std::int64_t>(ContactEvent::Kind::slip)) {
      throw Hdf5Failure(joined({"/contact_events/kind holds the unknown kind ", std::to_string(kinds[i])}));
    }
    events[i] = {times[i], static_cast<int>(nodes[i]), static_cast<int>(surfaces[i]),
                 static_cast<ContactEvent::Kind>(kinds[i])};
  }
  return events;
}

}  // namespace

Expected<ResultsSummary> read_results_summary(const fs::path& path) {
  const Hdf5Silence silence;
  auto file = open_results(path);
  if (!file) return file.error();
  try {
    ResultsSummary summary;
    summary.format_version = static_cast<int>(*file->integer_attribute("/", "format_version"));
    summary.meta = read_meta(*file);
    read_scenarios(*file, summary);
    read_places(*file, summary.rows);
    summary.tables = read_tables(*file);
    if (file->exists("/window")) summary.window = read_window(*file);
    summary.has_trace = file->exists("/trace");
    if (summary.has_trace) summary.trace_signals = signal_names(*file);
    return summary;
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
    Trace trace;
    trace.rest_position_m = file->read_doubles("/trace/rest_position_m");
    trace.particle_count = static_cast<int>(trace.rest_position_m.size() / 3);
    trace.time_s = file->read_doubles("/trace/time_s");
    trace.displacement_m = file->read_doubles("/trace/displacement_m");
    trace.velocity_m_s = file->read_doubles("/trace/velocity_m_s");
    trace.acceleration_m_s2 = file->read_doubles("/trace/acceleration_m_s2");
    for (const std::string& name : signal_names(*file)) trace.signals.push_back(read_signal(*file, name));
    trace.events = read_events(*file);
    require_whole(trace);
    return trace;
  } catch (const std::exception& failure) {
    return damaged(path, failure.what());
  }
}

}  // namespace unbruised::studies
