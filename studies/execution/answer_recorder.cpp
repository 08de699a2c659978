#include "studies/execution/answer_recorder.hpp"

#include <utility>

namespace unbruised::studies {

AnswerRecorder::AnswerRecorder(Write write, std::function<void()> failed)
    : write_(std::move(write)), failed_(std::move(failed)), writer_([this] { write_all(); }) {}

void AnswerRecorder::put(Entry entry) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(entry));
  }
  changed_.notify_one();
}

void AnswerRecorder::finish() {
  if (!writer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_one();
  writer_.join();
}

void AnswerRecorder::rethrow_failure() const {
  if (failure_) std::rethrow_exception(failure_);
}

void AnswerRecorder::write_all() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return closed_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const Entry entry = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    try {
      write_(entry.row);
      entry.hand_out();
    } catch (...) {
      failure_ = std::current_exception();
      failed_();
      return;
    }
    lock.lock();
  }
}

}  // namespace unbruised::studies
