#include "studies/runner/batch_runner.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <unordered_map>
#include <utility>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

namespace unbruised::studies {
namespace {

ScenarioResult failed_result(std::string cause) {
  ScenarioResult result;
  result.outcome = Outcome::diverged;
  result.cause = std::move(cause);
  return result;
}

/// The exception being handled, as the cause of a row.
std::string current_exception_text() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::exception& error) {
    return std::string("internal error: ") + error.what();
  } catch (...) {
    return "internal error of unknown kind";
  }
}

std::shared_ptr<const SharedModel> build_model(const Simulator& simulator, const Scenario& scenario,
                                               std::string& error) {
  try {
    std::shared_ptr<const SharedModel> model = simulator.build(scenario, error);
    if (!model && error.empty()) error = "the model cannot be built";
    return model;
  } catch (...) {
    error = current_exception_text();
    return nullptr;
  }
}

bool is_set(const std::atomic<bool>* flag) { return flag != nullptr && flag->load(std::memory_order_relaxed); }

/// One scenario in lane 0 until it ends; nothing when stopped.
std::optional<ScenarioResult> run_in_fresh_lanes(const SharedModel& model, const Scenario& scenario, Trace* trace,
                                                 const std::atomic<bool>* stop) {
  try {
    const std::unique_ptr<LaneEngine> lanes = model.make_lanes();
    lanes->load(0, scenario);
    if (trace != nullptr) lanes->record_trace(0, *trace);
    while (!is_set(stop)) {
      lanes->step();
      if (!lanes->finished().empty()) return lanes->finished().front().result;
    }
    return std::nullopt;
  } catch (...) {
    return failed_result(current_exception_text());
  }
}

/// The scenarios of one factor key. Guarded by the scheduler's mutex but for `ids`, and but for `model` and
/// `error`, which do not change while the stage is ready or failed and somebody works in the group.
struct Group {
  enum class Stage { waiting, building, ready, failed };
  std::vector<std::uint64_t> ids;
  std::size_t next = 0;  ///< index into ids of the next one to hand out
  Stage stage = Stage::waiting;
  std::shared_ptr<const SharedModel> model;
  std::string error;
  int workers = 0;

  [[nodiscard]] std::size_t remaining() const { return ids.size() - next; }
};

std::vector<Group> group_by_factor_key(const Simulator& simulator, const Batch& batch) {
  std::vector<Group> groups;
  std::unordered_map<std::string, std::size_t> index_of;
  for (const std::uint64_t id : batch.ids) {
    const auto [place, is_new] = index_of.try_emplace(simulator.factor_key(batch.scenario(id)), groups.size());
    if (is_new) groups.emplace_back();
    groups[place->second].ids.push_back(id);
  }
  return groups;
}

/// Which worker runs which group, and which scenarios it takes. Groups are started in order; a worker without
/// a group of its own joins the one with most left to hand out. A model lives as long as somebody works with it.
class Scheduler {
 public:
  Scheduler(const Simulator& simulator, const Batch& batch, const BatchOptions& options, const ResultSink& sink)
      : simulator_(simulator),
        batch_(batch),
        stop_(options.stop),
        sink_(sink),
        groups_(group_by_factor_key(simulator, batch)),
        unassigned_workers_(options.threads) {}

  /// A group to work in, its model built or failed; nullptr: nothing left for this worker.
  Group* join() {
    std::unique_lock lock(mutex_);
    while (!stopping()) {
      if (first_waiting_ < groups_.size()) return start(groups_[first_waiting_++], lock);
      Group* group = fullest_open_group();
      if (group == nullptr) break;
      if (group->stage != Group::Stage::building) return assign(*group);
      stage_changed_.wait(lock);
    }
    --unassigned_workers_;  // it goes home
    return nullptr;
  }

  void leave(Group& group) {
    const std::lock_guard lock(mutex_);
    ++unassigned_workers_;
    if (--group.workers == 0 && (group.remaining() == 0 || stopping())) group.model.reset();
  }

  /// Up to `lane_count - busy` ids for a worker's free lanes. What is left is shared fairly among the workers of
  /// the group and those about to join it, so that no thread is left with a long tail of its own.
  void take(Group& group, int busy, int lane_count, std::vector<std::uint64_t>& taken) {
    taken.clear();
    const std::lock_guard lock(mutex_);
    if (stopping()) return;
    const std::size_t share = static_cast<std::size_t>(std::max(1, workers_expected_in(group)));
    const std::size_t fair = (group.remaining() + share - 1) / share;
    const std::size_t wanted = std::min(fair, static_cast<std::size_t>(lane_count - busy));
    for (std::size_t i = 0; i < wanted; ++i) taken.push_back(group.ids[group.next++]);
  }

  [[nodiscard]] bool only_worker_in(const Group& group) {
    const std::lock_guard lock(mutex_);
    return group.workers == 1;
  }

  void deliver(std::uint64_t id, const ScenarioResult& result) {
    const std::lock_guard lock(sink_mutex_);
    if (aborted_) return;
    try {
      sink_(id, result);
      ++delivered_;
    } catch (...) {
      abort_with_current_exception();
    }
  }

  /// For what a worker cannot turn into a row: ends the batch, the exception comes out of it.
  void abort_from_worker() {
    const std::lock_guard lock(sink_mutex_);
    if (!aborted_) abort_with_current_exception();
  }

  [[nodiscard]] bool stopping() const { return is_set(stop_) || aborted_.load(std::memory_order_relaxed); }
  [[nodiscard]] const std::atomic<bool>* stop() const { return stop_; }
  [[nodiscard]] Scenario scenario(std::uint64_t id) const { return batch_.scenario(id); }
  [[nodiscard]] int lane_count() const { return simulator_.lane_count(); }

  [[nodiscard]] BatchReport report() const {
    if (failure_) std::rethrow_exception(failure_);
    return {.group_count = groups_.size(), .delivered = delivered_, .stopped = delivered_ < batch_.ids.size()};
  }

 private:
  Group* assign(Group& group) {
    ++group.workers;
    --unassigned_workers_;
    return &group;
  }

  Group* start(Group& group, std::unique_lock<std::mutex>& lock) {
    group.stage = Group::Stage::building;
    assign(group);
    lock.unlock();
    std::string error;
    std::shared_ptr<const SharedModel> model = build_first_scenario(group, error);
    lock.lock();
    group.stage = model ? Group::Stage::ready : Group::Stage::failed;
    group.model = std::move(model);
    group.error = std::move(error);
    stage_changed_.notify_all();
    return &group;
  }

  std::shared_ptr<const SharedModel> build_first_scenario(const Group& group, std::string& error) const {
    try {
      return build_model(simulator_, scenario(group.ids.front()), error);
    } catch (...) {
      error = current_exception_text();
      return nullptr;
    }
  }

  Group* fullest_open_group() {
    Group* fullest = nullptr;
    for (Group& group : groups_) {
      if (group.remaining() > 0 && (fullest == nullptr || group.remaining() > fullest->remaining())) {
        fullest = &group;
      }
    }
    return fullest;
  }

  [[nodiscard]] int workers_expected_in(const Group& group) const {
    if (unassigned_workers_ <= 0) return group.workers;
    const std::size_t waiting = groups_.size() - first_waiting_;
    const int without_own_group =
        unassigned_workers_ -
        static_cast<int>(std::min<std::size_t>(waiting, static_cast<std::size_t>(unassigned_workers_)));
    return group.workers + without_own_group;
  }

  void abort_with_current_exception() {
    failure_ = std::current_exception();
    aborted_ = true;
  }

  const Simulator& simulator_;
  const Batch& batch_;
  const std::atomic<bool>* stop_;
  const ResultSink& sink_;

  std::mutex mutex_;
  std::condition_variable stage_changed_;
  std::vector<Group> groups_;
  std::size_t first_waiting_ = 0;
  int unassigned_workers_;

  std::mutex sink_mutex_;
  std::atomic<bool> aborted_ = false;
  std::exception_ptr failure_;
  std::size_t delivered_ = 0;
};

/// One worker's lanes in one group.
class GroupWorker {
 public:
  GroupWorker(Scheduler& scheduler, Group& group)
      : scheduler_(scheduler),
        group_(group),
        lane_count_(scheduler.lane_count()),
        id_in_lane_(static_cast<std::size_t>(lane_count_)) {}

  void run() {
    if (group_.stage == Group::Stage::failed) return fail_all_left(group_.error);
    while (!scheduler_.stopping()) {
      if (!advance()) break;
    }
  }

 private:
  using Slot = std::optional<std::uint64_t>;

  /// Fills free lanes and makes one step; false when there is nothing left to do.
  bool advance() {
    scheduler_.take(group_, busy_, lane_count_, taken_);
    if (!taken_.empty() && !ensure_lanes()) return false;
    try {
      load_taken();
      if (busy_ == 0) return false;
      lanes_->step();
      collect_finished();
    } catch (...) {
      run_each_alone();
    }
    return true;
  }

  bool ensure_lanes() {
    if (lanes_) return true;
    try {
      lanes_ = group_.model->make_lanes();
      return true;
    } catch (...) {
      const std::string cause = current_exception_text();
      for (const std::uint64_t id : taken_) run_one_alone(id);
      // Others may have room for what is left of the group; without others it cannot be run.
      if (scheduler_.only_worker_in(group_)) fail_all_left(cause);
      return false;
    }
  }

  void load_taken() {
    int lane = 0;
    while (!taken_.empty()) {
      while (slot(lane)) ++lane;
      const std::uint64_t id = taken_.front();
      slot(lane) = id;
      ++busy_;
      taken_.erase(taken_.begin());
      lanes_->load(lane, scheduler_.scenario(id));
    }
  }

  void collect_finished() {
    for (const LaneSimulation::Finished& finished : lanes_->finished()) {
      const std::uint64_t id = slot(finished.lane).value();
      slot(finished.lane).reset();
      --busy_;
      scheduler_.deliver(id, finished.result);
    }
  }

  /// After an exception the lanes cannot be trusted: everything in flight starts anew, each scenario alone, so
  /// that the one that throws is found and the others keep the bits they have in any company.
  void run_each_alone() {
    lanes_.reset();
    std::vector<std::uint64_t> in_flight = std::exchange(taken_, {});
    for (Slot& held : id_in_lane_) {
      if (held) in_flight.push_back(*held);
      held.reset();
    }
    busy_ = 0;
    std::sort(in_flight.begin(), in_flight.end());
    for (const std::uint64_t id : in_flight) run_one_alone(id);
  }

  void run_one_alone(std::uint64_t id) {
    if (scheduler_.stopping()) return;
    try {
      const std::optional<ScenarioResult> result =
          run_in_fresh_lanes(*group_.model, scheduler_.scenario(id), nullptr, scheduler_.stop());
      if (result) scheduler_.deliver(id, *result);
    } catch (...) {
      scheduler_.deliver(id, failed_result(current_exception_text()));
    }
  }

  void fail_all_left(const std::string& cause) {
    do {
      scheduler_.take(group_, 0, lane_count_, taken_);
      for (const std::uint64_t id : taken_) scheduler_.deliver(id, failed_result(cause));
    } while (!taken_.empty());
  }

  Slot& slot(int lane) { return id_in_lane_[static_cast<std::size_t>(lane)]; }

  Scheduler& scheduler_;
  Group& group_;
  const int lane_count_;
  std::unique_ptr<LaneEngine> lanes_;
  std::vector<Slot> id_in_lane_;
  std::vector<std::uint64_t> taken_;
  int busy_ = 0;
};

void work(Scheduler& scheduler) {
  try {
    while (Group* group = scheduler.join()) {
      GroupWorker(scheduler, *group).run();
      scheduler.leave(*group);
    }
  } catch (...) {
    scheduler.abort_from_worker();
  }
}

}  // namespace

BatchReport run_batch(const Simulator& simulator, const Batch& batch, const BatchOptions& options,
                      const ResultSink& sink) {
  Scheduler scheduler(simulator, batch, options, sink);
  // Without this TBB gives no more threads than the machine has cores, whatever was asked.
  const tbb::global_control thread_limit(tbb::global_control::max_allowed_parallelism,
                                         static_cast<std::size_t>(options.threads));
  tbb::task_arena arena(options.threads);
  arena.execute([&] {
    tbb::task_group workers;
    for (int i = 1; i < options.threads; ++i) workers.run([&] { work(scheduler); });
    work(scheduler);
    workers.wait();
  });
  return scheduler.report();
}

std::optional<ScenarioResult> run_alone(const Simulator& simulator, const Scenario& scenario, Trace* trace,
                                        const std::atomic<bool>* stop) {
  std::string error;
  const std::shared_ptr<const SharedModel> model = build_model(simulator, scenario, error);
  if (!model) return failed_result(error);
  return run_in_fresh_lanes(*model, scenario, trace, stop);
}

}  // namespace unbruised::studies
