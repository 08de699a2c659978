#include "studies/ranks/rank_service.hpp"

#include <array>
#include <chrono>
#include <utility>

#include "studies/execution/build_info.hpp"
#include "studies/execution/lane_scheduler.hpp"

namespace unbruised::studies {
namespace {

constexpr std::chrono::milliseconds kReceiveWait{100};

}  // namespace

RankService::RankService(const Simulator& simulator, int threads, Answer answer)
    : simulator_(simulator), threads_(threads), answer_(std::move(answer)) {}

std::uint64_t RankService::seats() const {
  return static_cast<std::uint64_t>(threads_) * static_cast<std::uint64_t>(simulator_.lane_count());
}

void RankService::begin(Curves curves) {
  drop();
  WorkOrder order{.scenario =
                      [this](std::uint64_t ticket) {
                        const std::lock_guard lock(mutex_);
                        return asked_.at(ticket).scenario;
                      },
                  .sink = [this](std::uint64_t ticket, const ScenarioResult& result) { deliver(ticket, result); },
                  .supply = Supply::growing};
  if (curves == Curves::kept) {
    order.curve = [this](std::uint64_t ticket) -> Curve& {
      const std::lock_guard lock(mutex_);
      return asked_.at(ticket).curve;  // stays where it is when others come and go
    };
  }
  work_ = std::make_unique<LaneScheduler>(simulator_, std::move(order), threads_);
  worker_ = std::thread([work = work_.get()] { work->run(); });
}

void RankService::add(RankQuestion question) {
  const std::array<std::uint64_t, 1> ticket{question.ticket};
  {
    const std::lock_guard lock(mutex_);
    asked_.emplace(question.ticket, Asked{std::move(question.scenario), {}});
  }
  work_->add(ticket);
}

void RankService::drop() {
  if (!work_) return;
  work_->abort();
  work_->close();  // wakes those who wait
  worker_.join();
  work_.reset();
  const std::lock_guard lock(mutex_);
  asked_.clear();
}

void RankService::deliver(std::uint64_t ticket, const ScenarioResult& result) {
  RankAnswer answer{.ticket = ticket, .result = result, .curve = {}};
  {
    const std::lock_guard lock(mutex_);
    answer.curve = std::move(asked_.at(ticket).curve);
    asked_.erase(ticket);
  }
  answer_(std::move(answer));
}

void serve_first_rank(MessageLink& link, const Simulator& simulator, int threads) {
  RankService service(simulator, threads, [&link](const RankAnswer& answer) { link.send(0, bytes_of(answer)); });
  link.send(0, bytes_of(RankHello{.build = build_line(), .seats = service.seats()}));
  for (;;) {
    const auto message = link.receive(kReceiveWait);
    if (!message) continue;
    RankWord word = word_of(message->bytes);
    if (const auto* order = std::get_if<RankOrder>(&word)) service.begin(order->curves);
    if (auto* question = std::get_if<RankQuestion>(&word)) service.add(std::move(*question));
    if (std::holds_alternative<RankEnd>(word)) break;
  }
  service.drop();
  link.leave();
}

}  // namespace unbruised::studies
