#include "studies/execution/evaluation_broker.hpp"

#include <algorithm>
#include <exception>
#include <memory>
#include <thread>
#include <utility>
#include <variant>

#include "studies/results/bytes.hpp"

namespace unbruised::studies {
namespace {

/// Inputs as bytes that are equal exactly when the inputs are; -0 counts as 0.
std::string key_of(const std::vector<InputValue>& inputs) {
  ByteWriter bytes;
  for (const InputValue& input : inputs) {
    bytes.put(static_cast<std::uint8_t>(input.index()));
    if (const auto* number = std::get_if<double>(&input)) {
      bytes.put(*number + 0.0);
    } else {
      bytes.put_text(std::get<std::string>(input));
    }
  }
  return bytes.text();
}

}  // namespace

EvaluationBroker::EvaluationBroker(const Simulator& simulator, const std::vector<ScenarioRow>& recorded,
                                   Recorder recorder, Options options)
    : simulator_(simulator), recorder_(std::move(recorder)), options_(options) {
  for (const ScenarioRow& row : recorded) {
    recorded_.emplace(journal_id(row), &row);
    memory_.emplace(key_of(row.inputs), row.result);
  }
}

void EvaluationBroker::run(const std::vector<std::function<void()>>& searches) {
  LaneScheduler scheduler(
      simulator_, [this](std::uint64_t ticket) { return scenario_of(ticket); },
      [this](std::uint64_t ticket, const ScenarioResult& result) { deliver(ticket, result); },
      {.threads = options_.threads, .stop = options_.stop, .grows = true});
  {
    const std::lock_guard lock(mutex_);
    scheduler_ = &scheduler;
    stage_over_ = false;
  }
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  const auto search_on = [&] {
    for (std::size_t i = next++; i < searches.size(); i = next++) {
      try {
        searches[i]();
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure) failure = std::current_exception();
        next = searches.size();
        scheduler.abort();
      }
    }
  };
  {
    const std::size_t count = std::min(searches.size(), options_.concurrent_searches);
    std::atomic<std::size_t> running = count;
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < count; ++i) {
      threads.emplace_back([&] {
        search_on();
        if (--running == 0) scheduler.close();
      });
    }
    if (count == 0) scheduler.close();
    scheduler.run_workers();
    {
      // Nothing more will be answered: whoever still waits is told so.
      const std::lock_guard lock(mutex_);
      stage_over_ = true;
    }
    answered_.notify_all();
  }
  const std::lock_guard lock(mutex_);
  const LaneUse use = scheduler.lane_use();
  counts_.lane_use.busy_lane_steps += use.busy_lane_steps;
  counts_.lane_use.lane_steps += use.lane_steps;
  scheduler_ = nullptr;
  flights_.clear();
  flight_of_key_.clear();
  if (failure) std::rethrow_exception(failure);
  scheduler.rethrow_failure();
}

std::optional<std::vector<ScenarioResult>> EvaluationBroker::ask(const std::vector<BrokerQuestion>& questions) {
  // Shared: when a question is refused halfway, those before it may still be in flight.
  const auto call = std::make_shared<Call>();
  call->answers.resize(questions.size());
  std::vector<std::uint64_t> to_run;
  LaneScheduler* scheduler = nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (stage_over_ || stopping()) return std::nullopt;
    scheduler = scheduler_;
    call->missing = questions.size();
    for (std::size_t i = 0; i < questions.size(); ++i) take_in(questions[i], call, i, to_run);
  }
  if (!to_run.empty()) scheduler->add(to_run);
  std::unique_lock lock(mutex_);
  answered_.wait(lock, [&] { return call->missing == 0 || stage_over_; });
  if (call->missing > 0) return std::nullopt;
  return std::move(call->answers);
}

EvaluationBroker::Counts EvaluationBroker::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

/// Answers a question at once where it can be, else joins or starts the flight of its scenario.
void EvaluationBroker::take_in(const BrokerQuestion& question, const std::shared_ptr<Call>& call,
                               std::size_t index, std::vector<std::uint64_t>& to_run) {
  ++counts_.questions;
  const Asker asker{call, index, question.place};
  if (const auto found = recorded_.find(journal_id(question.place)); found != recorded_.end()) {
    if (key_of(found->second->inputs) != key_of(question.inputs)) throw ForeignRecord{question.place};
    ++counts_.recorded;
    call->answers[index] = found->second->result;
    --call->missing;
    return;
  }
  std::string key = key_of(question.inputs);
  if (const auto known = memory_.find(key); known != memory_.end()) {
    answer(asker, known->second, question.inputs, true);
    return;
  }
  const auto [place, is_new] = flight_of_key_.try_emplace(key, next_ticket_);
  if (!is_new) {
    flights_.at(place->second).askers.push_back(asker);
    return;
  }
  flights_.emplace(next_ticket_, Flight{question.scenario, std::move(key), question.inputs, {asker}});
  to_run.push_back(next_ticket_++);
}

void EvaluationBroker::deliver(std::uint64_t ticket, const ScenarioResult& result) {
  {
    const std::lock_guard lock(mutex_);
    const Flight flight = std::move(flights_.at(ticket));
    flights_.erase(ticket);
    flight_of_key_.erase(flight.key);
    memory_.emplace(flight.key, result);
    ++counts_.simulated;
    bool from_memory = false;
    for (const Asker& asker : flight.askers) {
      answer(asker, result, flight.inputs, from_memory);
      from_memory = true;
    }
  }
  answered_.notify_all();
}

/// Every question is a row of its own, so that the rows do not depend on who asked first.
void EvaluationBroker::answer(const Asker& asker, const ScenarioResult& result,
                              const std::vector<InputValue>& inputs, bool from_memory) {
  if (from_memory) ++counts_.from_memory;
  recorder_({.id = journal_id(asker.place), .result = result, .inputs = inputs}, from_memory);
  asker.call->answers[asker.index] = result;
  --asker.call->missing;
}

Scenario EvaluationBroker::scenario_of(std::uint64_t ticket) const {
  const std::lock_guard lock(mutex_);
  return flights_.at(ticket).scenario;
}

bool EvaluationBroker::stopping() const {
  return options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed);
}

}  // namespace unbruised::studies
