#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "core/door/require.hpp"
#include "core/lanes/lane.hpp"
#include "core/simulation/parked_scenario.hpp"
#include "core/simulation/simulation.hpp"

namespace unbruised {
namespace {

/// With as many in flight one of the batches is full, and some wait for it: scenarios of a model have three step
/// lengths at most (step_levels.hpp).
constexpr int kPlaces = 4 * kLanes;

/// Who waits for a lane: not begun, or between two steps.
struct Waiting {
  int place = 0;
  std::optional<Scenario> fresh;
  std::unique_ptr<ParkedScenario> parked;
  std::vector<std::function<void(LaneSimulation&, int lane)>> once_loaded;
  double left_s = HUGE_VAL;  ///< to the end of its plan, once it has begun
};

/// The scenarios that take steps of one length.
struct Batch {
  explicit Batch(std::shared_ptr<const Model> model) : lanes(std::move(model)) { place.fill(kFree); }

  static constexpr int kFree = -1;
  LaneSimulation lanes;
  std::array<int, kLanes> place{};  ///< in each lane
  std::deque<Waiting> waiting;

  [[nodiscard]] int busy() const { return lanes.busy_count(); }
  /// How many would take the next step.
  [[nodiscard]] int ready() const { return std::min(kLanes, busy() + static_cast<int>(waiting.size())); }
  [[nodiscard]] bool is_full() const { return ready() == kLanes; }
  /// Of the scenario that has most time before it; 0: there is none.
  [[nodiscard]] double left_s() const {
    double most_s = 0.0;
    for (const Waiting& each : waiting) most_s = std::max(most_s, each.left_s);
    for (int lane = 0; lane < kLanes; ++lane) {
      if (place[static_cast<std::size_t>(lane)] != kFree) most_s = std::max(most_s, lanes.time_left_s(lane));
    }
    return most_s;
  }
  [[nodiscard]] int free_lane() const { return static_cast<int>(std::ranges::find(place, kFree) - place.begin()); }
  /// Lets those who wait into free lanes.
  void fill() {
    for (int lane = free_lane(); lane < kLanes && !waiting.empty(); lane = free_lane()) {
      Waiting next = std::move(waiting.front());
      waiting.pop_front();
      next.fresh ? lanes.load(lane, *next.fresh) : lanes.put(lane, *next.parked);
      for (const auto& act : next.once_loaded) act(lanes, lane);
      place[static_cast<std::size_t>(lane)] = next.place;
    }
  }
};

}  // namespace

struct LevelSimulation::Impl {
  Impl(std::shared_ptr<const Model> shared, Longer source) : model(std::move(shared)), longer(std::move(source)) {
    batch.emplace(1, std::make_unique<Batch>(model));
  }

  Batch& first() { return *batch.at(1); }
  Batch& with_ticks(int ticks, const Scenario& scenario) {
    std::unique_ptr<Batch>& found = batch[ticks];
    if (!found) {
      found = std::make_unique<Batch>(longer ? longer(ticks, scenario) : model->with_ticks(ticks, scenario));
      if (timing) found->lanes.enable_timing();
    }
    return *found;
  }
  /// Those who want steps of another length go there.
  void send_on(Batch& from) {
    for (int lane = 0; lane < kLanes; ++lane) {
      int& place = from.place[static_cast<std::size_t>(lane)];
      if (place == Batch::kFree) continue;
      const int ticks = from.lanes.next_ticks(lane);
      if (ticks == from.lanes.ticks()) continue;
      const double left_s = from.lanes.time_left_s(lane);
      Waiting moved{std::exchange(place, Batch::kFree), std::nullopt, from.lanes.take(lane), {}, left_s};
      Batch& to = with_ticks(ticks, moved.parked->run.scenario);
      to.waiting.push_back(std::move(moved));
    }
  }
  /// Which batch steps next. Full ones cost least a scenario; where there are too few for that, those behind catch
  /// up with the others. One that stays full goes on: what it reads is in the caches.
  Batch& next_batch() {
    if (last != nullptr && last->is_full()) return *last;
    last = most_urgent_beside(nullptr);
    return *last;
  }
  /// nullptr: no other one has anything to do.
  Batch* most_urgent_beside(const Batch* one) {
    const auto urgency = [&](const auto& each) {
      const Batch& of = *each.second;
      return std::tuple(&of != one && of.ready() > 0, of.is_full(), of.left_s());
    };
    Batch& most = *std::ranges::max_element(batch, {}, urgency)->second;
    return one != nullptr && (&most == one || most.ready() == 0) ? nullptr : &most;
  }
  void take_results(Batch& of) {
    for (const LaneSimulation::Finished& done : of.lanes.finished()) {
      const int at = std::exchange(of.place[static_cast<std::size_t>(done.lane)], Batch::kFree);
      busy[static_cast<std::size_t>(at)] = false;
      finished.push_back({at, done.result});
    }
  }
  /// Acts on the lane of a place that was just loaded, now or when it has one.
  void once_loaded(int place, std::function<void(LaneSimulation&, int lane)> act) {
    const auto lane = std::ranges::find(first().place, place);
    if (lane != first().place.end()) return act(first().lanes, static_cast<int>(lane - first().place.begin()));
    const auto waits = std::ranges::find(first().waiting, place, &Waiting::place);
    require(waits != first().waiting.end(), "LevelSimulation: nothing was loaded into the place");
    waits->once_loaded.push_back(std::move(act));
  }

  std::shared_ptr<const Model> model;
  Longer longer;
  std::map<int, std::unique_ptr<Batch>> batch;  ///< by ticks
  Batch* last = nullptr;                        ///< that took a step
  std::array<bool, kPlaces> busy{};
  std::vector<Finished> finished;
  int stepped = 0, stepped_batches = 0;
  bool timing = false;
};

LevelSimulation::LevelSimulation(std::shared_ptr<const Model> model, Longer longer)
    : impl_(std::make_unique<Impl>(std::move(model), std::move(longer))) {}
LevelSimulation::~LevelSimulation() = default;

void LevelSimulation::load(int place, const Scenario& scenario) {
  require(place >= 0 && place < kPlaces, "LevelSimulation::load: there is no such place");
  bool& busy = impl_->busy[static_cast<std::size_t>(place)];
  require(!busy, "LevelSimulation::load: the place is busy");
  Batch& first = impl_->first();
  first.waiting.push_back({place, scenario, nullptr, {}, HUGE_VAL});
  first.fill();
  busy = true;
}

bool LevelSimulation::busy(int place) const {
  return place >= 0 && place < kPlaces && impl_->busy[static_cast<std::size_t>(place)];
}

void LevelSimulation::record(int place, const Recording& kept) {
  impl_->once_loaded(place, [kept](LaneSimulation& lanes, int lane) { lanes.record(lane, kept); });
}

void LevelSimulation::step(const BothAtOnce& both) {
  impl_->finished.clear();
  Batch& batch = impl_->next_batch();
  Batch* const other = both ? impl_->most_urgent_beside(&batch) : nullptr;
  batch.fill();
  impl_->stepped = batch.busy();
  impl_->stepped_batches = other != nullptr ? 2 : 1;
  if (other != nullptr) {
    other->fill();
    impl_->stepped += other->busy();
    both([other] { other->lanes.step(); }, [&batch] { batch.lanes.step(); });
  } else {
    batch.lanes.step();
  }
  for (Batch* const each : {&batch, other}) {
    if (each != nullptr) impl_->take_results(*each);
  }
  for (Batch* const each : {&batch, other}) {
    if (each != nullptr) impl_->send_on(*each);
  }
}

int LevelSimulation::stepped() const { return impl_->stepped; }
int LevelSimulation::stepped_batches() const { return impl_->stepped_batches; }
const std::vector<LevelSimulation::Finished>& LevelSimulation::finished() const { return impl_->finished; }

void LevelSimulation::enable_timing() {
  impl_->timing = true;
  for (auto& [ticks, batch] : impl_->batch) batch->lanes.enable_timing();
}

LaneSimulation::PartTimes LevelSimulation::part_times() const {
  LaneSimulation::PartTimes sum;
  for (const auto& [ticks, batch] : impl_->batch) sum += batch->lanes.part_times();
  return sum;
}

LaneSimulation::PartTimes& LaneSimulation::PartTimes::operator+=(const PartTimes& other) {
  right_hand_side_s += other.right_hand_side_s;
  solve_s += other.solve_s;
  contact_s += other.contact_s;
  plasticity_s += other.plasticity_s;
  update_s += other.update_s;
  lane_steps += other.lane_steps;
  steps += other.steps;
  return *this;
}

int level_place_count() { return kPlaces; }

}  // namespace unbruised
