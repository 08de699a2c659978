// Rows that are not all in memory: from the journals into results.h5, and out of it again.

#include <algorithm>
#include <csignal>
#include <fstream>
#include <numeric>
#include <random>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "studies/results/checksum.hpp"
#include "studies/results/digest.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/journal_index.hpp"
#include "studies/results/results_file.hpp"
#include "studies/results/row_summary.hpp"
#include "studies/results/run_directory.hpp"
#include "studies/results/run_layout.hpp"
#include "studies/results/suspect_results.hpp"
#include "tests/studies/results/sample_rows.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

const std::string kConfig = "[study]\nname = \"window\"\nkind = \"sweep\"\n";
const std::uint64_t kPrefix = config_hash_prefix(sha256_hex(kConfig));

ResultsContent content_of(std::vector<ScenarioRow> rows) {
  ResultsContent content;
  content.meta.unbruised_version = "0.1.0";
  content.meta.config_toml = kConfig;
  content.meta.config_sha256 = sha256_hex(kConfig);
  content.inputs = {{"strategy.grip_force_N", "N", ""}, {"product.use", "", ""}};
  content.rows = std::move(rows);
  return content;
}

std::string record_of(const ScenarioRow& row, std::uint64_t prefix = kPrefix) {
  return encode_record({RecordKind::scenario, row.id, 0, encode_scenario_row(row)}, prefix);
}

void put(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

/// Journals with the ids of `order`, some thrice, one journal cut in a record, one with damage that takes nothing
/// which no other journal has, one with rows of another study.
void write_journals(const fs::path& directory, const std::vector<std::uint64_t>& order) {
  fs::create_directories(directory / "journal");
  put(directory / "config.toml", kConfig);
  std::string all[3];
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::string record = record_of(sample_row(order[i]));
    all[i % 3] += record;
    if (i % 7 == 0) all[(i + 1) % 3] += record;
    if (i == order.size() / 2) all[1] += record_of(sample_row(5), kPrefix + 1);
  }
  const std::string lost = record_of(sample_row(order.front()));
  all[2] = lost.substr(0, lost.size() / 2) + all[2];
  put(directory / "journal" / "a.jrnl", all[0]);
  put(directory / "journal" / "b.jrnl", all[1] + lost.substr(0, 50));
  put(directory / "journal" / "c.jrnl", all[2]);
}

std::vector<std::uint64_t> shuffled(std::uint64_t count) {
  std::vector<std::uint64_t> ids(count);
  std::iota(ids.begin(), ids.end(), 0U);
  std::shuffle(ids.begin(), ids.end(), std::mt19937_64(7));
  return ids;
}

std::string digest_in_memory(const std::vector<ScenarioRow>& rows) {
  std::vector<std::uint64_t> digests;
  for (const ScenarioRow& row : rows) digests.push_back(result_digest(row.result));
  return digest_text(digest_of_digests(digests));
}

void expect_rows(const StudyRows& found, const std::vector<ScenarioRow>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  std::size_t place = 0;
  for (const ScenarioRow& row : found) {
    ASSERT_EQ(row.id, expected[place].id);
    ASSERT_TRUE(same_row(row, expected[place])) << place;
    ++place;
  }
  EXPECT_EQ(place, expected.size());
}

// More than a block of rows, and none of its edges.
constexpr std::uint64_t kMany = 2 * kRowsAtATime + 1234;

TEST(Streaming, ResultsFromJournalsAreThoseOfRowsInMemoryByteForByte) {
  const TemporaryDirectory parent;
  write_journals(parent.path(), shuffled(kMany));
  auto run = RunDirectory::open_for_compaction(parent.path());
  ASSERT_TRUE(run) << run.error().message;
  ASSERT_EQ(message_of((*run)->finish(content_of({}))), "");
  const std::vector<ScenarioRow> rows = sample_rows(kMany);
  const auto image = results_image("memory", content_of(rows));
  ASSERT_TRUE(image) << image.error().message;
  const auto written = read_text_file((*run)->results_path());
  ASSERT_TRUE(written);
  EXPECT_TRUE(*written == *image);
  EXPECT_EQ(*read_text_file(hash_path((*run)->results_path())), hash_line(sha256_hex(*image)));
  EXPECT_EQ((*run)->rows().seen().digest, digest_in_memory(rows));
  EXPECT_TRUE(verify_run_directory(parent.path())->digest == digest_in_memory(rows));
}

TEST(Streaming, ScenariosNotRunStandBetweenThoseOfTheJournals) {
  const TemporaryDirectory parent;
  std::vector<std::uint64_t> some = shuffled(kMany);
  std::vector<ScenarioRow> others, expected = sample_rows(kMany);
  for (std::size_t i = kMany / 2; i < kMany; ++i) {
    ScenarioRow& row = expected[some[i]];
    row.result = {};
    others.push_back(row);
  }
  others.push_back(sample_row(some.front()));  // run meanwhile: the journal's counts
  others.back().result = {};
  some.resize(kMany / 2);
  write_journals(parent.path(), some);
  auto run = RunDirectory::open_for_compaction(parent.path());
  ASSERT_TRUE(run) << run.error().message;
  ASSERT_EQ(message_of((*run)->finish(content_of(others))), "");
  const auto summary = read_results_summary((*run)->results_path());
  ASSERT_TRUE(summary) << summary.error().message;
  expect_rows(summary->rows, expected);
  EXPECT_EQ(summary->rows_run, kMany / 2);
}

TEST(Streaming, JournalsSayWhatTheyAreBesideTheirRows) {
  const TemporaryDirectory parent;
  write_journals(parent.path(), shuffled(100));
  JournalIndex index;
  const auto a = index.add(parent.path() / "journal" / "a.jrnl", kPrefix);
  const auto b = index.add(parent.path() / "journal" / "b.jrnl", kPrefix);
  const auto c = index.add(parent.path() / "journal" / "c.jrnl", kPrefix);
  ASSERT_TRUE(a && b && c);
  EXPECT_EQ(a->rows + b->rows + c->rows, 115U);  // each seventh twice
  EXPECT_EQ(b->state.torn_tail_bytes, 50U);
  EXPECT_EQ(b->state.other_config_records, 1U);
  ASSERT_EQ(c->state.damage.size(), 1U);
  EXPECT_EQ(c->state.damage.front().offset, 0U);
  const auto twice = index.settle();
  ASSERT_TRUE(twice) << twice.error().message;
  EXPECT_TRUE(twice->empty());
  EXPECT_EQ(index.size(), 100U);
  expect_rows(index.rows(), sample_rows(100));
}

TEST(Streaming, OfTwoResultsTheFirstCountsAndTheOtherIsNamed) {
  const TemporaryDirectory parent;
  ScenarioRow other = sample_row(3);
  other.result.metrics.values()[0] = -7.0;
  put(parent.path() / "a.jrnl", record_of(sample_row(4)) + record_of(sample_row(3)));
  put(parent.path() / "b.jrnl", record_of(other) + record_of(sample_row(4)) + record_of(other));
  JournalIndex index;
  ASSERT_TRUE(index.add(parent.path() / "a.jrnl", kPrefix));
  ASSERT_TRUE(index.add(parent.path() / "b.jrnl", kPrefix));
  const auto twice = index.settle();
  ASSERT_TRUE(twice);
  ASSERT_EQ(twice->size(), 2U);
  EXPECT_EQ(twice->front().id, 3U);
  EXPECT_EQ(twice->front().path, parent.path() / "b.jrnl");
  expect_rows(index.rows(), {sample_row(3), sample_row(4)});
}

TEST(Streaming, AJournalThatChangesMeanwhileIsAnErrorNeverNumbers) {
  const TemporaryDirectory parent;
  const fs::path path = parent.path() / "a.jrnl";
  put(path, record_of(sample_row(0)) + record_of(sample_row(1)));
  JournalIndex index;
  ASSERT_TRUE(index.add(path, kPrefix));
  ASSERT_TRUE(index.settle());
  const StudyRows rows = index.rows();
  put(path, record_of(sample_row(1)) + record_of(sample_row(0)));
  EXPECT_THROW((void)rows.held(), RowsFailure);
  EXPECT_EQ(write_results_file(parent.path() / "r.h5",
                               [&] {
                                 ResultsContent content = content_of({});
                                 content.stored = rows;
                                 return content;
                               }())
                ->kind,
            ResultsErrorKind::damaged);
  EXPECT_FALSE(fs::exists(parent.path() / "r.h5"));
  EXPECT_FALSE(fs::exists(parent.path() / "r.h5.tmp"));
}

TEST(Streaming, AFileThatIsLargerThanItsPagesInMemoryHasTheSameBytes) {
  const TemporaryDirectory parent;
  const ResultsContent content = content_of(sample_rows(kMany));
  ASSERT_EQ(message_of(write_results_file(parent.path() / "all.h5", content)), "");
  ASSERT_EQ(message_of(write_results_file(parent.path() / "few.h5", content, 2)), "");
  EXPECT_GT(fs::file_size(parent.path() / "few.h5"), 10 * PagedFile::kPageBytes);
  EXPECT_TRUE(*read_text_file(parent.path() / "all.h5") == *read_text_file(parent.path() / "few.h5"));
}

// In a process of its own, where files may not grow beyond some megabytes, as on a full disk.
TEST(Streaming, ADiskThatIsFullOnTheWayLeavesTheOldFileAndNothingElse) {
  const TemporaryDirectory parent;
  const fs::path path = parent.path() / "results.h5";
  ASSERT_EQ(message_of(write_results_file(path, content_of(sample_rows(3)))), "");
  const std::string before = *read_text_file(path);
  for (const std::size_t pages : {std::size_t{2}, PagedFile::kPagesInMemory}) {
    const pid_t child = ::fork();
    if (child == 0) {
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit few{5 * PagedFile::kPageBytes, 5 * PagedFile::kPageBytes};
      ::setrlimit(RLIMIT_FSIZE, &few);
      const auto error = write_results_file(path, content_of(sample_rows(kMany)), pages);
      const bool is_named = error && error->kind == ResultsErrorKind::io &&
                            error->message.find("results.h5.tmp") != std::string::npos;
      ::_exit(is_named ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0) << pages;
    EXPECT_TRUE(*read_text_file(path) == before);
    EXPECT_EQ(std::distance(fs::directory_iterator(parent.path()), {}), 1);
  }
}

TEST(Streaming, WhatAKilledProcessLeftIsOverwritten) {
  const TemporaryDirectory parent;
  const fs::path path = parent.path() / "results.h5";
  put(temporary_of(path), std::string(1 << 22, 'x'));
  ASSERT_EQ(message_of(write_results_file(path, content_of(sample_rows(3)))), "");
  EXPECT_FALSE(fs::exists(temporary_of(path)));
  expect_rows(read_results_summary(path)->rows, sample_rows(3));
}

TEST(Streaming, ALargeFileIsReadSomeRowsAtATime) {
  constexpr std::uint64_t kCount = 4 * kRowsAtATime + 100;
  const TemporaryDirectory parent;
  const fs::path path = parent.path() / "results.h5";
  const std::vector<ScenarioRow> rows = sample_rows(kCount);
  ASSERT_EQ(message_of(write_results_file(path, content_of(rows))), "");
  const auto summary = read_suspect_summary(path);
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_EQ(summary->digest(), digest_in_memory(rows));
  EXPECT_EQ(summary->rows.seen().digest, digest_in_memory(rows));
  EXPECT_TRUE(same_row(summary->rows.at(kCount - 1), rows.back()));
  expect_rows(summary->rows, rows);
  // Another file under the name is not mixed with it.
  ASSERT_EQ(message_of(write_results_file(path, content_of(rows))), "");
  try {
    (void)summary->rows.at(0);
    ADD_FAILURE() << "no error";
  } catch (const RowsFailure& failure) {
    EXPECT_EQ(failure.error.kind, ResultsErrorKind::busy);
  }
}

}  // namespace
}  // namespace unbruised::studies
