#pragma once

/// @file
/// Answers the questions of many searches at once: what is recorded is not run again, what was asked before is
/// answered from memory, and the rest goes to an executor together with whatever else waits. An answer depends on
/// its question alone, so each search takes the same way whatever the timing and the executor. It is handed out
/// once it is written down.

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/outcome/outcome.hpp"
#include "core/scenario/scenario.hpp"
#include "studies/execution/answer_recorder.hpp"
#include "studies/execution/executor.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// One scenario that a search wants to know about.
struct BrokerQuestion {
  SearchPlace place;
  Scenario scenario;
  /// What the scenario was made from: two questions with equal inputs are the same question.
  std::vector<InputValue> inputs;
};

class EvaluationBroker {
 public:
  /// Keeps a finished evaluation; called once per question, calls are serialised and hold nobody up. An exception
  /// ends all searches and comes out of `run`.
  using Recorder = AnswerRecorder::Write;

  struct Options {
    const std::atomic<bool>* stop = nullptr;  ///< may be null
    /// > 0; searches that ask at the same time. One: they run one after the other.
    std::size_t concurrent_searches = 256;
  };

  /// @param executor, recorded rows of an interrupted run (ids as in the journal): they must outlive the broker.
  EvaluationBroker(const Executor& executor, const std::vector<ScenarioRow>& recorded, Recorder recorder,
                   Options options);

  /// Runs searches, each on a thread of its own, until all have returned. Each asks through `ask`. Rethrows what a
  /// recorder or a search threw. May be called again for a next stage; what was learnt is remembered.
  void run(const std::vector<std::function<void()>>& searches);

  /// Blocks until all questions are answered; results in their order. Nothing: the study is being stopped. To be
  /// called from inside a search. Throws `ForeignRecord` when a recorded row of the same place has other inputs.
  std::optional<std::vector<ScenarioResult>> ask(const std::vector<BrokerQuestion>& questions);

  /// A recorded evaluation that is another one than the search asks for.
  struct ForeignRecord {
    SearchPlace place;
  };

  /// Of all stages so far.
  struct Counts {
    std::size_t questions = 0;
    std::size_t recorded = 0;     ///< found in the journal
    std::size_t from_memory = 0;  ///< asked before by another search or generation
    std::size_t simulated = 0;
    LaneUse lane_use;
  };
  [[nodiscard]] Counts counts() const;

 private:
  /// One call of `ask`.
  struct Call {
    std::vector<ScenarioResult> answers;
    std::size_t missing = 0;
  };
  /// Who waits for a scenario in flight.
  struct Asker {
    std::shared_ptr<Call> call;
    std::size_t index;
    SearchPlace place;
  };
  struct Flight {
    Scenario scenario;
    std::string key;
    std::vector<InputValue> inputs;
    std::vector<Asker> askers;
  };

  void begin_stage(Work& work, AnswerRecorder& recorder);
  void let_waiting_go();
  void end_stage(const LaneUse& use);
  void take_in(const BrokerQuestion& question, const std::shared_ptr<Call>& call, std::size_t index,
               std::vector<std::uint64_t>& to_run);
  void deliver(std::uint64_t ticket, const ScenarioResult& result);
  void write_down(const Asker& asker, const ScenarioResult& result, const std::vector<InputValue>& inputs);
  void hand_out(const Asker& asker, const ScenarioResult& result);
  [[nodiscard]] Scenario scenario_of(std::uint64_t ticket) const;
  [[nodiscard]] bool stopping() const;

  const Executor& executor_;
  const Recorder write_;
  const Options options_;

  mutable std::mutex mutex_;
  std::condition_variable answered_;
  std::unordered_map<std::uint64_t, const ScenarioRow*> recorded_;  ///< by journal id
  std::unordered_map<std::string, ScenarioResult> memory_;          ///< by the bytes of the inputs
  std::unordered_map<std::string, std::uint64_t> flight_of_key_;
  std::unordered_map<std::uint64_t, Flight> flights_;  ///< by ticket
  std::uint64_t next_ticket_ = 0;
  Work* work_ = nullptr;                ///< of the stage that runs
  AnswerRecorder* recorder_ = nullptr;  ///< of the same
  bool stage_over_ = false;
  Counts counts_;
};

}  // namespace unbruised::studies
