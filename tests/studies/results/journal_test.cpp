#include "studies/results/journal.hpp"

#include <chrono>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "studies/results/digest.hpp"
#include "tests/studies/results/sample_rows.hpp"

namespace unbruised::studies {
namespace {

constexpr std::uint64_t kConfig = 0x1122334455667788;

JournalRecord record_of(const ScenarioRow& row) {
  return {RecordKind::scenario, row.id, 0, encode_scenario_row(row)};
}

std::string journal_bytes(std::uint64_t count) {
  std::string bytes;
  for (const ScenarioRow& row : sample_rows(count)) bytes += encode_record(record_of(row), kConfig);
  return bytes;
}

TEST(Journal, GivesBackARowBitForBit) {
  const ScenarioRow row = sample_row(7);
  const auto back = decode_scenario_row(7, encode_scenario_row(row));
  ASSERT_TRUE(back);
  EXPECT_EQ(result_digest(back->result), result_digest(row.result));
  EXPECT_EQ(back->result.cause, row.result.cause);
  EXPECT_EQ(back->inputs, row.inputs);
}

TEST(Journal, RefusesAPayloadOfAnotherShape) {
  const std::string payload = encode_scenario_row(sample_row(1));
  for (std::size_t length = 0; length < payload.size(); ++length) {
    EXPECT_FALSE(decode_scenario_row(1, payload.substr(0, length))) << length;
  }
  EXPECT_FALSE(decode_scenario_row(1, payload + "x"));
}

TEST(Journal, TornAtAnyByteOfTheLastRecordLosesOnlyThatRecord) {
  const std::string whole = journal_bytes(4);
  const std::size_t before = journal_bytes(3).size();
  for (std::size_t length = before; length < whole.size(); ++length) {
    const JournalScan scan = scan_journal_bytes(whole.substr(0, length), kConfig);
    ASSERT_EQ(scan.records.size(), 3U) << length;
    ASSERT_EQ(scan.torn_tail_bytes, length - before) << length;
    ASSERT_TRUE(scan.damage.empty()) << length;
  }
  EXPECT_EQ(scan_journal_bytes(whole, kConfig).records.size(), 4U);
}

TEST(Journal, NeverBelievesARecordWithAFlippedBitAndKeepsTheOthers) {
  const std::string whole = journal_bytes(3);
  const std::size_t first = journal_bytes(1).size();
  const std::size_t second = journal_bytes(2).size();
  for (std::size_t bit = 8 * first; bit < 8 * second; ++bit) {
    std::string flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    const JournalScan scan = scan_journal_bytes(flipped, kConfig);
    ASSERT_EQ(scan.records.size(), 2U) << bit;
    ASSERT_EQ(scan.records[0].id, 0U);
    ASSERT_EQ(scan.records[1].id, 2U);
    ASSERT_EQ(scan.damage.size(), 1U) << bit;
    ASSERT_EQ(scan.damage[0].offset, first);
    ASSERT_EQ(scan.damage[0].bytes, second - first);
  }
}

TEST(Journal, SetsRecordsOfAnotherConfigAside) {
  const JournalScan scan = scan_journal_bytes(journal_bytes(3), kConfig + 1);
  EXPECT_TRUE(scan.records.empty());
  EXPECT_EQ(scan.other_config_records, 3U);
  EXPECT_EQ(scan.torn_tail_bytes, 0U);
}

TEST(Journal, SurvivesAnyBytes) {
  std::uint64_t state = 1;  // a small generator: the same bytes every time
  for (int run = 0; run < 300; ++run) {
    std::string bytes = journal_bytes(2);
    for (int change = 0; change < 20; ++change) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      bytes[(state >> 33) % bytes.size()] = static_cast<char>(state >> 25);
    }
    const JournalScan scan = scan_journal_bytes(bytes, kConfig);
    ASSERT_LE(scan.records.size(), 2U) << run;
  }
}

TEST(JournalWriter, AcknowledgesEveryGroupAndEverythingOnCommit) {
  const TemporaryDirectory directory;
  auto writer = JournalWriter::create(directory.path(), kConfig);
  ASSERT_TRUE(writer);
  for (std::uint64_t id = 0; id < 2 * JournalWriter::kGroupCommitRecords + 3; ++id) {
    ASSERT_EQ(message_of((*writer)->append(record_of(sample_row(id)))), "");
  }
  EXPECT_EQ((*writer)->appended(), 67U);
  EXPECT_GE((*writer)->acknowledged(), 64U);
  ASSERT_EQ(message_of((*writer)->commit()), "");
  EXPECT_EQ((*writer)->acknowledged(), 67U);
  const auto scan = scan_journal((*writer)->path(), kConfig);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->records.size(), 67U);
}

TEST(JournalWriter, AcknowledgesALoneRecordAfterASecond) {
  const TemporaryDirectory directory;
  auto writer = JournalWriter::create(directory.path(), kConfig);
  ASSERT_TRUE(writer);
  ASSERT_EQ(message_of((*writer)->append(record_of(sample_row(0)))), "");
  // One second is the promise; ten leave room for a loaded machine.
  for (int tenth = 0; tenth < 100 && (*writer)->acknowledged() == 0; ++tenth) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_EQ((*writer)->acknowledged(), 1U);
}

TEST(JournalWriter, KeepsWholeRecordsWhenThreadsAppendTogether) {
  const TemporaryDirectory directory;
  auto writer = JournalWriter::create(directory.path(), kConfig);
  ASSERT_TRUE(writer);
  {
    std::vector<std::jthread> threads;
    for (std::uint64_t t = 0; t < 4; ++t) {
      threads.emplace_back([&writer, t] {
        for (std::uint64_t i = 0; i < 50; ++i) {
          EXPECT_EQ(message_of((*writer)->append(record_of(sample_row(100 * t + i)))), "");
        }
      });
    }
  }
  const auto scan = scan_journal((*writer)->path(), kConfig);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->records.size(), 200U);
  EXPECT_TRUE(scan->damage.empty());
}

TEST(JournalWriter, NeverReusesAFile) {
  const TemporaryDirectory directory;
  const auto first = JournalWriter::create(directory.path(), kConfig);
  const auto second = JournalWriter::create(directory.path(), kConfig);
  ASSERT_TRUE(first);
  ASSERT_TRUE(second);
  EXPECT_NE((*first)->path(), (*second)->path());
}

TEST(JournalWriter, NamesTheDirectoryItCannotWriteTo) {
  const auto writer = JournalWriter::create("/proc/none", kConfig);
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().kind, ResultsErrorKind::io);
  EXPECT_NE(writer.error().message.find("/proc/none"), std::string::npos);
}

}  // namespace
}  // namespace unbruised::studies
