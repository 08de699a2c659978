#pragma once

/// @file
/// Ranks that are threads of one process.

#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>
#include <vector>

#include "studies/ranks/message_link.hpp"

namespace unbruised::studies::testing {

/// The letter boxes of all ranks.
class MemoryPost {
 public:
  explicit MemoryPost(int size) : boxes_(static_cast<std::size_t>(size)) {}
  [[nodiscard]] int size() const { return static_cast<int>(boxes_.size()); }
  void put(int to, RankMessage message) {
    Box& box = boxes_.at(static_cast<std::size_t>(to));
    {
      const std::lock_guard lock(box.mutex);
      box.messages.push_back(std::move(message));
    }
    box.changed.notify_all();
  }
  std::optional<RankMessage> take(int rank, std::chrono::milliseconds wait) {
    Box& box = boxes_.at(static_cast<std::size_t>(rank));
    std::unique_lock lock(box.mutex);
    if (!box.changed.wait_for(lock, wait, [&] { return !box.messages.empty(); })) return std::nullopt;
    RankMessage message = std::move(box.messages.front());
    box.messages.pop_front();
    return message;
  }

 private:
  struct Box {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<RankMessage> messages;
  };
  std::deque<Box> boxes_;
};

class MemoryLink final : public MessageLink {
 public:
  MemoryLink(MemoryPost& post, int rank) : post_(post), rank_(rank) {}
  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return post_.size(); }
  void send(int to, std::string bytes) override { post_.put(to, {rank_, std::move(bytes)}); }
  std::optional<RankMessage> receive(std::chrono::milliseconds wait) override { return post_.take(rank_, wait); }
  void leave() override { left = true; }

  bool left = false;

 private:
  MemoryPost& post_;
  const int rank_;
};

}  // namespace unbruised::studies::testing
