#pragma once

/// @file
/// Which thread runs which scenarios in which lanes. Scenarios of one factor key share a model; more of them may
/// be added while others run (a search that asks), until the scheduler is closed. A scenario's result depends on
/// the scenario alone; only the order in which results arrive depends on the schedule.

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/outcome/outcome.hpp"
#include "core/scenario/scenario.hpp"
#include "studies/execution/executor.hpp"
#include "studies/execution/simulator.hpp"

namespace unbruised::studies {

/// Inside a factor key, of scenarios that were added together the longest is handed out first: what starts last is
/// what others wait for. In work that grows, lanes of one thread
/// are filled before those of the next are used, and models stay for the questions that follow; otherwise the
/// threads share what there is. A thread that nobody has work for helps one that has.
class LaneScheduler final : public Work {
 public:
  /// @param simulator must outlive it. @param threads > 0
  LaneScheduler(const Simulator& simulator, WorkOrder order, int threads);

  void add(std::span<const std::uint64_t> ids) override;
  void close() override;
  void abort() override { aborted_ = true; }
  WorkReport run() override;

 private:
  friend class GroupWorker;

  /// A worker's place in a group.
  struct Seat {
    int free_lanes = 0;
    bool has_help = false;  ///< a thread that nobody else needs
  };
  /// The scenarios of one factor key. Guarded by the mutex but for `model` and `error`, which do not change while
  /// somebody works in the group.
  struct Group {
    enum class Stage { waiting, building, ready, failed };
    std::size_t index = 0;
    std::deque<std::uint64_t> waiting;  ///< ids to hand out, in order
    Stage stage = Stage::waiting;
    std::shared_ptr<const SharedModel> model;
    std::string error;
    std::vector<Seat*> seats;  ///< in the order of joining
  };

  void run_workers();
  void work();
  [[nodiscard]] bool stopping() const;
  [[nodiscard]] bool grows() const { return order_.supply == Supply::growing; }
  [[nodiscard]] std::size_t group_count() const;
  [[nodiscard]] LaneUse lane_use() const;

  Group* join(Seat& seat);
  void leave(Group& group, Seat& seat, LaneUse use);
  void take(Group& group, Seat& seat, int busy, std::vector<std::uint64_t>& taken);
  void deliver(std::uint64_t id, const ScenarioResult& result);
  void abort_with_current_exception();
  void has_no_free_lanes(Seat& seat);
  void lend_help(Seat& seat);
  [[nodiscard]] bool only_worker_in(const Group& group);

  Group* pick_group();
  Group* build(Group& group, std::unique_lock<std::mutex>& lock);
  [[nodiscard]] ModelOrReason build_first_scenario(std::uint64_t id) const;
  [[nodiscard]] std::size_t sharers_of(const Group& group) const;
  static void deal(std::deque<std::uint64_t>& waiting, std::size_t count, std::size_t sharers,
                   std::vector<std::uint64_t>& taken);
  [[nodiscard]] static std::size_t left_by_seniors(const Group& group, const Seat& seat);
  [[nodiscard]] static std::size_t uncovered(const Group& group);
  void drop_model(Group& group);

  const Simulator& simulator_;
  const WorkOrder order_;
  const int threads_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Group> groups_;
  std::unordered_map<std::string, std::size_t> group_of_key_;
  std::set<std::size_t> open_;    ///< groups with scenarios to hand out, and those being built
  std::deque<std::size_t> idle_;  ///< groups with a model that nobody works with, the longest idle first
  int unassigned_workers_;
  int seated_workers_ = 0, helping_threads_ = 0;
  bool closed_ = false;
  LaneUse use_;

  std::mutex sink_mutex_;
  std::atomic<bool> aborted_ = false;
  std::exception_ptr failure_;
  std::atomic<std::size_t> delivered_ = 0;
};

}  // namespace unbruised::studies
