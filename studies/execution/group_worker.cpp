#include "studies/execution/group_worker.hpp"

#include <algorithm>
#include <utility>

#include "studies/execution/lone_run.hpp"

namespace unbruised::studies {

GroupWorker::GroupWorker(LaneScheduler& scheduler, Group& group, Seat& seat)
    : scheduler_(scheduler),
      group_(group),
      seat_(seat),
      id_in_place_(static_cast<std::size_t>(scheduler.simulator_.place_count())) {}

LaneUse GroupWorker::run() {
  if (group_.stage == Group::Stage::failed) {
    fail_all_left(group_.error);
    return use_;
  }
  while (!scheduler_.stopping() && advance()) {
  }
  return use_;
}

/// Fills free places and makes one step; false when there is nothing left to do.
bool GroupWorker::advance() {
  scheduler_.take(group_, seat_, busy_, taken_);
  if (!taken_.empty() && !ensure_lanes()) return false;
  try {
    load_taken();
    if (busy_ == 0) return false;
    lanes_->step(seat_.has_help);
    use_.busy_lane_steps += static_cast<std::uint64_t>(lanes_->stepped());
    use_.lane_steps += static_cast<std::uint64_t>(lanes_->stepped_batches() * scheduler_.simulator_.lane_count());
    collect_finished();
  } catch (...) {
    run_each_alone();
  }
  return true;
}

bool GroupWorker::ensure_lanes() {
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

void GroupWorker::load_taken() {
  int place = 0;
  while (!taken_.empty()) {
    while (slot(place)) ++place;
    const std::uint64_t id = taken_.front();
    slot(place) = id;
    ++busy_;
    taken_.erase(taken_.begin());
    lanes_->load(place, scheduler_.order_.scenario(id));
    if (scheduler_.order_.curve) lanes_->record(place, Recording(&(scheduler_.order_.curve(id) = {})));
  }
}

void GroupWorker::collect_finished() {
  for (const LaneEngine::Finished& finished : lanes_->finished()) {
    const std::uint64_t id = slot(finished.place).value();
    slot(finished.place).reset();
    --busy_;
    scheduler_.deliver(id, finished.result);
  }
}

/// After an exception the lanes cannot be trusted: everything in flight starts anew, each scenario alone, so
/// that the one that throws is found and the others keep the bits they have in any company.
void GroupWorker::run_each_alone() {
  lanes_.reset();
  scheduler_.has_no_free_lanes(seat_);
  std::vector<std::uint64_t> in_flight = std::exchange(taken_, {});
  for (Slot& held : id_in_place_) {
    if (held) in_flight.push_back(*held);
    held.reset();
  }
  busy_ = 0;
  std::sort(in_flight.begin(), in_flight.end());
  for (const std::uint64_t id : in_flight) run_one_alone(id);
}

void GroupWorker::run_one_alone(std::uint64_t id) {
  if (scheduler_.stopping()) return;
  try {
    Curve* curve = scheduler_.order_.curve ? &(scheduler_.order_.curve(id) = {}) : nullptr;
    const std::optional<ScenarioResult> result = run_in_fresh_lanes(*group_.model, scheduler_.order_.scenario(id),
                                                                    Recording(curve), scheduler_.order_.stop);
    if (result) scheduler_.deliver(id, *result);
  } catch (...) {
    scheduler_.deliver(id, failed_result(current_exception_text()));
  }
}

void GroupWorker::fail_all_left(const std::string& cause) {
  do {
    scheduler_.take(group_, seat_, 0, taken_);
    for (const std::uint64_t id : taken_) scheduler_.deliver(id, failed_result(cause));
  } while (!taken_.empty());
}

}  // namespace unbruised::studies
