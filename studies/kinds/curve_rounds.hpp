#pragma once

/// @file
/// Many fits at once: each asks for curves and waits, and when all that are not done wait, their questions run as
/// one batch. What is asked in a round depends on the answers alone, so that scenarios have the same numbers, and
/// the fits take the same ways, whatever the threads do.

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/outcome/curve.hpp"
#include "studies/kinds/kind_table.hpp"

namespace unbruised::studies {

class CurveRounds {
 public:
  /// @param input must outlive it
  explicit CurveRounds(const KindInput& input);

  /// Runs fits, each on a thread of its own, until all have returned. Each asks through `ask` with its own
  /// number. Rethrows what the journal or a fit threw.
  void run(std::size_t fits, const std::function<void(std::size_t fit)>& work);

  /// The curves at points in the keys' own units, empty where a run diverged or is out of range; nothing: the
  /// study is being stopped. From inside `run`.
  std::optional<std::vector<Curve>> ask(std::size_t fit, const std::vector<std::vector<double>>& points);

  [[nodiscard]] bool is_stopped() const { return stopped_; }
  [[nodiscard]] const LaneUse& lane_use() const { return lane_use_; }

 private:
  /// One call of `ask`.
  struct Call {
    const std::vector<std::vector<double>>* points = nullptr;
    std::vector<Curve> curves;
    bool is_answered = true;
  };

  void run_round();
  void simulate(const std::vector<const std::vector<double>*>& points, std::vector<Curve>& curves);
  [[nodiscard]] bool all_wait() const;
  void end_fit();

  const KindInput& input_;
  std::vector<std::string> keys_;
  std::vector<ScenarioRow> recorded_;  ///< of an interrupted run, by id

  std::mutex mutex_;
  std::condition_variable answered_;
  std::vector<Call> calls_;  ///< of each fit
  std::size_t running_ = 0;  ///< fits that have not returned
  std::size_t waiting_ = 0;
  std::uint64_t next_id_ = 0;
  bool stopped_ = false;
  std::exception_ptr failure_;
  LaneUse lane_use_;
};

}  // namespace unbruised::studies
