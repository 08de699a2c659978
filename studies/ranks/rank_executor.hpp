#pragma once

/// @file
/// Several processes as one executor: the first rank shares scenarios out, runs some itself, and is told the
/// results. A scenario has the same bits on any rank, so nothing depends on who runs what.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "studies/execution/executor.hpp"
#include "studies/execution/simulator.hpp"
#include "studies/ranks/message_link.hpp"
#include "studies/ranks/rank_service.hpp"

namespace unbruised::studies {

class RankWork;

/// What the first rank has of the others; at its end it lets them end, unless it was stopped: then they are left
/// to what has stopped it.
class FirstRank {
 public:
  explicit FirstRank(MessageLink& link) : link_(link) {}
  ~FirstRank();
  FirstRank(const FirstRank&) = delete;
  FirstRank& operator=(const FirstRank&) = delete;
  [[nodiscard]] MessageLink& link() const { return link_; }
  void stop() { stopped_ = true; }

 private:
  MessageLink& link_;
  std::atomic<bool> stopped_ = false;
};

/// For the first rank; the others call `serve_first_rank`. One order at a time.
class RankExecutor final : public Executor {
 public:
  /// Told of the time steps of scenarios that other ranks have run.
  using CountSteps = std::function<void(std::size_t steps)>;

  /// Waits until every rank has said who it is. All must outlive it. @param threads of this rank, > 0
  RankExecutor(FirstRank& first, const Simulator& simulator, int threads, CountSteps count_steps);
  ~RankExecutor() override;
  RankExecutor(const RankExecutor&) = delete;
  RankExecutor& operator=(const RankExecutor&) = delete;

  /// Why the ranks cannot work together; nothing: they can.
  [[nodiscard]] const std::optional<std::string>& refusal() const { return refusal_; }

  [[nodiscard]] std::string group_key(const Scenario& scenario) const override {
    return simulator_.factor_key(scenario);
  }
  [[nodiscard]] std::unique_ptr<Work> begin(WorkOrder order) const override;
  /// On this rank.
  [[nodiscard]] std::optional<ScenarioResult> run_traced(const Scenario& scenario, Trace& trace,
                                                         const std::atomic<bool>* stop) const override;

 private:
  friend class RankWork;

  void meet();
  void receive_until(const std::stop_token& stop);
  void deliver(int rank, RankAnswer answer) const;

  FirstRank& first_;
  MessageLink& link_;
  const Simulator& simulator_;
  const CountSteps count_steps_;
  std::optional<std::string> refusal_;
  std::vector<std::uint64_t> seats_;  ///< of each rank
  mutable std::mutex current_mutex_;
  mutable RankWork* current_ = nullptr;  ///< the order that is being carried out
  mutable std::uint64_t next_ticket_ = 0;
  mutable RankService service_;  ///< of this rank
  std::jthread receiver_;
};

}  // namespace unbruised::studies
