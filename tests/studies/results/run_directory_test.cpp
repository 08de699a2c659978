#include "studies/results/run_directory.hpp"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "studies/results/durable_files.hpp"
#include "studies/results/results_file.hpp"
#include "tests/studies/results/sample_rows.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

const std::string kConfig =
    "[study]\nname = \"window\"\nkind = \"sweep\"\n[strategy]\napproach_speed_m_s = 0.05\ngrip_force_N = 1.0\n";
const std::string kOtherConfig =
    "[study]\nname = \"window\"\nkind = \"sweep\"\n[strategy]\napproach_speed_m_s = 0.07\ngrip_force_N = 1.0\n";
constexpr std::uint64_t kScenarios = 40;

RunDirectory::Request request_in(const TemporaryDirectory& parent) {
  return {parent.path() / "window", kConfig, "0.1.0 GNU 12.2.0 avx512f", false};
}

ResultsContent meta_only() {
  ResultsContent content;
  content.meta.unbruised_version = "0.1.0";
  content.meta.study_name = "window";
  content.meta.study_kind = "sweep";
  content.inputs = {{"strategy.grip_force_N", "N", ""}, {"product.use", "", ""}};
  return content;
}

void append_missing(RunDirectory& run, std::uint64_t limit) {
  for (std::uint64_t id = 0; id < limit; ++id) {
    if (run.is_done(id)) continue;
    ASSERT_EQ(message_of(run.append(sample_row(id))), "");
  }
}

std::string finish_and_digest(RunDirectory& run) {
  const auto error = run.finish(meta_only());
  EXPECT_FALSE(error) << error->message;
  return read_results_summary(run.results_path())->digest();
}

std::string uninterrupted_digest() {
  const TemporaryDirectory parent;
  auto run = RunDirectory::open(request_in(parent));
  append_missing(**run, kScenarios);
  return finish_and_digest(**run);
}

bool any_note_has(const std::vector<std::string>& notes, const std::string& words) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

// Runs `body` in a child process that ends by SIGKILL, as a killed program would.
template <class Body>
void in_killed_process(Body body) {
  const pid_t child = ::fork();
  if (child == 0) {
    body();
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

std::vector<std::uint64_t> ids_of(const StudyRows& rows) {
  std::vector<std::uint64_t> ids;
  for (const ScenarioRow& row : rows) ids.push_back(row.id);
  return ids;
}

TEST(RunDirectory, BeginsWithItsConfigAndEndsWithResults) {
  const TemporaryDirectory parent;
  auto run = RunDirectory::open(request_in(parent));
  ASSERT_TRUE(run) << run.error().message;
  EXPECT_FALSE((*run)->continued());
  append_missing(**run, kScenarios);
  finish_and_digest(**run);
  const auto summary = read_results_summary((*run)->results_path());
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->rows.size(), kScenarios);
  EXPECT_EQ(summary->meta.config_toml, kConfig);
  EXPECT_EQ(*read_text_file((*run)->directory() / "config.toml"), kConfig);
}

TEST(RunDirectory, ContinuesAKilledRunAndEndsWithTheSameDigest) {
  const std::string expected = uninterrupted_digest();
  for (const std::uint64_t done : {1, 17, 33, 40}) {
    const TemporaryDirectory parent;
    in_killed_process([&] {
      auto killed = RunDirectory::open(request_in(parent));
      append_missing(**killed, done);
    });
    auto run = RunDirectory::open(request_in(parent));
    ASSERT_TRUE(run) << run.error().message;
    EXPECT_TRUE((*run)->continued());
    EXPECT_EQ((*run)->rows().size(), done);
    append_missing(**run, kScenarios);
    EXPECT_EQ(finish_and_digest(**run), expected) << done;
    EXPECT_TRUE(verify_run_directory((*run)->directory())->damage.empty());
  }
}

TEST(RunDirectory, ContinuesBehindATornRecordAndSaysSo) {
  const TemporaryDirectory parent;
  in_killed_process([&] {
    auto killed = RunDirectory::open(request_in(parent));
    append_missing(**killed, 5);
  });
  const fs::path journal = fs::directory_iterator(parent.path() / "window" / "journal")->path();
  fs::resize_file(journal, fs::file_size(journal) - 9);
  auto run = RunDirectory::open(request_in(parent));
  ASSERT_TRUE(run);
  EXPECT_EQ(ids_of((*run)->rows()), (std::vector<std::uint64_t>{0, 1, 2, 3}));
  EXPECT_TRUE(any_note_has((*run)->notes(), "unfinished record"));
  append_missing(**run, kScenarios);
  EXPECT_EQ(finish_and_digest(**run), uninterrupted_digest());
}

TEST(RunDirectory, ContinuesAnInterruptedStudyWhoseResultsWereWrittenIncomplete) {
  const TemporaryDirectory parent;
  {
    auto run = RunDirectory::open(request_in(parent));
    append_missing(**run, 10);
    ResultsContent content = meta_only();
    content.meta.complete = false;
    for (std::uint64_t id = 0; id < kScenarios; ++id) {
      ScenarioRow row = sample_row(id);
      row.result = ScenarioResult{};
      content.rows.push_back(std::move(row));
    }
    ASSERT_EQ(message_of((*run)->finish(content)), "");
    const auto partial = read_results_summary((*run)->results_path());
    EXPECT_EQ(partial->rows.size(), kScenarios);
    EXPECT_EQ(partial->rows_run, 10U);
  }
  auto run = RunDirectory::open(request_in(parent));
  ASSERT_TRUE(run) << run.error().message;
  EXPECT_EQ((*run)->rows().size(), 10U);
  append_missing(**run, kScenarios);
  EXPECT_TRUE(verify_run_directory((*run)->directory())->damage.empty());  // results.h5 is only older
  EXPECT_EQ(finish_and_digest(**run), uninterrupted_digest());
}

TEST(RunDirectory, RefusesASecondProcessAndNamesTheHolder) {
  const TemporaryDirectory parent;
  auto holder = RunDirectory::open(request_in(parent));
  ASSERT_TRUE(holder);
  const auto second = RunDirectory::open(request_in(parent));
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().kind, ResultsErrorKind::busy);
  EXPECT_EQ(exit_status(second.error().kind), 4);
  EXPECT_NE(second.error().message.find("pid = " + std::to_string(::getpid())), std::string::npos)
      << second.error().message;
  auto fresh = request_in(parent);
  fresh.fresh = true;  // does not pull the directory away from under a running process either
  EXPECT_EQ(RunDirectory::open(fresh).error().kind, ResultsErrorKind::busy);
}

TEST(RunDirectory, IsFreeAfterItsHolderWasKilled) {
  const TemporaryDirectory parent;
  in_killed_process([&] {
    auto killed = RunDirectory::open(request_in(parent));
    append_missing(**killed, 1);
  });
  EXPECT_TRUE(RunDirectory::open(request_in(parent)));
}

TEST(RunDirectory, RefusesAFinishedStudy) {
  const TemporaryDirectory parent;
  {
    auto run = RunDirectory::open(request_in(parent));
    append_missing(**run, kScenarios);
    finish_and_digest(**run);
  }
  const auto again = RunDirectory::open(request_in(parent));
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().kind, ResultsErrorKind::finished);
}

TEST(RunDirectory, RefusesAnotherConfigNamingTheKeysThatDiffer) {
  const TemporaryDirectory parent;
  { ASSERT_TRUE(RunDirectory::open(request_in(parent))); }
  auto other = request_in(parent);
  other.config_toml = kOtherConfig;
  const auto refused = RunDirectory::open(other);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ResultsErrorKind::other_config);
  EXPECT_EQ(refused.error().keys, (std::vector<std::string>{"strategy.approach_speed_m_s"}));
  EXPECT_NE(refused.error().message.find("strategy.approach_speed_m_s"), std::string::npos);
}

TEST(RunDirectory, FreshMovesTheOldOneAsideEveryTime) {
  const TemporaryDirectory parent;
  auto request = request_in(parent);
  {
    auto run = RunDirectory::open(request);
    append_missing(**run, 3);
  }
  request.fresh = true;
  request.config_toml = kOtherConfig;
  for (int time = 1; time <= 2; ++time) {
    auto run = RunDirectory::open(request);
    ASSERT_TRUE(run) << run.error().message;
    EXPECT_FALSE((*run)->continued());
    EXPECT_TRUE((*run)->rows().empty());
    EXPECT_TRUE(any_note_has((*run)->notes(), "window.old-" + std::to_string(time)));
  }
  EXPECT_EQ(verify_run_directory(parent.path() / "window.old-1")->journal_rows, 3U);
  EXPECT_TRUE(fs::exists(parent.path() / "window.old-2" / "config.toml"));
}

TEST(RunDirectory, FreshBehindALinkMovesWhatItPointsToAndStaysBehindIt) {
  const TemporaryDirectory parent;
  fs::create_directories(parent.path() / "disk" / "runs");
  fs::create_directory_symlink(parent.path() / "disk" / "runs", parent.path() / "window");
  { ASSERT_TRUE(RunDirectory::open(request_in(parent))); }
  auto request = request_in(parent);
  request.fresh = true;
  const auto run = RunDirectory::open(request);
  ASSERT_TRUE(run) << run.error().message;
  EXPECT_TRUE(fs::is_symlink(parent.path() / "window"));
  EXPECT_TRUE(fs::exists(parent.path() / "disk" / "runs" / "config.toml"));
  EXPECT_TRUE(fs::exists(parent.path() / "disk" / "runs.old-1" / "config.toml"));
}

TEST(RunDirectory, GoesOnUnderItsOldConfigWhenOnlyTheDescriptionChanged) {
  const TemporaryDirectory parent;
  auto request = request_in(parent);
  request.config_toml = "[study]\ndescription = \"before\"\n" + kConfig.substr(kConfig.find("name"));
  {
    auto run = RunDirectory::open(request);
    ASSERT_TRUE(run);
    append_missing(**run, kScenarios / 2);
  }
  auto changed = request;
  changed.config_toml.replace(changed.config_toml.find("before"), 6, "after");
  auto run = RunDirectory::open(changed);
  ASSERT_TRUE(run) << run.error().message;
  EXPECT_TRUE(any_note_has((*run)->notes(), "study.description"));
  EXPECT_EQ((*run)->rows().size(), kScenarios / 2);
  append_missing(**run, kScenarios);
  EXPECT_EQ(finish_and_digest(**run), uninterrupted_digest());
  EXPECT_EQ(read_results_summary((*run)->results_path())->meta.config_toml, request.config_toml);
  EXPECT_TRUE(verify_run_directory((*run)->directory())->damage.empty());
}

TEST(RunDirectory, TouchesNoDirectoryThatIsNotOne) {
  const TemporaryDirectory parent;
  fs::create_directories(parent.path() / "window");
  std::ofstream(parent.path() / "window" / "thesis.tex") << "years of work";
  const auto refused = RunDirectory::open(request_in(parent));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ResultsErrorKind::foreign);
  EXPECT_NE(refused.error().message.find("thesis.tex"), std::string::npos);
}

TEST(RunDirectory, StartsBesideASingleScenarioFile) {
  const TemporaryDirectory parent;
  fs::create_directories(parent.path() / "window");
  std::ofstream(parent.path() / "window" / "scenario_12.h5") << "x";
  EXPECT_TRUE(RunDirectory::open(request_in(parent)));
}

TEST(RunDirectory, RefusesTheSameScenarioTwice) {
  const TemporaryDirectory parent;
  auto run = RunDirectory::open(request_in(parent));
  ASSERT_EQ(message_of((*run)->append(sample_row(2))), "");
  EXPECT_TRUE((*run)->append(sample_row(2)));
}

TEST(RunDirectory, RefusesToContinueWhatAnotherBuildBeganUnlessFresh) {
  const TemporaryDirectory parent;
  {
    auto run = RunDirectory::open(request_in(parent));
    append_missing(**run, 1);
  }
  auto request = request_in(parent);
  request.build = "0.2.0 GNU 13.1.0 avx2";
  {
    const auto refused = RunDirectory::open(request);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ResultsErrorKind::other_build);
    EXPECT_EQ(exit_status(refused.error().kind), 2);
    for (const char* words : {"0.1.0 GNU 12.2.0 avx512f", "0.2.0 GNU 13.1.0 avx2", "--fresh"}) {
      EXPECT_NE(refused.error().message.find(words), std::string::npos) << refused.error().message;
    }
  }
  EXPECT_TRUE(RunDirectory::open(request_in(parent)));  // the build that began it goes on
  request.fresh = true;
  EXPECT_TRUE(RunDirectory::open(request));
}

TEST(RunDirectory, IsCompactedWhileItRunsWithoutBecomingFinished) {
  const TemporaryDirectory parent;
  {
    auto run = RunDirectory::open(request_in(parent));
    for (const std::uint64_t done : {5, 20}) {
      append_missing(**run, done);
      ResultsContent content = meta_only();
      content.meta.complete = false;
      ASSERT_EQ(message_of((*run)->finish(content)), "");
      EXPECT_EQ((*run)->acknowledged(), done);  // results.h5 knows nothing that a power loss could take
      EXPECT_EQ(read_results_summary((*run)->results_path())->rows.size(), done);
    }
  }
  auto run = RunDirectory::open(request_in(parent));
  ASSERT_TRUE(run) << run.error().message;
  append_missing(**run, kScenarios);
  EXPECT_EQ(finish_and_digest(**run), uninterrupted_digest());
}

TEST(RunDirectory, IsCompactedByAnotherProcessOnlyWhenNobodyHoldsIt) {
  const TemporaryDirectory parent;
  {
    auto run = RunDirectory::open(request_in(parent));
    append_missing(**run, 7);
    const auto refused = RunDirectory::open_for_compaction((*run)->directory());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ResultsErrorKind::busy);
  }
  auto run = RunDirectory::open_for_compaction(parent.path() / "window");
  ASSERT_TRUE(run) << run.error().message;
  EXPECT_EQ((*run)->rows().size(), 7U);
}

TEST(RunDirectory, WaitsForACompactionInsteadOfGivingUp) {
  const TemporaryDirectory parent;
  { ASSERT_TRUE(RunDirectory::open(request_in(parent))); }
  auto compaction = RunDirectory::open_for_compaction(parent.path() / "window");
  ASSERT_TRUE(compaction);
  std::jthread ends_soon([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    compaction->reset();
  });
  const auto run = RunDirectory::open(request_in(parent));
  EXPECT_TRUE(run) << run.error().message;
}

TEST(Verify, FindsAFlippedBitAnywhereInResultsOrJournal) {
  const TemporaryDirectory parent;
  {
    auto run = RunDirectory::open(request_in(parent));
    append_missing(**run, 10);
    finish_and_digest(**run);
  }
  const fs::path directory = parent.path() / "window";
  EXPECT_TRUE(verify_run_directory(directory)->damage.empty());
  const fs::path journal = fs::directory_iterator(directory / "journal")->path();
  for (const fs::path& path : {directory / "results.h5", journal}) {
    for (std::uintmax_t at = 60; at + 1 < fs::file_size(path); at += fs::file_size(path) / 37) {
      std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
      const auto flip = [&] {
        file.seekg(static_cast<std::streamoff>(at));
        const char byte = static_cast<char>(file.get() ^ 4);
        file.seekp(static_cast<std::streamoff>(at));
        file.put(byte);
        file.flush();
      };
      flip();
      EXPECT_FALSE(verify_run_directory(directory)->damage.empty()) << path << " at " << at;
      flip();
    }
  }
  EXPECT_TRUE(verify_run_directory(directory)->damage.empty());
}

}  // namespace
}  // namespace unbruised::studies
