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
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/outcome/outcome.hpp"
#include "core/scenario/scenario.hpp"
#include "studies/execution/simulator.hpp"

namespace unbruised::studies {

/// Takes each result once; calls are serialised. An exception ends all work and comes out of `rethrow_failure`.
using ResultSink = std::function<void(std::uint64_t id, const ScenarioResult& result)>;

/// How full the lanes were.
struct LaneUse {
  std::uint64_t busy_lane_steps = 0;  ///< steps of scenarios
  std::uint64_t lane_steps = 0;       ///< steps x lanes, empty ones included

  /// 0..1; 1 where nothing ran.
  [[nodiscard]] double occupancy() const {
    return lane_steps == 0 ? 1.0 : static_cast<double>(busy_lane_steps) / static_cast<double>(lane_steps);
  }
};

class LaneScheduler {
 public:
  struct Options {
    /// > 0
    int threads = 1;
    /// When it becomes true no more scenarios are handed out and those in flight are dropped; may be null.
    const std::atomic<bool>* stop = nullptr;
    /// More work may come while some is done (see `close`). Then lanes of one thread are filled before those of
    /// the next are used, and models stay for the questions that follow; otherwise the threads share what there
    /// is.
    bool grows = false;
  };

  /// @param scenario the scenario of an id; called from several threads at once, at least twice per id.
  LaneScheduler(const Simulator& simulator, std::function<Scenario(std::uint64_t id)> scenario, ResultSink sink,
                Options options);

  /// Hands in scenarios, each id once; inside a factor key they are handed out in this order. Thread-safe.
  void add(std::span<const std::uint64_t> ids);
  /// Nothing will be added any more. Thread-safe.
  void close();
  /// Drops what is in flight and hands out nothing more. Thread-safe.
  void abort() { aborted_ = true; }
  /// One worker's life: returns when the scheduler is closed and nothing is left for it, or when stopped. To be
  /// called by `Options::threads` threads.
  void work();
  /// Runs `work` on that many threads and returns when all have ended.
  void run_workers();

  /// No more scenarios will be delivered: the stop flag is set, or a sink failed.
  [[nodiscard]] bool stopping() const;
  [[nodiscard]] std::size_t group_count() const;
  [[nodiscard]] std::size_t delivered() const;
  [[nodiscard]] LaneUse lane_use() const;
  /// Throws what a sink threw.
  void rethrow_failure() const;

 private:
  friend class GroupWorker;

  /// A worker's place in a group.
  struct Seat {
    int free_lanes = 0;
  };
  /// The scenarios of one factor key. Guarded by the mutex but for `model` and `error`, which do not change while
  /// somebody works in the group.
  struct Group {
    enum class Stage { waiting, building, ready, failed };
    std::size_t index = 0;
    std::deque<std::uint64_t> waiting;  ///< ids to hand out
    Stage stage = Stage::waiting;
    std::shared_ptr<const SharedModel> model;
    std::string error;
    std::vector<Seat*> seats;  ///< in the order of joining
  };

  Group* join(Seat& seat);
  void leave(Group& group, Seat& seat, LaneUse use);
  void take(Group& group, Seat& seat, int busy, std::vector<std::uint64_t>& taken);
  void deliver(std::uint64_t id, const ScenarioResult& result);
  void abort_with_current_exception();
  void has_no_free_lanes(Seat& seat);
  [[nodiscard]] bool only_worker_in(const Group& group);

  Group* pick_group();
  Group* build(Group& group, std::unique_lock<std::mutex>& lock);
  std::shared_ptr<const SharedModel> build_first_scenario(std::uint64_t id, std::string& error) const;
  [[nodiscard]] std::size_t fair_share(const Group& group) const;
  [[nodiscard]] static std::size_t left_by_seniors(const Group& group, const Seat& seat);
  [[nodiscard]] static std::size_t uncovered(const Group& group);
  void drop_model(Group& group);

  const Simulator& simulator_;
  const std::function<Scenario(std::uint64_t)> scenario_;
  const ResultSink sink_;
  const Options options_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Group> groups_;
  std::unordered_map<std::string, std::size_t> group_of_key_;
  std::set<std::size_t> open_;    ///< groups with scenarios to hand out, and those being built
  std::deque<std::size_t> idle_;  ///< groups with a model that nobody works with, the longest idle first
  int unassigned_workers_;
  bool closed_ = false;
  LaneUse use_;

  std::mutex sink_mutex_;
  std::atomic<bool> aborted_ = false;
  std::exception_ptr failure_;
  std::atomic<std::size_t> delivered_ = 0;
};

/// A result that says why there is none: `diverged` with the cause.
ScenarioResult failed_result(std::string cause);
/// The exception being handled, as the cause of a row.
std::string current_exception_text();
/// The model of a scenario; nullptr and `error` where it cannot be built, for whatever reason.
std::shared_ptr<const SharedModel> build_model(const Simulator& simulator, const Scenario& scenario,
                                               std::string& error);
/// One scenario in lane 0 of fresh lanes until it ends; nothing when stopped.
std::optional<ScenarioResult> run_in_fresh_lanes(const SharedModel& model, const Scenario& scenario, Trace* trace,
                                                 const std::atomic<bool>* stop);

}  // namespace unbruised::studies
