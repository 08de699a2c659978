#pragma once

/// @file
/// How far a study is and how long it will take still, on stderr: a bar on a terminal, else a plain line after
/// five seconds and every half a minute.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "core/outcome/outcome.hpp"
#include "studies/results/outcome_counts.hpp"

namespace unbruised::studies {

enum class ProgressStyle { none, bar, lines };

/// How much the user wants to be told.
enum class Verbosity { usual, quiet };

/// none when quiet; a bar when `descriptor` is a terminal whose TERM is not "dumb"; else lines. There are no
/// colours, so NO_COLOR has nothing to switch off.
ProgressStyle progress_style(int descriptor, Verbosity verbosity);

/// What is expected of a study before it runs (studies/estimate); zeros where nothing is known.
struct ProgressPlan {
  double scenarios = 0.0;         ///< of a search: at most
  double steps_each = 0.0;        ///< time steps of a scenario, on average
  double seconds_per_step = 0.0;  ///< of one lane, all threads working: a guess that the first steps replace
  bool may_end_sooner = false;    ///< a search may need fewer scenarios than that
};

/// What a progress line says.
struct ProgressState {
  std::size_t done = 0;
  std::size_t total = 0;          ///< as far as it is known yet
  bool total_is_final = true;     ///< false: a search that will ask for more
  std::size_t done_at_start = 0;  ///< found in the journal of an earlier run
  double seconds = 0.0;           ///< since the start
  double steps = 0.0;             ///< made in this run, those of unfinished scenarios too
  double steps_of_done = 0.0;     ///< of them, those of scenarios that ended
  ProgressPlan plan{};
  OutcomeCounts outcomes{};
};

/// Seconds that the rest will take, from the steps made so far and those still to make: of scenarios in the mean
/// of what was expected and what those that ended took. Before the first step from the plan's guess. Nothing when
/// neither is known.
std::optional<double> seconds_left(const ProgressState& state);

/// "412 of 1,024 scenarios (100 of an earlier run), 23.1 per second, about 27 s left; held 200, damaged 112":
/// outcomes are those of this run.
std::string progress_text(const ProgressState& state);
/// "[########------------] " and the text.
std::string progress_bar(const ProgressState& state);

/// Thread-safe; prints from a thread of its own, so counting costs nothing.
class Progress {
 public:
  using Writer = std::function<void(std::string_view)>;
  Progress(ProgressStyle style, Writer write, std::chrono::milliseconds line_interval = std::chrono::seconds(30));
  /// What is expected; before the study runs.
  void plan(const ProgressPlan& plan);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// More work is known; `already_done` of it needs no running.
  void expect(std::size_t more, std::size_t already_done);
  void total_may_grow();
  /// @param steps time steps it took, NaN: unknown
  void count(Outcome outcome, double steps);
  /// Time steps of lanes, as they are made; costs next to nothing.
  void count_steps(std::size_t steps) { steps_.fetch_add(steps, std::memory_order_relaxed); }
  /// Steps counted so far.
  [[nodiscard]] std::uint64_t steps() const { return steps_.load(std::memory_order_relaxed); }
  /// How far the study is now.
  [[nodiscard]] ProgressState state() const;
  /// Removes the bar; prints nothing more.
  void close();

 private:
  void print_until_closed(const std::stop_token& stop);
  void print();

  const ProgressStyle style_;
  const Writer write_;
  const std::chrono::milliseconds interval_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<std::uint64_t> steps_ = 0;
  mutable std::mutex mutex_;
  std::condition_variable_any closing_;
  ProgressState state_;
  std::jthread printer_;
};

}  // namespace unbruised::studies
