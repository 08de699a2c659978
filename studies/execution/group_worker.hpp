#pragma once

/// @file
/// One worker's lanes in one group of a lane scheduler: fills free places, steps, hands results on.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "studies/execution/lane_scheduler.hpp"
#include "studies/execution/simulator.hpp"

namespace unbruised::studies {

class GroupWorker {
 public:
  using Group = LaneScheduler::Group;
  using Seat = LaneScheduler::Seat;

  GroupWorker(LaneScheduler& scheduler, Group& group, Seat& seat);
  /// Until nothing is left for it in this group.
  LaneUse run();

 private:
  using Slot = std::optional<std::uint64_t>;

  bool advance();
  bool ensure_lanes();
  void load_taken();
  void collect_finished();
  void run_each_alone();
  void run_one_alone(std::uint64_t id);
  void fail_all_left(const std::string& cause);
  Slot& slot(int place) { return id_in_place_[static_cast<std::size_t>(place)]; }

  LaneScheduler& scheduler_;
  Group& group_;
  Seat& seat_;
  std::unique_ptr<LaneEngine> lanes_;
  std::vector<Slot> id_in_place_;
  std::vector<std::uint64_t> taken_;
  int busy_ = 0;
  LaneUse use_;
};

}  // namespace unbruised::studies
