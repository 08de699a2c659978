#include "studies/results/suspect_results.hpp"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "studies/results/results_file.hpp"
#include "tests/studies/results/sample_rows.hpp"

namespace unbruised::studies {
namespace {

ResultsContent whole_content(const WindowTable& window, const Trace& trace) {
  ResultsContent content;
  content.meta.unbruised_version = "0.1.0";
  content.meta.config_toml = "[study]\n";
  content.meta.study_name = "all";
  content.meta.complete = false;
  content.inputs = {{"strategy.grip_force_N", "N", "force"}, {"product.use", "", ""}};
  for (std::uint64_t id = 0; id < 5; ++id) content.rows.push_back(sample_row(id));
  for (ScenarioRow& row : content.rows) row.place = SearchPlace{1, row.id, 2};
  content.tables = {{.name = "best",
                     .row = "candidate",
                     .columns = {{"value", "1", "a value", std::vector<double>{1.5, kAbsent}},
                                 {"word", "", "", std::vector<std::string>{"a", ""}}},
                     .attributes = {{"objective", "cycle_time_s"}, {"count", 2.0}}}};
  content.window = &window;
  content.trace = &trace;
  return content;
}

/// Everything of a summary that people see, as one text.
std::string text_of(const ResultsSummary& summary) {
  std::string text = summary.meta.study_name + summary.meta.config_toml + summary.meta.config_sha256 +
                     (summary.meta.complete ? "complete" : "not complete") + summary.digest();
  for (const ColumnInfo& column : summary.inputs) text += column.key + column.units + column.long_name;
  for (const ScenarioRow& row : summary.rows) {
    text += std::to_string(row.id) + row.result.cause + std::to_string(journal_id(row));
    for (const InputValue& input : row.inputs) {
      text += std::holds_alternative<double>(input) ? std::to_string(std::get<double>(input))
                                                    : std::get<std::string>(input);
    }
  }
  for (const ResultTable& table : summary.tables) {
    text +=
        table.name + table.row + std::to_string(table.columns.size()) + std::to_string(table.attributes.size());
  }
  for (const WindowRow& row : summary.window->rows) text += row.note + std::to_string(row.hold_force_N);
  for (const std::string& signal : summary.trace_signals) text += signal;
  return text;
}

TEST(SuspectResults, ReadTheSameAsInTheSameProcess) {
  const TemporaryDirectory parent;
  const std::filesystem::path path = parent.path() / "results.h5";
  WindowTable window;
  window.rows = {{.inputs = {}, .hold_force_N = 0.8, .note = "a note"}, {}};
  Trace trace;
  trace.particle_count = 1;
  trace.time_s = {0.0, 0.1};
  trace.rest_position_m = {1.0, 2.0, 3.0};
  trace.displacement_m = trace.velocity_m_s = trace.acceleration_m_s2 = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  trace.signals = {{"force_N", "N", "force", {"finger"}, {2}, {1.0, 2.0, 3.0, 4.0}}};
  trace.events = {{0.05, 7, 1, ContactEvent::Kind::slip}};
  ASSERT_EQ(message_of(write_results_file(path, whole_content(window, trace))), "");

  const auto here = read_results_summary(path);
  const auto there = read_suspect_summary(path);
  ASSERT_TRUE(here) << here.error().message;
  ASSERT_TRUE(there) << there.error().message;
  EXPECT_EQ(text_of(*there), text_of(*here));
  EXPECT_EQ(there->digests, here->digests);

  const auto read = read_suspect_trace(path);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->displacement_m, trace.displacement_m);
  EXPECT_EQ(read->signals.at(0).values, trace.signals[0].values);
  EXPECT_EQ(read->signals.at(0).extents, trace.signals[0].extents);
  EXPECT_EQ(read->events.at(0).node, 7);
}

TEST(SuspectResults, KeepTheKindOfTheError) {
  const TemporaryDirectory parent;
  EXPECT_EQ(read_suspect_summary(parent.path() / "none.h5").error().kind, ResultsErrorKind::io);
  std::ofstream(parent.path() / "text.h5") << "no HDF5";
  EXPECT_EQ(read_suspect_summary(parent.path() / "text.h5").error().kind, ResultsErrorKind::foreign);
}

TEST(SuspectResults, AWrongHashIsDamage) {
  const TemporaryDirectory parent;
  const std::filesystem::path path = parent.path() / "results.h5";
  ResultsContent content;
  content.meta.unbruised_version = "0.1.0";
  content.rows = {sample_row(0)};
  content.inputs = {{"strategy.grip_force_N", "N", ""}, {"product.use", "", ""}};
  ASSERT_EQ(message_of(write_results_file(path, content)), "");
  EXPECT_TRUE(read_hashed_summary(path));  // no hash: nothing to compare
  std::ofstream(parent.path() / "results.h5.sha256") << std::string(64, '0') << "  results.h5\n";
  const auto refused = read_hashed_summary(path);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ResultsErrorKind::damaged);
}

}  // namespace
}  // namespace unbruised::studies
