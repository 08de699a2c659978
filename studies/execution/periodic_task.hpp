#pragma once

/// @file
/// Something done again and again on a thread of its own while an object lives.

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace unbruised::studies {

/// Calls `task` after each interval. The destructor waits for a call that is under way.
class PeriodicTask {
 public:
  /// @param interval > 0
  PeriodicTask(std::chrono::milliseconds interval, std::function<void()> task);
  ~PeriodicTask() = default;
  PeriodicTask(const PeriodicTask&) = delete;
  PeriodicTask& operator=(const PeriodicTask&) = delete;

 private:
  void repeat(const std::stop_token& stop);

  const std::chrono::milliseconds interval_;
  const std::function<void()> task_;
  std::mutex mutex_;
  std::condition_variable_any due_;
  std::jthread thread_;  ///< last: it uses the others
};

}  // namespace unbruised::studies
