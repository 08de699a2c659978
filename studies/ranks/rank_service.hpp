#pragma once

/// @file
/// One rank's part of the work: scenarios that come one by one, run in the lanes of this process.

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <unordered_map>

#include "studies/execution/executor.hpp"
#include "studies/execution/simulator.hpp"
#include "studies/ranks/message_link.hpp"
#include "studies/ranks/rank_messages.hpp"

namespace unbruised::studies {

class RankService {
 public:
  /// Calls are serialised.
  using Answer = std::function<void(RankAnswer answer)>;

  /// @param simulator must outlive it. @param threads > 0
  RankService(const Simulator& simulator, int threads, Answer answer);
  ~RankService() { drop(); }
  RankService(const RankService&) = delete;
  RankService& operator=(const RankService&) = delete;

  /// Scenarios that fill its lanes.
  [[nodiscard]] std::uint64_t seats() const;
  /// Drops what is running, and is ready for questions.
  void begin(Curves curves);
  /// After `begin`. Thread-safe.
  void add(RankQuestion question);
  /// Drops what is running; nothing is answered after it.
  void drop();

 private:
  struct Asked {
    Scenario scenario;
    Curve curve;
  };
  void deliver(std::uint64_t ticket, const ScenarioResult& result);

  const Simulator& simulator_;
  const int threads_;
  const Answer answer_;
  std::mutex mutex_;
  std::unordered_map<std::uint64_t, Asked> asked_;  ///< by ticket
  std::unique_ptr<Work> work_;
  std::thread worker_;
};

/// Serves the first rank until it says that nothing will be asked any more.
void serve_first_rank(MessageLink& link, const Simulator& simulator, int threads);

}  // namespace unbruised::studies
