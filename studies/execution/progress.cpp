#include "studies/execution/progress.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <unistd.h>

#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

constexpr std::chrono::milliseconds kBarInterval{200};
constexpr std::size_t kBarCells = 20;

}  // namespace

ProgressStyle progress_style(int descriptor, bool quiet) {
  if (quiet) return ProgressStyle::none;
  const char* term = std::getenv("TERM");
  const bool dumb = term == nullptr || std::string_view(term) == "dumb";
  return ::isatty(descriptor) != 0 && !dumb ? ProgressStyle::bar : ProgressStyle::lines;
}

std::string progress_text(const ProgressState& state) {
  std::string text = joined(
      {std::to_string(state.done), "/", std::to_string(state.total), state.total_is_final ? "" : " so far"});
  if (state.done_at_start > 0) text += joined({" (", std::to_string(state.done_at_start), " of an earlier run)"});
  const auto run_now = static_cast<double>(state.done - state.done_at_start);
  if (run_now > 0.0 && state.seconds > 0.0) {
    const double rate = run_now / state.seconds;
    text += joined({", ", short_number(rate), "/s"});
    const auto left = static_cast<double>(state.total - std::min(state.done, state.total));
    if (state.total_is_final) text += joined({", ", duration_text(left / rate), " left"});
  }
  std::string separator = "; ";
  for (std::size_t i = 0; i < state.outcomes.size(); ++i) {
    if (state.outcomes[i] == 0) continue;
    text += joined({separator, kOutcomeWords[i], " ", std::to_string(state.outcomes[i])});
    separator = ", ";
  }
  return text;
}

std::string progress_bar(const ProgressState& state) {
  const std::size_t full = state.total == 0 ? 0 : kBarCells * std::min(state.done, state.total) / state.total;
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

void Progress::count(Outcome outcome) {
  const std::lock_guard lock(mutex_);
  ++state_.done;
  if (outcome != Outcome::not_run) ++state_.outcomes[static_cast<std::size_t>(outcome)];
}

void Progress::close() {
  if (!printer_.joinable()) return;
  printer_.request_stop();
  printer_.join();
  if (style_ == ProgressStyle::bar) write_("\r\x1b[K");
}

ProgressState Progress::snapshot() const {
  const std::lock_guard lock(mutex_);
  ProgressState state = state_;
  state.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  return state;
}

void Progress::print_until_closed(const std::stop_token& stop) {
  while (true) {
    {
      std::unique_lock lock(mutex_);
      closing_.wait_for(lock, stop, interval_, [] { return false; });
    }
    if (stop.stop_requested()) return;
    print();
  }
}

void Progress::print() {
  const ProgressState state = snapshot();
  if (style_ == ProgressStyle::bar) {
    write_(joined({"\r\x1b[K", progress_bar(state)}));
  } else {
    write_(joined({progress_text(state), "\n"}));
  }
}

}  // namespace unbruised::studies
