#include "studies/results/results_file.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "studies/results/checksum.hpp"
#include "studies/results/digest.hpp"
#include "studies/results/root_texts.hpp"
#include "tests/places.hpp"
#include "tests/studies/results/sample_rows.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

ResultsContent sample_content(std::uint64_t rows) {
  ResultsContent content;
  content.meta.unbruised_version = "0.1.0";
  content.meta.config_toml = "[study]\nname = \"sample\"\n" + std::string(100000, '#') + "\n";
  content.meta.study_name = "sample";
  content.meta.study_kind = "sweep";
  content.meta.created_utc = "2026-01-01T00:00:00Z";
  content.meta.instruction_set = "avx512f";
  content.meta.compiler = "GNU 12.2.0";
  content.meta.warnings = {"the step is too long", "die Birne ist zu weich: grün"};
  content.inputs = {{"strategy.grip_force_N", "N", "drive force limit"}, {"product.use", "", ""}};
  content.rows = sample_rows(rows);
  return content;
}

WindowTable sample_window() {
  WindowTable table;
  table.inputs = {{"strategy.approach_speed_m_s", "m s-1", ""}, {"product.use", "", ""}};
  table.rows.resize(2);
  table.rows[0].inputs = {0.05, std::string("a.toml")};
  table.rows[0].hold_force_N = 0.75;
  table.rows[0].damage_force_N = 1.5;
  table.rows[0].margin = 1.0;
  table.rows[0].exists = true;
  table.rows[0].hold_bracket_low_N = 0.7;
  table.rows[1].inputs = {0.5, std::string("b.toml")};
  table.rows[1].note = "no window at this speed: the impact alone damages";
  return table;
}

Trace sample_trace(std::size_t times, int particles) {
  Trace trace;
  trace.particle_count = particles;
  const auto count = static_cast<std::size_t>(particles) * 3;
  for (std::size_t i = 0; i < count; ++i) trace.rest_position_m.push_back(0.01 * static_cast<double>(i));
  for (std::size_t t = 0; t < times; ++t) trace.time_s.push_back(1e-3 * static_cast<double>(t));
  for (std::size_t i = 0; i < times * count; ++i) {
    trace.displacement_m.push_back(1e-6 * static_cast<double>(i));
    trace.velocity_m_s.push_back(2e-6 * static_cast<double>(i));
    trace.acceleration_m_s2.push_back(3e-6 * static_cast<double>(i));
  }
  trace.signals = {
      {"finger_force_N", "N", "force on the product", {"finger", "component"}, {2, 3}, {}},
      {"support_force_N", "N", "force on the product", {"component"}, {3}, {}},
      {"compression_m", "m", "approach of the pads", {}, {}, {}},
      {"odd", "1", "a dimension name with a second extent", {"component"}, {6}, {}},
  };
  for (TraceSignal& signal : trace.signals) {
    std::size_t size = times;
    for (const int extent : signal.extents) size *= static_cast<std::size_t>(extent);
    for (std::size_t i = 0; i < size; ++i) signal.values.push_back(static_cast<double>(i));
  }
  trace.events = {{0.0105, 7, 0, ContactEvent::Kind::make},
                  {0.02, 8, 1, ContactEvent::Kind::slip, 31, {0.1, 0.2, 0.3}, {1.0, -2.0, 3.0}}};
  return trace;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(fs::file_size(path), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

void put_bytes(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

// Exit status of /usr/bin/python3 with these arguments; the paths are ours and hold no blanks.
int run_python(const std::string& arguments) {
  const int status = std::system(("/usr/bin/python3 -B " UNBRUISED_SOURCE_DIR "/" + arguments).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int run_python_check(const fs::path& path, std::size_t rows) {
  return run_python("tests/studies/results/check_results_file.py " + path.string() + " " + std::to_string(rows));
}

TEST(ResultsFile, ReadsBackItsWarningsAlsoWhereThereAreNone) {
  const TemporaryDirectory directory;
  const fs::path path = directory.path() / "results.h5";
  ResultsContent content = sample_content(1);
  for (const std::vector<std::string>& warnings :
       {std::vector<std::string>{},
        std::vector<std::string>{"The step is too long.", "Damage was not looked at."}}) {
    content.meta.warnings = warnings;
    ASSERT_EQ(message_of(write_results_file(path, content)), "");
    const auto summary = read_results_summary(path);
    ASSERT_TRUE(summary) << summary.error().message;
    EXPECT_EQ(summary->meta.warnings, warnings);
  }
}

TEST(ResultsFile, ReadsBackEveryTextOfItsRootAlsoAnEmptyOne) {
  const TemporaryDirectory directory;
  const fs::path path = directory.path() / "results.h5";
  ResultsContent content = sample_content(1);
  for (const RootText& root : kRootTexts) content.meta.*root.text = std::string("text of ") + root.attribute;
  content.meta.damage_note.clear();
  ASSERT_EQ(message_of(write_results_file(path, content)), "");
  const auto summary = read_results_summary(path);
  ASSERT_TRUE(summary) << summary.error().message;
  for (const RootText& root : kRootTexts)
    EXPECT_EQ(summary->meta.*root.text, content.meta.*root.text) << root.attribute;
}

TEST(ResultsFile, ReadsBackWhatWasWritten) {
  const TemporaryDirectory directory;
  const fs::path path = directory.path() / "results.h5";
  ResultsContent content = sample_content(23);
  const WindowTable window = sample_window();
  content.window = &window;
  ASSERT_EQ(message_of(write_results_file(path, content)), "");
  const auto summary = read_results_summary(path);
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_EQ(summary->meta.config_toml, content.meta.config_toml);
  EXPECT_EQ(summary->meta.config_sha256, sha256_hex(content.meta.config_toml));
  EXPECT_EQ(summary->meta.compiler, "GNU 12.2.0");
  EXPECT_EQ(summary->meta.warnings, content.meta.warnings);
  EXPECT_TRUE(summary->meta.complete);
  ASSERT_EQ(summary->inputs.size(), 2U);
  EXPECT_EQ(summary->inputs[0].key, "strategy.grip_force_N");  // the study's order, not the alphabet's
  EXPECT_EQ(summary->inputs[0].units, "N");
  ASSERT_EQ(summary->rows.size(), 23U);
  for (std::size_t i = 0; i < 23; ++i) {
    EXPECT_EQ(summary->rows[i].id, i);
    EXPECT_EQ(result_digest(summary->rows[i].result), result_digest(content.rows[i].result));
    EXPECT_EQ(summary->digests[i], result_digest(content.rows[i].result));
    EXPECT_EQ(summary->rows[i].result.cause, content.rows[i].result.cause);
    EXPECT_EQ(summary->rows[i].inputs, content.rows[i].inputs);
  }
  ASSERT_TRUE(summary->window);
  ASSERT_EQ(summary->window->rows.size(), 2U);
  EXPECT_EQ(summary->window->inputs[1].key, "product.use");
  EXPECT_EQ(summary->window->rows[0].hold_bracket_low_N, 0.7);
  EXPECT_TRUE(summary->window->rows[0].exists);
  EXPECT_TRUE(std::isnan(summary->window->rows[1].hold_force_N));
  EXPECT_EQ(summary->window->rows[1].note, window.rows[1].note);
  EXPECT_EQ(summary->window->rows[1].inputs, window.rows[1].inputs);
}

TEST(ResultsFile, HasTheSameBytesInWhateverOrderRowsArrived) {
  const TemporaryDirectory directory;
  ResultsContent content = sample_content(40);
  ASSERT_EQ(message_of(write_results_file(directory.path() / "a.h5", content)), "");
  std::reverse(content.rows.begin(), content.rows.end());
  ASSERT_EQ(message_of(write_results_file(directory.path() / "b.h5", content)), "");
  EXPECT_TRUE(bytes_of(directory.path() / "a.h5") == bytes_of(directory.path() / "b.h5"));
}

TEST(ResultsFile, OpensInH5pyAndXarrayWithNamedDimensionsAndUnits) {
  const TemporaryDirectory directory;
  const fs::path path = directory.path() / "results.h5";
  ResultsContent content = sample_content(23);
  const WindowTable window = sample_window();
  const Trace trace = sample_trace(5, 4);
  content.window = &window;
  content.trace = &trace;
  ASSERT_EQ(message_of(write_results_file(path, content)), "");
  EXPECT_EQ(run_python_check(path, 23), 0);
}

TEST(PlotWindow, DrawsSweepsAndWindowsOverTheGripForceAndRefusesAnythingElse) {
  const TemporaryDirectory directory;
  const fs::path path = directory.path() / "sweep.h5";
  ResultsContent content = sample_content(23);
  const WindowTable window = sample_window();
  content.window = &window;
  content.tables.push_back({.name = "set_points",
                            .row = "strategy_number",
                            .columns = {{"exists", "1", "", std::vector<double>{1.0}}},
                            .attributes = {{"answer", std::string("set 2 N, may be off by 1 N either way")}}});
  content.inputs[1].key = "product.label";  // texts alternate: two panels
  const auto plotted = [&](const std::string& kind) {
    content.meta.study_kind = kind;
    EXPECT_EQ(message_of(write_results_file(path, content)), "");
    return run_python("scripts/plot_window.py " + path.string() + " > /dev/null 2> /dev/null");
  };
  EXPECT_EQ(plotted("sweep"), 0);
  EXPECT_EQ(bytes_of(directory.path() / "sweep.png").substr(1, 3), "PNG");
  EXPECT_EQ(plotted("window"), 0);
  for (const std::string kind : {"robust", "pareto", "sample"}) EXPECT_EQ(plotted(kind), 2) << kind;
  content.window = nullptr;
  EXPECT_EQ(plotted("sweep"), 2);

  put_bytes(path, "not HDF5");
  EXPECT_EQ(run_python("scripts/plot_window.py " + path.string() + " 2> /dev/null"), 2);
}

TEST(ResultsFile, GivesATraceBack) {
  const TemporaryDirectory directory;
  const fs::path path = directory.path() / "scenario_3.h5";
  ResultsContent content = sample_content(1);
  const Trace trace = sample_trace(101, 60);  // 101 x 180 doubles: more than one chunk
  content.trace = &trace;
  ASSERT_EQ(message_of(write_results_file(path, content)), "");
  const auto back = read_trace(path);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->particle_count, 60);
  EXPECT_EQ(back->displacement_m, trace.displacement_m);
  EXPECT_EQ(back->acceleration_m_s2, trace.acceleration_m_s2);
  ASSERT_EQ(back->signals.size(), 4U);  // alphabetical
  EXPECT_EQ(back->signals[1].name, "finger_force_N");
  EXPECT_EQ(back->signals[1].dimensions, (std::vector<std::string>{"finger", "component"}));
  EXPECT_EQ(back->signals[1].extents, (std::vector<int>{2, 3}));
  EXPECT_EQ(back->signals[1].values, trace.signals[0].values);
  EXPECT_EQ(back->signals[2].dimensions, (std::vector<std::string>{"component_6"}));
  ASSERT_EQ(back->events.size(), 2U);
  EXPECT_EQ(back->events[1].kind, ContactEvent::Kind::slip);
  EXPECT_EQ(back->events[1].node, 8);
  EXPECT_EQ(back->events[1].contact, 31);
  EXPECT_EQ(back->events[1].place_m, (std::array{0.1, 0.2, 0.3}));
  EXPECT_EQ(back->events[1].force_N, (std::array{1.0, -2.0, 3.0}));
}

TEST(ResultsFile, TakesEmptyTables) {
  const TemporaryDirectory directory;
  const fs::path path = directory.path() / "results.h5";
  ResultsContent content = sample_content(0);
  const WindowTable window{{{"strategy.speed_m_s", "m s-1", ""}}, {}};
  const Trace trace = sample_trace(0, 0);
  content.window = &window;
  content.trace = &trace;
  ASSERT_EQ(message_of(write_results_file(path, content)), "");
  const auto summary = read_results_summary(path);
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_TRUE(summary->rows.empty());
  EXPECT_TRUE(summary->window->rows.empty());
  EXPECT_TRUE(read_trace(path));
}

TEST(ResultsFile, RefusesATraceWhoseArraysDoNotFit) {
  const TemporaryDirectory directory;
  ResultsContent content = sample_content(1);
  Trace trace = sample_trace(5, 4);
  trace.velocity_m_s.pop_back();
  content.trace = &trace;
  const auto error = write_results_file(directory.path() / "t.h5", content);
  ASSERT_TRUE(error);
  EXPECT_NE(error->message.find("velocity_m_s"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(directory.path()));  // neither the file nor its .tmp stays
}

TEST(ResultsFile, LeavesTheOldFileWhenTheNewOneCannotBeWritten) {
  const TemporaryDirectory directory;
  const fs::path path = directory.path() / "results.h5";
  ASSERT_EQ(message_of(write_results_file(path, sample_content(3))), "");
  fs::create_directory(directory.path() / "results.h5.tmp");  // nothing can be created under that name
  const auto error = write_results_file(path, sample_content(4));
  ASSERT_TRUE(error);
  EXPECT_EQ(error->kind, ResultsErrorKind::io);
  EXPECT_NE(error->message.find("results.h5.tmp"), std::string::npos);
  EXPECT_EQ(read_results_summary(path)->rows.size(), 3U);
}

TEST(ResultsFile, SaysWhatIsWrongWithForeignFiles) {
  const TemporaryDirectory directory;
  const fs::path text = directory.path() / "notes.txt";
  put_bytes(text, "no results here");
  EXPECT_EQ(read_results_summary(text).error().kind, ResultsErrorKind::foreign);
  EXPECT_EQ(read_results_summary(directory.path()).error().kind, ResultsErrorKind::foreign);
  const auto missing = read_results_summary(directory.path() / "none.h5");
  EXPECT_EQ(missing.error().kind, ResultsErrorKind::io);
  EXPECT_NE(missing.error().message.find("none.h5"), std::string::npos);
}

TEST(ResultsFile, RefusesATruncatedFileAtAnyLength) {
  const TemporaryDirectory directory;
  const fs::path path = directory.path() / "results.h5";
  ASSERT_EQ(message_of(write_results_file(path, sample_content(10))), "");
  const std::string bytes = bytes_of(path);
  const fs::path cut = directory.path() / "cut.h5";
  for (std::size_t length = 0; length < bytes.size(); length += 997) {
    put_bytes(cut, bytes.substr(0, length));
    const auto summary = read_results_summary(cut);
    ASSERT_FALSE(summary) << length;
    ASSERT_NE(summary.error().message.find("cut.h5"), std::string::npos);
  }
}

TEST(ResultsFile, FindsAFlippedBitInAMetric) {
  const TemporaryDirectory directory;
  const fs::path path = directory.path() / "results.h5";
  ASSERT_EQ(message_of(write_results_file(path, sample_content(64))), "");
  std::string bytes = bytes_of(path);
  const double wanted = 12.0 + 0.06;  // metric 6 of scenario 12
  const std::size_t at = bytes.find(std::string(reinterpret_cast<const char*>(&wanted), sizeof wanted));
  ASSERT_NE(at, std::string::npos);
  bytes[at] = static_cast<char>(bytes[at] ^ 1);
  put_bytes(path, bytes);
  const auto summary = read_results_summary(path);
  ASSERT_FALSE(summary);
  EXPECT_EQ(summary.error().kind, ResultsErrorKind::damaged);
  EXPECT_NE(summary.error().message.find("peak_finger_force_N"), std::string::npos) << summary.error().message;
}

}  // namespace
}  // namespace unbruised::studies
