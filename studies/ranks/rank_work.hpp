#pragma once

/// @file
/// One order shared out among ranks. Each gets about as many scenarios as it has seats for, of few factor groups;
/// towards the end no more than its share of what is left.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "studies/execution/executor.hpp"
#include "studies/ranks/rank_executor.hpp"

namespace unbruised::studies {

class RankWork final : public Work {
 public:
  RankWork(const RankExecutor& executor, WorkOrder order);
  ~RankWork() override { leave(); }
  RankWork(const RankWork&) = delete;
  RankWork& operator=(const RankWork&) = delete;

  void add(std::span<const std::uint64_t> ids) override;
  void close() override;
  void abort() override;
  WorkReport run() override;
  /// An answer to a ticket; of a ticket that is not of this order it is left out.
  void deliver(int rank, RankAnswer answer);

 private:
  struct Peer {
    std::uint64_t seats = 1;
    std::uint64_t outstanding = 0;
    std::optional<std::size_t> group;  ///< the last it was given of
  };
  struct Group {
    std::deque<std::uint64_t> waiting;
    std::size_t peers = 0;  ///< whose last group it is
  };
  [[nodiscard]] bool stopping() const;
  [[nodiscard]] std::uint64_t share(const Peer& peer) const;
  void share_out();
  std::size_t pick_group(Peer& peer);
  void give(int rank, Peer& peer);
  void ask(int rank, RankQuestion question);
  void leave();

  const RankExecutor& executor_;
  const WorkOrder order_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Peer> peers_;
  std::deque<Group> groups_;
  std::unordered_map<std::string, std::size_t> group_of_key_;
  std::set<std::size_t> open_;  ///< groups in which scenarios wait
  std::uint64_t waiting_ = 0;
  std::uint64_t outstanding_ = 0;
  std::unordered_map<std::uint64_t, std::uint64_t> id_of_ticket_;
  bool closed_ = false;

  std::mutex sink_mutex_;
  std::atomic<bool> aborted_ = false;
  std::exception_ptr failure_;
  std::atomic<std::size_t> delivered_ = 0;
};

}  // namespace unbruised::studies
