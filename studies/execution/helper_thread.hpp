#pragma once

/// @file
/// A second thread for work that comes in pairs; it sleeps in between.

#include <exception>
#include <functional>
#include <semaphore>
#include <stop_token>
#include <thread>
#include <utility>

namespace unbruised::studies {

class HelperThread {
 public:
  HelperThread() : thread_([this](const std::stop_token& stop) { serve(stop); }) {}
  ~HelperThread() {
    thread_.request_stop();
    begin_.release();
  }
  HelperThread(const HelperThread&) = delete;
  HelperThread& operator=(const HelperThread&) = delete;

  /// Calls both at the same time, the second one here. @throws what the first one threw, else what the second did
  void run(std::function<void()> first, const std::function<void()>& second) {
    first_ = std::move(first);
    begin_.release();
    std::exception_ptr thrown;
    try {
      second();
    } catch (...) {
      thrown = std::current_exception();
    }
    end_.acquire();
    if (thrown_) thrown = std::exchange(thrown_, nullptr);
    if (thrown) std::rethrow_exception(thrown);
  }

 private:
  void serve(const std::stop_token& stop) {
    for (begin_.acquire(); !stop.stop_requested(); begin_.acquire()) {
      try {
        first_();
      } catch (...) {
        thrown_ = std::current_exception();
      }
      end_.release();
    }
  }

  std::function<void()> first_;
  std::exception_ptr thrown_;
  std::binary_semaphore begin_{0}, end_{0};
  std::jthread thread_;  // the last one: it uses the others
};

}  // namespace unbruised::studies
