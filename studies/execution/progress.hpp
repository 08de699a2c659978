#pragma once

/// @file
/// How far a study is, on stderr: a bar on a terminal, else a plain line every 30 s.

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "core/outcome/outcome.hpp"

namespace unbruised::studies {

enum class ProgressStyle { none, bar, lines };

/// none when quiet; a bar when `descriptor` is a terminal whose TERM is not "dumb"; else lines. There are no
/// colours, so NO_COLOR has nothing to switch off.
ProgressStyle progress_style(int descriptor, bool quiet);

/// What a progress line says.
struct ProgressState {
  std::size_t done = 0;
  std::size_t total = 0;          ///< as far as it is known yet
  bool total_is_final = true;     ///< false: a search that will ask for more
  std::size_t done_at_start = 0;  ///< found in the journal of an earlier run
  double seconds = 0.0;           ///< since the start
  std::array<std::size_t, kOutcomeWords.size()> outcomes{};
};

/// "412/1024 (100 of an earlier run), 23.1/s, 27 s left; held 200, damaged 112": outcomes are those of this run.
std::string progress_text(const ProgressState& state);
/// "[########------------] " and the text.
std::string progress_bar(const ProgressState& state);

/// Thread-safe; prints from a thread of its own, so counting costs nothing.
class Progress {
 public:
  using Writer = std::function<void(std::string_view)>;
  Progress(ProgressStyle style, Writer write, std::chrono::milliseconds line_interval = std::chrono::seconds(30));
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// More work is known; `already_done` of it needs no running.
  void expect(std::size_t more, std::size_t already_done);
  void total_may_grow();
  void count(Outcome outcome);
  /// Removes the bar; prints nothing more.
  void close();

 private:
  [[nodiscard]] ProgressState snapshot() const;
  void print_until_closed(const std::stop_token& stop);
  void print();

  const ProgressStyle style_;
  const Writer write_;
  const std::chrono::milliseconds interval_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  mutable std::mutex mutex_;
  std::condition_variable_any closing_;
  ProgressState state_;
  std::jthread printer_;
};

}  // namespace unbruised::studies
