#include "studies/kinds/curve_rounds.hpp"

#include <algorithm>
#include <map>
#include <thread>
#include <utility>

#include "studies/execution/batch_runner.hpp"

namespace unbruised::studies {

CurveRounds::CurveRounds(const KindInput& input) : input_(input), recorded_(input.journal.rows().held()) {
  for (const SearchVariable& key : input.study.variables()) keys_.push_back(key.key);
}

void CurveRounds::run(std::size_t fits, const std::function<void(std::size_t fit)>& work) {
  calls_.assign(fits, {});
  running_ = fits;
  std::vector<std::thread> threads;
  for (std::size_t fit = 0; fit < fits; ++fit) {
    threads.emplace_back([&, fit] {
      try {
        work(fit);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        stopped_ = true;
      }
      end_fit();
    });
  }
  for (std::thread& thread : threads) thread.join();
  if (failure_) std::rethrow_exception(failure_);
}

std::optional<std::vector<Curve>> CurveRounds::ask(std::size_t fit,
                                                   const std::vector<std::vector<double>>& points) {
  std::unique_lock lock(mutex_);
  Call& call = calls_[fit];
  call = {.points = &points, .curves = {}, .is_answered = false};
  ++waiting_;
  if (all_wait()) run_round();
  answered_.wait(lock, [&] { return call.is_answered; });
  if (stopped_) return std::nullopt;
  return std::move(call.curves);
}

bool CurveRounds::all_wait() const { return waiting_ > 0 && waiting_ == running_; }

void CurveRounds::end_fit() {
  const std::lock_guard lock(mutex_);
  --running_;
  if (all_wait()) run_round();
}

/// Everybody waits, so that nobody misses the lock. Equal points of several fits are one scenario.
void CurveRounds::run_round() {
  std::map<std::vector<double>, std::size_t> place_of;
  std::vector<const std::vector<double>*> points;
  for (const Call& call : calls_) {
    if (call.is_answered) continue;
    for (const std::vector<double>& point : *call.points) {
      if (place_of.try_emplace(point, points.size()).second) points.push_back(&point);
    }
  }
  std::vector<Curve> curves(points.size());
  try {
    if (!stopped_) simulate(points, curves);
  } catch (...) {
    if (!failure_) failure_ = std::current_exception();
    stopped_ = true;
  }
  for (Call& call : calls_) {
    if (call.is_answered) continue;
    for (const std::vector<double>& point : *call.points) call.curves.push_back(curves[place_of.at(point)]);
    call.is_answered = true;
  }
  waiting_ = 0;
  answered_.notify_all();
}

void CurveRounds::simulate(const std::vector<const std::vector<double>*>& points, std::vector<Curve>& curves) {
  const std::uint64_t first_id = next_id_;
  next_id_ += points.size();
  const auto inputs_of = [&](std::uint64_t id) {
    const std::vector<double>& point = *points[id - first_id];
    return std::vector<InputValue>(point.begin(), point.end());
  };
  Batch batch{
      .ids = {},
      .scenario = [&](std::uint64_t id) { return input_.study.scenario_with(keys_, *points[id - first_id]); },
      .curve = [&](std::uint64_t id) -> Curve& { return curves[id - first_id]; },
      .stop = input_.stop};
  std::size_t known = 0;
  for (std::uint64_t id = first_id; id < next_id_; ++id) {
    batch.ids.push_back(id);
    if (!input_.journal.is_done(id)) continue;
    ++known;
    const auto row = std::ranges::lower_bound(recorded_, id, {}, &ScenarioRow::id);
    const bool is_recorded = row != recorded_.end() && row->id == id;
    if (is_recorded && row->inputs != inputs_of(id)) throw input_.journal.foreign_record(id);
  }
  input_.journal.expect(points.size(), known);
  const BatchReport done = run_batch(input_.executor, batch, [&](std::uint64_t id, const ScenarioResult& result) {
    if (!input_.journal.is_done(id)) input_.journal.record({.id = id, .result = result, .inputs = inputs_of(id)});
    const bool is_believed = result.outcome != Outcome::diverged && result.outcome != Outcome::out_of_range;
    if (!is_believed) curves[id - first_id] = {};
  });
  lane_use_.add(done.lane_use);
  stopped_ = done.stopped;
}

}  // namespace unbruised::studies
