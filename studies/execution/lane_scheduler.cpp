#include "studies/execution/lane_scheduler.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <new>
#include <optional>
#include <utility>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include "studies/execution/thread_sanitizer.hpp"

#ifdef UNBRUISED_THREAD_SANITIZER
// TBB's own memory, and its reading of a task that another thread made.
extern "C" const char* __tsan_default_suppressions() {
  return "called_from_lib:libtbb.so\nrace_top:tbb::detail::d1::function_task\n";
}
#endif

namespace unbruised::studies {
namespace {

/// Groups looked through for the one with most to do; with more, the first ones are served first.
constexpr std::size_t kGroupsLookedThrough = 64;
/// Models that nobody works with but a growing study may need again.
constexpr std::size_t kIdleModelsKept = 32;
/// Lanes cost the same full or empty: a thread joins others in a growing group for at least this part of its
/// lanes; fewer scenarios wait for the lanes there are.
constexpr int kPartWorthAThread = 4;
/// How often a waiting worker looks at the stop flag, which a signal handler sets without waking anybody.
constexpr std::chrono::milliseconds kStopPoll{50};

bool is_set(const std::atomic<bool>* flag) { return flag != nullptr && flag->load(std::memory_order_relaxed); }

}  // namespace

ScenarioResult failed_result(std::string cause) {
  ScenarioResult result;
  result.outcome = Outcome::diverged;
  result.cause = std::move(cause);
  return result;
}

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

/// One worker's lanes in one group.
class GroupWorker {
 public:
  using Group = LaneScheduler::Group;
  using Seat = LaneScheduler::Seat;

  GroupWorker(LaneScheduler& scheduler, Group& group, Seat& seat)
      : scheduler_(scheduler),
        group_(group),
        seat_(seat),
        lane_count_(scheduler.simulator_.lane_count()),
        id_in_lane_(static_cast<std::size_t>(lane_count_)) {}

  LaneUse run() {
    if (group_.stage == Group::Stage::failed) {
      fail_all_left(group_.error);
      return use_;
    }
    while (!scheduler_.stopping() && advance()) {
    }
    return use_;
  }

 private:
  using Slot = std::optional<std::uint64_t>;

  /// Fills free lanes and makes one step; false when there is nothing left to do.
  bool advance() {
    scheduler_.take(group_, seat_, busy_, taken_);
    if (!taken_.empty() && !ensure_lanes()) return false;
    try {
      load_taken();
      if (busy_ == 0) return false;
      lanes_->step();
      use_.busy_lane_steps += static_cast<std::uint64_t>(busy_);
      use_.lane_steps += static_cast<std::uint64_t>(lane_count_);
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
      lanes_->load(lane, scheduler_.scenario_(id));
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
    scheduler_.has_no_free_lanes(seat_);
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
          run_in_fresh_lanes(*group_.model, scheduler_.scenario_(id), nullptr, scheduler_.options_.stop);
      if (result) scheduler_.deliver(id, *result);
    } catch (...) {
      scheduler_.deliver(id, failed_result(current_exception_text()));
    }
  }

  void fail_all_left(const std::string& cause) {
    do {
      scheduler_.take(group_, seat_, 0, taken_);
      for (const std::uint64_t id : taken_) scheduler_.deliver(id, failed_result(cause));
    } while (!taken_.empty());
  }

  Slot& slot(int lane) { return id_in_lane_[static_cast<std::size_t>(lane)]; }

  LaneScheduler& scheduler_;
  Group& group_;
  Seat& seat_;
  const int lane_count_;
  std::unique_ptr<LaneEngine> lanes_;
  std::vector<Slot> id_in_lane_;
  std::vector<std::uint64_t> taken_;
  int busy_ = 0;
  LaneUse use_;
};

LaneScheduler::LaneScheduler(const Simulator& simulator, std::function<Scenario(std::uint64_t id)> scenario,
                             ResultSink sink, Options options)
    : simulator_(simulator),
      scenario_(std::move(scenario)),
      sink_(std::move(sink)),
      options_(options),
      unassigned_workers_(options.threads) {}

void LaneScheduler::add(std::span<const std::uint64_t> ids) {
  std::vector<std::string> keys;
  keys.reserve(ids.size());
  for (const std::uint64_t id : ids) keys.push_back(simulator_.factor_key(scenario_(id)));
  {
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto [place, is_new] = group_of_key_.try_emplace(std::move(keys[i]), groups_.size());
      if (is_new) groups_.emplace_back().index = place->second;
      groups_[place->second].waiting.push_back(ids[i]);
      open_.insert(place->second);
    }
  }
  changed_.notify_all();
}

void LaneScheduler::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
}

void LaneScheduler::run_workers() {
  // Without this TBB gives no more threads than the machine has cores, whatever was asked.
  const tbb::global_control thread_limit(tbb::global_control::max_allowed_parallelism,
                                         static_cast<std::size_t>(options_.threads));
  tbb::task_arena arena(options_.threads);
  arena.execute([&] {
    tbb::task_group workers;
    hand_over(this);
    for (int i = 1; i < options_.threads; ++i) {
      workers.run([&] {
        take_over(this);
        work();
        hand_over(this);
      });
    }
    work();
    workers.wait();
    take_over(this);
  });
}

void LaneScheduler::work() {
  try {
    Seat seat;
    while (Group* group = join(seat)) leave(*group, seat, GroupWorker(*this, *group, seat).run());
  } catch (...) {
    // What a worker cannot turn into a row ends the work; the exception comes out of rethrow_failure.
    const std::lock_guard lock(sink_mutex_);
    if (!aborted_) abort_with_current_exception();
  }
}

bool LaneScheduler::stopping() const { return is_set(options_.stop) || aborted_.load(std::memory_order_relaxed); }

std::size_t LaneScheduler::group_count() const {
  const std::lock_guard lock(mutex_);
  return groups_.size();
}

std::size_t LaneScheduler::delivered() const { return delivered_; }

LaneUse LaneScheduler::lane_use() const {
  const std::lock_guard lock(mutex_);
  return use_;
}

void LaneScheduler::rethrow_failure() const {
  if (failure_) std::rethrow_exception(failure_);
}

/// A group to work in, its model built or failed; nullptr: nothing left for this worker.
LaneScheduler::Group* LaneScheduler::join(Seat& seat) {
  std::unique_lock lock(mutex_);
  while (!stopping()) {
    if (Group* group = pick_group()) {
      seat.free_lanes = simulator_.lane_count();
      group->seats.push_back(&seat);
      --unassigned_workers_;
      std::erase(idle_, group->index);
      return group->stage == Group::Stage::waiting ? build(*group, lock) : group;
    }
    const bool nothing_will_come = closed_ && open_.empty();
    if (nothing_will_come) break;
    changed_.wait_for(lock, kStopPoll);
  }
  --unassigned_workers_;  // it goes home
  changed_.notify_all();
  return nullptr;
}

/// The group with most scenarios that no lane is free for; one whose model is being built has to wait.
LaneScheduler::Group* LaneScheduler::pick_group() {
  Group* best = nullptr;
  std::size_t most = 0;
  std::size_t seen = 0;
  for (const std::size_t index : open_) {
    if (++seen > kGroupsLookedThrough && best != nullptr) break;
    Group& group = groups_[index];
    if (group.stage == Group::Stage::building) continue;
    // In a fixed batch groups nobody works in come first, in order; then the threads join the fullest.
    const bool is_free = group.seats.empty();
    if (!options_.grows && is_free) return &group;
    const std::size_t left = options_.grows ? uncovered(group) : group.waiting.size();
    const auto worth_it = static_cast<std::size_t>(std::max(1, simulator_.lane_count() / kPartWorthAThread));
    if (options_.grows && !is_free && left < worth_it) continue;
    if (left > most) {
      most = left;
      best = &group;
    }
  }
  return best;
}

LaneScheduler::Group* LaneScheduler::build(Group& group, std::unique_lock<std::mutex>& lock) {
  group.stage = Group::Stage::building;
  const std::uint64_t first = group.waiting.front();
  lock.unlock();
  std::string error;
  std::shared_ptr<const SharedModel> model = build_first_scenario(first, error);
  lock.lock();
  group.stage = model ? Group::Stage::ready : Group::Stage::failed;
  group.model = std::move(model);
  group.error = std::move(error);
  changed_.notify_all();
  return &group;
}

std::shared_ptr<const SharedModel> LaneScheduler::build_first_scenario(std::uint64_t id,
                                                                       std::string& error) const {
  try {
    return build_model(simulator_, scenario_(id), error);
  } catch (...) {
    error = current_exception_text();
    return nullptr;
  }
}

void LaneScheduler::leave(Group& group, Seat& seat, LaneUse use) {
  {
    const std::lock_guard lock(mutex_);
    ++unassigned_workers_;
    use_.busy_lane_steps += use.busy_lane_steps;
    use_.lane_steps += use.lane_steps;
    std::erase(group.seats, &seat);
    if (group.seats.empty() && group.waiting.empty()) {
      if (!options_.grows || stopping()) {
        drop_model(group);
      } else if (group.model) {
        idle_.push_back(group.index);
        if (idle_.size() > kIdleModelsKept) drop_model(groups_[idle_.front()]);
      }
    }
  }
  changed_.notify_all();
}

void LaneScheduler::drop_model(Group& group) {
  group.model.reset();
  group.stage = Group::Stage::waiting;
  std::erase(idle_, group.index);
}

/// Up to `lane_count - busy` ids for a worker's free lanes.
void LaneScheduler::take(Group& group, Seat& seat, int busy, std::vector<std::uint64_t>& taken) {
  taken.clear();
  const std::lock_guard lock(mutex_);
  if (stopping()) return;
  const auto free = static_cast<std::size_t>(simulator_.lane_count() - busy);
  const std::size_t mine = options_.grows ? left_by_seniors(group, seat) : fair_share(group);
  const std::size_t count = std::min(free, mine);
  taken.assign(group.waiting.begin(), group.waiting.begin() + static_cast<std::ptrdiff_t>(count));
  group.waiting.erase(group.waiting.begin(), group.waiting.begin() + static_cast<std::ptrdiff_t>(count));
  seat.free_lanes = static_cast<int>(free - count);
  if (group.waiting.empty() && count > 0) open_.erase(group.index);
}

/// What is left is shared among the workers of the group and those about to join it, so that no thread is left
/// with a long tail of its own.
std::size_t LaneScheduler::fair_share(const Group& group) const {
  std::size_t share = group.seats.size();
  if (unassigned_workers_ > 0) {
    const auto unassigned = static_cast<std::size_t>(unassigned_workers_);
    std::size_t free_groups = 0;
    for (const std::size_t index : open_) {
      if (groups_[index].seats.empty() && ++free_groups >= unassigned) break;
    }
    share += unassigned - std::min(unassigned, free_groups);
  }
  share = std::max<std::size_t>(1, share);
  return (group.waiting.size() + share - 1) / share;
}

/// A step costs the same however many lanes are busy, so whoever came first fills up first, and the last one runs
/// dry where there is too little for all.
std::size_t LaneScheduler::left_by_seniors(const Group& group, const Seat& seat) {
  std::size_t covered = 0;
  for (const Seat* other : group.seats) {
    if (other == &seat) break;
    covered += static_cast<std::size_t>(other->free_lanes);
  }
  return group.waiting.size() - std::min(group.waiting.size(), covered);
}

std::size_t LaneScheduler::uncovered(const Group& group) {
  std::size_t covered = 0;
  for (const Seat* seat : group.seats) covered += static_cast<std::size_t>(seat->free_lanes);
  return group.waiting.size() - std::min(group.waiting.size(), covered);
}

void LaneScheduler::has_no_free_lanes(Seat& seat) {
  const std::lock_guard lock(mutex_);
  seat.free_lanes = 0;
}

bool LaneScheduler::only_worker_in(const Group& group) {
  const std::lock_guard lock(mutex_);
  return group.seats.size() == 1;
}

void LaneScheduler::deliver(std::uint64_t id, const ScenarioResult& result) {
  const std::lock_guard lock(sink_mutex_);
  if (aborted_) return;
  try {
    sink_(id, result);
    ++delivered_;
  } catch (...) {
    abort_with_current_exception();
  }
}

void LaneScheduler::abort_with_current_exception() {
  failure_ = std::current_exception();
  aborted_ = true;
}

}  // namespace unbruised::studies
