#pragma once

/// @file
/// Writes answers down before they are handed out, on a thread of its own, so that a slow disk keeps nobody
/// waiting who has something else to do.

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

class AnswerRecorder {
 public:
  /// One answer: what to write down, and what to do once that is done.
  struct Entry {
    ScenarioRow row;
    std::function<void()> hand_out;
  };
  using Write = std::function<void(const ScenarioRow& row)>;

  /// @param write called for one entry at a time, in the order of arrival. After an exception nothing more is
  /// written nor handed out. @param failed told of it, once
  AnswerRecorder(Write write, std::function<void()> failed);
  ~AnswerRecorder() { finish(); }
  AnswerRecorder(const AnswerRecorder&) = delete;
  AnswerRecorder& operator=(const AnswerRecorder&) = delete;

  /// Thread-safe; returns at once.
  void put(Entry entry);
  /// Returns when all that was put is written and handed out, or writing has failed.
  void finish();
  /// Throws what `write` threw. After `finish`.
  void rethrow_failure() const;

 private:
  void write_all();

  const Write write_;
  const std::function<void()> failed_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Entry> waiting_;
  bool closed_ = false;
  std::exception_ptr failure_;
  std::thread writer_;
};

}  // namespace unbruised::studies
