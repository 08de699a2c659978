#include "studies/execution/periodic_task.hpp"

#include <utility>

namespace unbruised::studies {

PeriodicTask::PeriodicTask(std::chrono::milliseconds interval, std::function<void()> task)
    : interval_(interval),
      task_(std::move(task)),
      thread_([this](const std::stop_token& stop) { repeat(stop); }) {}

void PeriodicTask::repeat(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    due_.wait_for(lock, stop, interval_, [] { return false; });
    if (!stop.stop_requested()) task_();
  }
}

}  // namespace unbruised::studies
