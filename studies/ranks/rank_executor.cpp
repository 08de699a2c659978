#include "studies/ranks/rank_executor.hpp"

#include <chrono>
#include <utility>

#include "studies/execution/build_info.hpp"
#include "studies/execution/lone_run.hpp"
#include "studies/ranks/rank_work.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

constexpr std::chrono::milliseconds kReceiveWait{50};
/// Within which every rank has started.
constexpr std::chrono::seconds kMeetWait{120};

}  // namespace

FirstRank::~FirstRank() {
  if (stopped_) return;
  for (int rank = 1; rank < link_.size(); ++rank) link_.send(rank, bytes_of(RankEnd{}));
  link_.leave();
}

RankExecutor::RankExecutor(FirstRank& first, const Simulator& simulator, int threads, CountSteps count_steps)
    : first_(first),
      link_(first.link()),
      simulator_(simulator),
      count_steps_(std::move(count_steps)),
      service_(simulator, threads, [this](RankAnswer answer) { deliver(0, std::move(answer)); }) {
  meet();
  receiver_ = std::jthread([this](const std::stop_token& stop) { receive_until(stop); });
}

RankExecutor::~RankExecutor() {
  receiver_.request_stop();
  receiver_.join();
  service_.drop();
}

/// Learns what each rank can hold, and whether its bits are these.
void RankExecutor::meet() {
  seats_.assign(static_cast<std::size_t>(link_.size()), 0);
  seats_[0] = service_.seats();
  const auto until = std::chrono::steady_clock::now() + kMeetWait;
  for (int missing = link_.size() - 1; missing > 0;) {
    const auto message = link_.receive(kReceiveWait);
    if (!message && std::chrono::steady_clock::now() > until) {
      refusal_ =
          joined({std::to_string(missing), " of ", std::to_string(link_.size()), " ranks have not started"});
      first_.stop();
      return;
    }
    if (!message) continue;
    const RankWord word = word_of(message->bytes);
    const auto& hello = std::get<RankHello>(word);
    seats_[static_cast<std::size_t>(message->from)] = hello.seats;
    --missing;
    if (hello.build != build_line()) {
      refusal_ = joined({"rank ", std::to_string(message->from), " runs another build (", hello.build,
                         ") than rank 0 (", build_line(), "); last bits may differ"});
    }
  }
}

void RankExecutor::receive_until(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    auto message = link_.receive(kReceiveWait);
    if (!message) continue;
    RankWord word = word_of(message->bytes);
    if (auto* answer = std::get_if<RankAnswer>(&word)) deliver(message->from, std::move(*answer));
  }
}

void RankExecutor::deliver(int rank, RankAnswer answer) const {
  const std::lock_guard lock(current_mutex_);
  if (current_ != nullptr) current_->deliver(rank, std::move(answer));
}

std::unique_ptr<Work> RankExecutor::begin(WorkOrder order) const {
  return std::make_unique<RankWork>(*this, std::move(order));
}

std::optional<ScenarioResult> RankExecutor::run_traced(const Scenario& scenario, Trace& trace,
                                                       const std::atomic<bool>* stop) const {
  return run_alone(simulator_, scenario, &trace, stop);
}

}  // namespace unbruised::studies
