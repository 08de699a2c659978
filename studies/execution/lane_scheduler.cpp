#include "studies/execution/lane_scheduler.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include "studies/execution/group_worker.hpp"
#include "studies/execution/lone_run.hpp"
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

}  // namespace

LaneScheduler::LaneScheduler(const Simulator& simulator, WorkOrder order, int threads)
    : simulator_(simulator), order_(std::move(order)), threads_(threads), unassigned_workers_(threads) {}

WorkReport LaneScheduler::run() {
  run_workers();
  if (failure_) std::rethrow_exception(failure_);
  return {.group_count = group_count(), .delivered = delivered_, .lane_use = lane_use()};
}

void LaneScheduler::add(std::span<const std::uint64_t> ids) {
  struct Added {
    std::uint64_t id;
    double duration_s;
    std::string key;
  };
  std::vector<Added> added;
  added.reserve(ids.size());
  for (const std::uint64_t id : ids) {
    const Scenario scenario = order_.scenario(id);
    added.push_back({id, simulator_.duration_s(scenario), simulator_.factor_key(scenario)});
  }
  std::ranges::stable_sort(added, std::ranges::greater(), &Added::duration_s);
  {
    const std::lock_guard lock(mutex_);
    for (Added& each : added) {
      const auto [place, is_new] = group_of_key_.try_emplace(std::move(each.key), groups_.size());
      if (is_new) groups_.emplace_back().index = place->second;
      groups_[place->second].waiting.push_back(each.id);
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
                                         static_cast<std::size_t>(threads_));
  tbb::task_arena arena(threads_);
  arena.execute([&] {
    tbb::task_group workers;
    hand_over(this);
    for (int i = 1; i < threads_; ++i) {
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
    // What a worker cannot turn into a row ends the work; the exception comes out of `run`.
    const std::lock_guard lock(sink_mutex_);
    if (!aborted_) abort_with_current_exception();
  }
}

bool LaneScheduler::stopping() const { return is_set(order_.stop) || aborted_.load(std::memory_order_relaxed); }

std::size_t LaneScheduler::group_count() const {
  const std::lock_guard lock(mutex_);
  return groups_.size();
}

LaneUse LaneScheduler::lane_use() const {
  const std::lock_guard lock(mutex_);
  return use_;
}

/// A group to work in, its model built or failed; nullptr: nothing left for this worker.
LaneScheduler::Group* LaneScheduler::join(Seat& seat) {
  std::unique_lock lock(mutex_);
  while (!stopping()) {
    if (Group* group = pick_group()) {
      seat.free_lanes = simulator_.lane_count();
      group->seats.push_back(&seat);
      --unassigned_workers_;
      ++seated_workers_;
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
    if (!grows() && is_free) return &group;
    const std::size_t left = grows() ? uncovered(group) : group.waiting.size();
    const auto worth_it = static_cast<std::size_t>(std::max(1, simulator_.lane_count() / kPartWorthAThread));
    if (grows() && !is_free && left < worth_it) continue;
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
  ModelOrReason model = build_first_scenario(first);
  lock.lock();
  group.stage = model ? Group::Stage::ready : Group::Stage::failed;
  if (!model) group.error = model.error();
  if (model) group.model = *std::move(model);
  changed_.notify_all();
  return &group;
}

ModelOrReason LaneScheduler::build_first_scenario(std::uint64_t id) const {
  try {
    return build_model(simulator_, order_.scenario(id));
  } catch (...) {
    return current_exception_text();
  }
}

void LaneScheduler::leave(Group& group, Seat& seat, LaneUse use) {
  {
    const std::lock_guard lock(mutex_);
    ++unassigned_workers_;
    --seated_workers_;
    helping_threads_ -= std::exchange(seat.has_help, false) ? 1 : 0;
    use_.busy_lane_steps += use.busy_lane_steps;
    use_.lane_steps += use.lane_steps;
    std::erase(group.seats, &seat);
    if (group.seats.empty() && group.waiting.empty()) {
      if (!grows() || stopping()) {
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

/// Ids for a worker's free places. Where others are without work it takes no more than its lanes can advance at
/// once.
void LaneScheduler::take(Group& group, Seat& seat, int busy, std::vector<std::uint64_t>& taken) {
  taken.clear();
  const std::lock_guard lock(mutex_);
  if (stopping()) return;
  lend_help(seat);
  const bool leaves_some = grows() && unassigned_workers_ > 0;
  const int places = leaves_some ? simulator_.lane_count() : simulator_.place_count();
  const auto free = static_cast<std::size_t>(std::max(0, places - busy));
  const std::size_t sharers = grows() ? 1 : sharers_of(group);
  const std::size_t mine = grows() ? left_by_seniors(group, seat) : (group.waiting.size() + sharers - 1) / sharers;
  const std::size_t count = std::min(free, mine);
  deal(group.waiting, count, sharers, taken);
  seat.free_lanes = static_cast<int>(free - count);
  if (group.waiting.empty() && count > 0) open_.erase(group.index);
}

/// Every `sharers`-th of those in front: the longest come first, and each worker is to have its part of them.
void LaneScheduler::deal(std::deque<std::uint64_t>& waiting, std::size_t count, std::size_t sharers,
                         std::vector<std::uint64_t>& taken) {
  std::vector<std::uint64_t> left;
  for (std::size_t i = 0; taken.size() < count; ++i) {
    (i % sharers == 0 ? taken : left).push_back(waiting.front());
    waiting.pop_front();
  }
  waiting.insert(waiting.begin(), left.begin(), left.end());
}

/// What is left is shared among the workers of the group and those about to join it, so that no thread is left
/// with a long tail of its own.
std::size_t LaneScheduler::sharers_of(const Group& group) const {
  std::size_t share = group.seats.size();
  if (unassigned_workers_ > 0) {
    const auto unassigned = static_cast<std::size_t>(unassigned_workers_);
    std::size_t free_groups = 0;
    for (const std::size_t index : open_) {
      if (groups_[index].seats.empty() && ++free_groups >= unassigned) break;
    }
    share += unassigned - std::min(unassigned, free_groups);
  }
  return std::max<std::size_t>(1, share);
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

/// Helpers and workers together are no more than the threads.
void LaneScheduler::lend_help(Seat& seat) {
  const int others = helping_threads_ - (seat.has_help ? 1 : 0);
  seat.has_help = seated_workers_ + others < threads_;
  helping_threads_ = others + (seat.has_help ? 1 : 0);
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
    order_.sink(id, result);
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
