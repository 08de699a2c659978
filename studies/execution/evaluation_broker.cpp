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

/// Runs searches on threads, and closes the work when the last has returned.
class SearchThreads {
 public:
  using Searches = std::vector<std::function<void()>>;

  SearchThreads(const Searches& searches, std::size_t at_once, Work& work) : searches_(searches), work_(work) {
    const std::size_t count = std::min(searches.size(), at_once);
    running_ = count;
    if (count == 0) work.close();
    for (std::size_t i = 0; i < count; ++i) threads_.emplace_back([this] { search(); });
  }
  void join() { threads_.clear(); }
  /// After `join`.
  void rethrow_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void search() {
    for (std::size_t i = next_++; i < searches_.size(); i = next_++) {
      try {
        searches_[i]();
      } catch (...) {
        fail(std::current_exception());
      }
    }
    if (--running_ == 0) work_.close();
  }

  /// The first failure ends all others.
  void fail(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
    next_ = searches_.size();
    work_.abort();
  }

  const Searches& searches_;
  Work& work_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> running_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::vector<std::jthread> threads_;
};

}  // namespace

EvaluationBroker::EvaluationBroker(const Executor& executor, const std::vector<ScenarioRow>& recorded,
                                   Recorder recorder, Options options)
    : executor_(executor), write_(std::move(recorder)), options_(options) {
  for (const ScenarioRow& row : recorded) {
    recorded_.emplace(journal_id(row), &row);
    memory_.emplace(key_of(row.inputs), row.result);
  }
}

void EvaluationBroker::run(const std::vector<std::function<void()>>& searches) {
  const std::unique_ptr<Work> work = executor_.begin(
      {.scenario = [this](std::uint64_t ticket) { return scenario_of(ticket); },
       .sink = [this](std::uint64_t ticket, const ScenarioResult& result) { deliver(ticket, result); },
       .stop = options_.stop,
       .supply = Supply::growing});
  AnswerRecorder recorder(write_, [&] { work->abort(); });
  begin_stage(*work, recorder);
  SearchThreads threads(searches, options_.concurrent_searches, *work);
  WorkReport done;
  std::exception_ptr failure;
  try {
    done = work->run();
  } catch (...) {
    failure = std::current_exception();
  }
  recorder.finish();
  let_waiting_go();
  threads.join();
  end_stage(done.lane_use);
  threads.rethrow_failure();
  recorder.rethrow_failure();
  if (failure) std::rethrow_exception(failure);
}

void EvaluationBroker::begin_stage(Work& work, AnswerRecorder& recorder) {
  const std::lock_guard lock(mutex_);
  work_ = &work;
  recorder_ = &recorder;
  stage_over_ = false;
}

/// Nothing more will be answered: whoever still waits is told so.
void EvaluationBroker::let_waiting_go() {
  {
    const std::lock_guard lock(mutex_);
    stage_over_ = true;
  }
  answered_.notify_all();
}

void EvaluationBroker::end_stage(const LaneUse& use) {
  const std::lock_guard lock(mutex_);
  counts_.lane_use.add(use);
  work_ = nullptr;
  recorder_ = nullptr;
  flights_.clear();
  flight_of_key_.clear();
}

std::optional<std::vector<ScenarioResult>> EvaluationBroker::ask(const std::vector<BrokerQuestion>& questions) {
  // Shared: when a question is refused halfway, those before it may still be in flight.
  const auto call = std::make_shared<Call>();
  call->answers.resize(questions.size());
  std::vector<std::uint64_t> to_run;
  Work* work = nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (stage_over_ || stopping()) return std::nullopt;
    work = work_;
    call->missing = questions.size();
    for (std::size_t i = 0; i < questions.size(); ++i) take_in(questions[i], call, i, to_run);
  }
  if (!to_run.empty()) work->add(to_run);
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
    ++counts_.from_memory;
    write_down(asker, known->second, question.inputs);
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
  const std::lock_guard lock(mutex_);
  const Flight flight = std::move(flights_.at(ticket));
  flights_.erase(ticket);
  flight_of_key_.erase(flight.key);
  memory_.emplace(flight.key, result);
  ++counts_.simulated;
  counts_.from_memory += flight.askers.size() - 1;
  for (const Asker& asker : flight.askers) write_down(asker, result, flight.inputs);
}

/// Every question is a row of its own, so that the rows do not depend on who asked first. Queued under the mutex,
/// so that an answer from memory stands behind the one it is a copy of.
void EvaluationBroker::write_down(const Asker& asker, const ScenarioResult& result,
                                  const std::vector<InputValue>& inputs) {
  recorder_->put({.row = {.id = journal_id(asker.place), .result = result, .inputs = inputs},
                  .hand_out = [this, asker, result] { hand_out(asker, result); }});
}

void EvaluationBroker::hand_out(const Asker& asker, const ScenarioResult& result) {
  {
    const std::lock_guard lock(mutex_);
    asker.call->answers[asker.index] = result;
    --asker.call->missing;
  }
  answered_.notify_all();
}

Scenario EvaluationBroker::scenario_of(std::uint64_t ticket) const {
  const std::lock_guard lock(mutex_);
  return flights_.at(ticket).scenario;
}

bool EvaluationBroker::stopping() const {
  return options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed);
}

}  // namespace unbruised::studies
