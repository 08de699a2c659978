#include "studies/execution/progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <unistd.h>

#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

constexpr std::chrono::milliseconds kBarInterval{200};
/// Off a terminal the first line comes soon, so that somebody who waits learns how long.
constexpr std::chrono::milliseconds kFirstLine{5000};
constexpr std::size_t kBarCells = 20;
/// As many scenarios as this have to end before what they took counts more than what was expected: those that end
/// first are the ones that failed early.
constexpr double kPlannedWeight = 32.0;

/// "23.1 per second"; where that is less than one, how long each takes.
std::string rate_text(double per_second) {
  if (per_second >= 1.0) return joined({three_digits(per_second), " per second"});
  return joined({"one in ", duration_text(1.0 / per_second)});
}

}  // namespace

ProgressStyle progress_style(int descriptor, Verbosity verbosity) {
  if (verbosity == Verbosity::quiet) return ProgressStyle::none;
  const char* term = std::getenv("TERM");
  const bool dumb = term == nullptr || std::string_view(term) == "dumb";
  return ::isatty(descriptor) != 0 && !dumb ? ProgressStyle::bar : ProgressStyle::lines;
}

std::optional<double> seconds_left(const ProgressState& state) {
  const ProgressPlan& plan = state.plan;
  const double total = state.total_is_final ? static_cast<double>(state.total)
                                            : std::max(plan.scenarios, static_cast<double>(state.total));
  const double left = std::max(total - static_cast<double>(state.done), 0.0);
  const auto ended = static_cast<double>(state.done - state.done_at_start);
  if (!state.total_is_final && plan.scenarios <= 0.0) return std::nullopt;
  if (plan.steps_each <= 0.0) {  // nothing is known of the steps: by scenarios
    if (ended <= 0.0 || state.seconds <= 0.0) return std::nullopt;
    return left * state.seconds / ended;
  }
  const double each = (kPlannedWeight * plan.steps_each + state.steps_of_done) / (kPlannedWeight + ended);
  const double begun = state.steps - state.steps_of_done;
  const double steps_left = std::max(left * each - begun, 0.0);
  if (state.steps > 0.0 && state.seconds > 0.0) return steps_left * state.seconds / state.steps;
  if (plan.seconds_per_step <= 0.0) return std::nullopt;
  return steps_left * plan.seconds_per_step;
}

std::string progress_text(const ProgressState& state) {
  const ProgressPlan& plan = state.plan;
  std::string text = with_thousands(state.done);
  if (state.total_is_final) {
    text += joined({" of ", with_thousands(state.total)});
  } else if (plan.scenarios > 0.0) {
    const auto expected = static_cast<unsigned long long>(std::llround(plan.scenarios));
    text += joined({plan.may_end_sooner ? " of at most " : " of about ",
                    with_thousands(std::max<unsigned long long>(expected, state.total))});
  }
  text += " scenarios";
  if (state.done_at_start > 0) text += joined({" (", with_thousands(state.done_at_start), " of an earlier run)"});
  const auto run_now = static_cast<double>(state.done - state.done_at_start);
  if (run_now > 0.0 && state.seconds > 0.0) text += joined({", ", rate_text(run_now / state.seconds)});
  if (const auto left = seconds_left(state)) {
    text += joined({plan.may_end_sooner ? ", at most " : ", about ", duration_text(*left), " left"});
  }
  const std::string outcomes = counts_text(state.outcomes);
  return outcomes.empty() ? text : joined({text, "; ", outcomes});
}

std::string progress_bar(const ProgressState& state) {
  const auto planned = static_cast<std::size_t>(state.total_is_final ? 0.0 : state.plan.scenarios);
  const std::size_t total = std::max(state.total, planned);
  const std::size_t full = total == 0 ? 0 : kBarCells * std::min(state.done, total) / total;
  return joined({"[", std::string(full, '#'), std::string(kBarCells - full, '-'), "] ", progress_text(state)});
}

Progress::Progress(ProgressStyle style, Writer write, std::chrono::milliseconds line_interval)
    : style_(style),
      write_(std::move(write)),
      interval_(style == ProgressStyle::bar ? kBarInterval : line_interval) {
  if (style_ == ProgressStyle::none) return;
  printer_ = std::jthread([this](const std::stop_token& stop) { print_until_closed(stop); });
}

Progress::~Progress() { close(); }

void Progress::expect(std::size_t more, std::size_t already_done) {
  const std::lock_guard lock(mutex_);
  state_.total += more;
  state_.done += already_done;
  state_.done_at_start += already_done;
}

void Progress::total_may_grow() {
  const std::lock_guard lock(mutex_);
  state_.total_is_final = false;
}

void Progress::plan(const ProgressPlan& plan) {
  const std::lock_guard lock(mutex_);
  state_.plan = plan;
}

void Progress::count(Outcome outcome, double steps) {
  const std::lock_guard lock(mutex_);
  ++state_.done;
  if (!std::isnan(steps)) state_.steps_of_done += steps;
  state_.outcomes.add(outcome);
}

void Progress::close() {
  if (!printer_.joinable()) return;
  printer_.request_stop();
  printer_.join();
  if (style_ == ProgressStyle::bar) write_("\r\x1b[K");
}

ProgressState Progress::state() const {
  const std::lock_guard lock(mutex_);
  ProgressState state = state_;
  state.steps = static_cast<double>(steps_.load(std::memory_order_relaxed));
  state.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  return state;
}

void Progress::print_until_closed(const std::stop_token& stop) {
  std::chrono::milliseconds wait = std::min(interval_, kFirstLine);
  while (true) {
    {
      std::unique_lock lock(mutex_);
      closing_.wait_for(lock, stop, std::exchange(wait, interval_), [] { return false; });
    }
    if (stop.stop_requested()) return;
    print();
  }
}

void Progress::print() {
  const ProgressState now = state();
  if (style_ == ProgressStyle::bar) {
    write_(joined({"\r\x1b[K", progress_bar(now)}));
  } else {
    write_(joined({progress_text(now), "\n"}));
  }
}

}  // namespace unbruised::studies
