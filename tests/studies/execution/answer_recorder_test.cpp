#include "studies/execution/answer_recorder.hpp"

#include <latch>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

AnswerRecorder::Entry entry(std::uint64_t id, std::function<void()> hand_out) {
  ScenarioRow row;
  row.id = id;
  return {.row = std::move(row), .hand_out = std::move(hand_out)};
}

TEST(AnswerRecorder, HandsOutWhatIsWrittenInTheOrderOfArrival) {
  std::vector<std::string> events;
  AnswerRecorder recorder([&](const ScenarioRow& row) { events.push_back("write " + std::to_string(row.id)); },
                          [] {});
  for (const std::uint64_t id : {3U, 1U, 2U}) {
    recorder.put(entry(id, [&events, id] { events.push_back("hand out " + std::to_string(id)); }));
  }
  recorder.finish();
  EXPECT_EQ(events,
            (std::vector<std::string>{"write 3", "hand out 3", "write 1", "hand out 1", "write 2", "hand out 2"}));
}

TEST(AnswerRecorder, KeepsNobodyWaitingWhoPuts) {
  std::latch may_write(1);
  int written = 0;
  AnswerRecorder recorder(
      [&](const ScenarioRow&) {
        may_write.wait();
        ++written;
      },
      [] {});
  // Were `put` to wait for the writer, the latch would never open.
  for (std::uint64_t id = 0; id < 100; ++id) recorder.put(entry(id, [] {}));
  may_write.count_down();
  recorder.finish();
  EXPECT_EQ(written, 100);
}

TEST(AnswerRecorder, HandsNothingOutOnceWritingHasFailed) {
  std::vector<std::uint64_t> out;
  int failures = 0;
  AnswerRecorder recorder(
      [](const ScenarioRow& row) {
        if (row.id == 1) throw std::runtime_error("disk full");
      },
      [&] { ++failures; });
  for (const std::uint64_t id : {0U, 1U, 2U}) recorder.put(entry(id, [&out, id] { out.push_back(id); }));
  recorder.finish();
  EXPECT_EQ(out, std::vector<std::uint64_t>{0});
  EXPECT_EQ(failures, 1);
  EXPECT_THROW(recorder.rethrow_failure(), std::runtime_error);
}

}  // namespace
}  // namespace unbruised::studies
