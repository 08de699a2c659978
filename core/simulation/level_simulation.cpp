#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "core/door/require.hpp"
#include "core/lanes/lane_packs.hpp"
#include "core/simulation/parked_scenario.hpp"
#include "core/simulation/simulation.hpp"

namespace unbruised {
namespace {

/// With as many in flight one of the batches is full, and some wait for it: scenarios of a model have three step
/// lengths at most (step_levels.hpp).
constexpr int kPlaces = 4 * kLanes;
/// Of each of two threads in one call: few enough that new scenarios need not wait long, many enough that threads
/// hardly ever wait for each other.
constexpr int kStepsAtOnce = 8;

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
  std::vector<Waiting> waiting;
  bool in_use = false;  ///< by one of two threads

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
  /// Gives lanes to those who are furthest behind, and takes them from those who are not; guests have theirs once
  /// they are `let_in`. So lanes of a step are in like phases: a batch sweeps its contacts as long as the slowest
  /// of its lanes, over all that any of them touches.
  std::vector<std::pair<int, Waiting>> invite() {
    make_room();
    std::vector<std::pair<int, Waiting>> guests;
    for (int lane = free_lane(); lane < kLanes && !waiting.empty(); lane = free_lane()) {
      const auto next = std::ranges::max_element(waiting, {}, &Waiting::left_s);
      place[static_cast<std::size_t>(lane)] = next->place;
      guests.emplace_back(lane, std::move(*next));
      waiting.erase(next);
    }
    return guests;
  }
  /// Where a lane is free anyway those of the others who are ahead of somebody who waits have to wait. A few
  /// gather in the first lanes, which are stepped as one narrow pack.
  void make_room() {
    if (ready() <= NarrowPack::size) {
      for (int lane = NarrowPack::size; lane < kLanes; ++lane) {
        if (place[static_cast<std::size_t>(lane)] != kFree) waiting.push_back(take(lane));
      }
    }
    if (waiting.empty() || free_lane() == kLanes) return;
    constexpr int kWaits = -1;
    std::vector<std::pair<double, int>> order;  // time left, lane
    for (const Waiting& each : waiting) order.emplace_back(each.left_s, kWaits);
    for (int lane = 0; lane < kLanes; ++lane) {
      if (place[static_cast<std::size_t>(lane)] != kFree) order.emplace_back(lanes.time_left_s(lane), lane);
    }
    std::ranges::sort(order, std::greater());
    for (std::size_t i = kLanes; i < order.size(); ++i) {
      if (order[i].second != kWaits) waiting.push_back(take(order[i].second));
    }
  }
  /// A scenario out of its lane.
  Waiting take(int lane) {
    const double left_s = lanes.time_left_s(lane);
    const int from = std::exchange(place[static_cast<std::size_t>(lane)], kFree);
    return {from, std::nullopt, lanes.take(lane), {}, left_s};
  }
  void let_in(std::vector<std::pair<int, Waiting>> guests) {
    for (auto& [lane, guest] : guests) {
      guest.fresh ? lanes.load(lane, *guest.fresh) : lanes.put(lane, *guest.parked);
      for (const auto& act : guest.once_loaded) act(lanes, lane);
    }
  }
  void fill() { let_in(invite()); }
};

/// What has left a batch after a step.
struct Leaving {
  struct Moved {
    int ticks;
    Waiting scenario;
  };
  std::vector<Moved> moved;
  std::vector<LevelSimulation::Finished> finished;
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
  /// Takes out who has finished or wants steps of another length.
  static Leaving let_go(Batch& from) {
    Leaving leaving;
    for (const LaneSimulation::Finished& done : from.lanes.finished()) {
      const int at = std::exchange(from.place[static_cast<std::size_t>(done.lane)], Batch::kFree);
      leaving.finished.push_back({at, done.result});
    }
    for (int lane = 0; lane < kLanes; ++lane) {
      if (from.place[static_cast<std::size_t>(lane)] == Batch::kFree) continue;
      const int ticks = from.lanes.next_ticks(lane);
      if (ticks == from.lanes.ticks()) continue;
      leaving.moved.push_back({ticks, from.take(lane)});
    }
    return leaving;
  }
  void hand_over(Leaving leaving) {
    for (Finished& done : leaving.finished) {
      busy[static_cast<std::size_t>(done.place)] = false;
      finished.push_back(std::move(done));
    }
    for (Leaving::Moved& each : leaving.moved) {
      Batch& to = with_ticks(each.ticks, each.scenario.parked->run.scenario);
      to.waiting.push_back(std::move(each.scenario));
    }
  }
  void begin_call() {
    finished.clear();
    stepped = stepped_batches = 0;
  }
  void count(const Batch& of) {
    stepped += of.ready();
    ++stepped_batches;
  }
  /// New scenarios begin together, as soon as they fill a batch or there are lanes to spare: those that run side
  /// by side from the start stay in like phases.
  void begin_fresh() {
    const auto loaded = static_cast<std::size_t>(std::ranges::count(busy, true));
    if (loaded - fresh.size() > kPlaces - kLanes) return;
    std::ranges::move(fresh, std::back_inserter(first().waiting));
    fresh.clear();
  }
  /// Which batch steps next. Full ones cost least a scenario; where there are too few for that, those behind catch
  /// up with the others. One that keeps all its lanes goes on: what it reads is in the caches.
  Batch* next_batch() {
    begin_fresh();
    if (last == nullptr || last->busy() < kLanes) last = most_urgent();
    return last;
  }
  /// Of those that no thread works with; nullptr: none of these has anything to do.
  Batch* most_urgent() {
    const auto urgency = [](const auto& each) {
      const Batch& of = *each.second;
      return of.in_use ? std::tuple(false, false, 0.0) : std::tuple(of.ready() > 0, of.is_full(), of.left_s());
    };
    Batch& most = *std::ranges::max_element(batch, {}, urgency)->second;
    return most.in_use || most.ready() == 0 ? nullptr : &most;
  }

  /// One of two threads: takes steps with one batch after the other.
  void serve(const TwoThreads& threads) {
    try {
      Leaving leaving;
      Batch* mine = nullptr;
      for (int step = 0;; ++step) {
        std::vector<std::pair<int, Waiting>> guests;
        threads.alone([&] {
          if (mine != nullptr) mine->in_use = false;
          hand_over(std::exchange(leaving, {}));
          begin_fresh();
          mine = step < kStepsAtOnce && !is_call_over() ? most_urgent() : nullptr;
          is_one_gone = is_one_gone || mine == nullptr;
          if (mine == nullptr) return;
          mine->in_use = true;
          count(*mine);
          guests = mine->invite();
        });
        if (mine == nullptr) return;
        mine->let_in(std::move(guests));
        mine->lanes.step();
        leaving = let_go(*mine);
      }
    } catch (...) {
      threads.alone([this] { failed = true; });
      throw;
    }
  }
  /// Somebody waits for what has finished, or the other thread for what this one has now.
  [[nodiscard]] bool is_call_over() {
    if (failed || !finished.empty()) return true;
    const auto has_work = [](const auto& each) { return !each.second->in_use && each.second->ready() > 0; };
    return is_one_gone && std::ranges::count_if(batch, has_work) > 1;
  }

  /// Acts on the lane of a place that was just loaded, when it has one.
  void once_loaded(int place, std::function<void(LaneSimulation&, int lane)> act) {
    const auto waits = std::ranges::find(fresh, place, &Waiting::place);
    require(waits != fresh.end(), "LevelSimulation: nothing was loaded into the place");
    waits->once_loaded.push_back(std::move(act));
  }

  std::shared_ptr<const Model> model;
  Longer longer;
  std::map<int, std::unique_ptr<Batch>> batch;  ///< by ticks
  std::vector<Waiting> fresh;                   ///< not begun
  Batch* last = nullptr;                        ///< that took a step
  std::array<bool, kPlaces> busy{};
  std::vector<Finished> finished;
  int stepped = 0, stepped_batches = 0;
  bool is_one_gone = false;  ///< of two threads
  bool failed = false;       ///< one of them has thrown
  bool timing = false;
};

LevelSimulation::LevelSimulation(std::shared_ptr<const Model> model, Longer longer)
    : impl_(std::make_unique<Impl>(std::move(model), std::move(longer))) {}
LevelSimulation::~LevelSimulation() = default;

void LevelSimulation::load(int place, const Scenario& scenario) {
  require(place >= 0 && place < kPlaces, "LevelSimulation::load: there is no such place");
  bool& busy = impl_->busy[static_cast<std::size_t>(place)];
  require(!busy, "LevelSimulation::load: the place is busy");
  impl_->fresh.push_back({place, scenario, nullptr, {}, HUGE_VAL});
  busy = true;
}

bool LevelSimulation::busy(int place) const {
  return place >= 0 && place < kPlaces && impl_->busy[static_cast<std::size_t>(place)];
}

void LevelSimulation::record(int place, const Recording& kept) {
  impl_->once_loaded(place, [kept](LaneSimulation& lanes, int lane) { lanes.record(lane, kept); });
}

void LevelSimulation::step() {
  impl_->begin_call();
  Batch* const batch = impl_->next_batch();
  if (batch == nullptr) return;
  impl_->count(*batch);
  batch->fill();
  batch->lanes.step();
  impl_->hand_over(Impl::let_go(*batch));
}

void LevelSimulation::step(const TwoThreads& threads) {
  impl_->begin_call();
  impl_->is_one_gone = false;
  const auto serve = [this, &threads] { impl_->serve(threads); };
  threads.both(serve, serve);
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
