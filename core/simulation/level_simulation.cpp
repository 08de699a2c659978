#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "core/door/require.hpp"
#include "core/lanes/lane.hpp"
#include "core/simulation/lane_observer.hpp"
#include "core/simulation/parked_scenario.hpp"
#include "core/simulation/simulation.hpp"

namespace unbruised {
namespace {

constexpr int kPlaces = 3 * kLanes;

/// Who waits for a lane: not begun, or between two steps.
struct Waiting {
  int place = 0;
  std::optional<Scenario> fresh;
  std::unique_ptr<ParkedScenario> parked;
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
  [[nodiscard]] int free_lane() const { return static_cast<int>(std::ranges::find(place, kFree) - place.begin()); }
  /// Lets those who wait into free lanes.
  void fill() {
    for (int lane = free_lane(); lane < kLanes && !waiting.empty(); lane = free_lane()) {
      Waiting next = std::move(waiting.front());
      waiting.pop_front();
      next.fresh ? lanes.load(lane, *next.fresh) : lanes.put(lane, *next.parked);
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
      Waiting moved{std::exchange(place, Batch::kFree), std::nullopt, from.lanes.take(lane)};
      Batch& to = with_ticks(ticks, moved.parked->run.scenario);
      to.waiting.push_back(std::move(moved));
    }
  }
  int lane_of(int place) {
    first().fill();
    const auto at = std::ranges::find(first().place, place);
    require(at != first().place.end(), "LevelSimulation: the place has no lane");
    return static_cast<int>(at - first().place.begin());
  }

  std::shared_ptr<const Model> model;
  Longer longer;
  std::map<int, std::unique_ptr<Batch>> batch;  ///< by ticks
  std::array<bool, kPlaces> busy{};
  std::vector<Finished> finished;
  int stepped = 0;
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
  first.waiting.push_back({place, scenario, nullptr});
  first.fill();
  busy = true;
}

bool LevelSimulation::busy(int place) const {
  return place >= 0 && place < kPlaces && impl_->busy[static_cast<std::size_t>(place)];
}

void LevelSimulation::watch(int place, std::unique_ptr<LaneObserver> observer) {
  const int lane = impl_->lane_of(place);
  impl_->first().lanes.watch(lane, std::move(observer));
}

void LevelSimulation::record_trace(int place, Trace& trace) {
  const int lane = impl_->lane_of(place);
  impl_->first().lanes.record_trace(lane, trace);
}

void LevelSimulation::step() {
  impl_->finished.clear();
  const auto most =
      std::ranges::max_element(impl_->batch, {}, [](const auto& each) { return each.second->ready(); });
  Batch& batch = *most->second;
  batch.fill();
  impl_->stepped = batch.busy();
  batch.lanes.step();
  for (const LaneSimulation::Finished& done : batch.lanes.finished()) {
    const int place = std::exchange(batch.place[static_cast<std::size_t>(done.lane)], Batch::kFree);
    impl_->busy[static_cast<std::size_t>(place)] = false;
    impl_->finished.push_back({place, done.result});
  }
  impl_->send_on(batch);
}

int LevelSimulation::stepped() const { return impl_->stepped; }
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
