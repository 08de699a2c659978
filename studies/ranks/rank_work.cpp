#include "studies/ranks/rank_work.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "studies/execution/lone_run.hpp"

namespace unbruised::studies {
namespace {

/// Scenarios that a rank has for each seat: as one ends, the next is there already.
constexpr std::uint64_t kForEachSeat = 2;
/// Groups looked through for one that no other rank works in.
constexpr std::size_t kGroupsLookedThrough = 64;
/// How often the stop flag is looked at, which a signal handler sets without waking anybody.
constexpr std::chrono::milliseconds kStopPoll{50};

}  // namespace

RankWork::RankWork(const RankExecutor& executor, WorkOrder order) : executor_(executor), order_(std::move(order)) {
  for (const std::uint64_t seats : executor_.seats_) peers_.emplace_back().seats = seats;
  const RankOrder words{order_.curve ? Curves::kept : Curves::none};
  for (int rank = 1; rank < executor_.link_.size(); ++rank) executor_.link_.send(rank, bytes_of(words));
  executor_.service_.begin(words.curves);
  const std::lock_guard lock(executor_.current_mutex_);
  executor_.current_ = this;
}

void RankWork::add(std::span<const std::uint64_t> ids) {
  std::vector<std::pair<std::uint64_t, std::string>> added;
  added.reserve(ids.size());
  for (const std::uint64_t id : ids) added.emplace_back(id, executor_.group_key(order_.scenario(id)));
  const std::lock_guard lock(mutex_);
  for (auto& [id, key] : added) {
    const auto [place, is_new] = group_of_key_.try_emplace(std::move(key), groups_.size());
    if (is_new) groups_.emplace_back();
    groups_[place->second].waiting.push_back(id);
    open_.insert(place->second);
    ++waiting_;
  }
  share_out();
}

void RankWork::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
}

void RankWork::abort() {
  aborted_ = true;
  changed_.notify_all();
}

bool RankWork::stopping() const { return is_set(order_.stop) || aborted_; }

WorkReport RankWork::run() {
  {
    std::unique_lock lock(mutex_);
    while (!stopping() && !(closed_ && waiting_ == 0 && outstanding_ == 0)) changed_.wait_for(lock, kStopPoll);
  }
  if (is_set(order_.stop)) executor_.first_.stop();
  leave();
  if (failure_) std::rethrow_exception(failure_);
  return {.group_count = groups_.size(), .delivered = delivered_, .lane_use = {}};
}

/// No more answers are taken, and what is still running is dropped.
void RankWork::leave() {
  {
    const std::lock_guard lock(executor_.current_mutex_);
    if (executor_.current_ != this) return;
    executor_.current_ = nullptr;
  }
  for (int rank = 1; rank < executor_.link_.size() && outstanding_ > 0; ++rank) {
    executor_.link_.send(rank, bytes_of(RankOrder{}));
  }
  executor_.service_.drop();
}

void RankWork::deliver(int rank, RankAnswer answer) {
  std::uint64_t id = 0;
  {
    const std::lock_guard lock(mutex_);
    const auto ticket = id_of_ticket_.find(answer.ticket);
    if (ticket == id_of_ticket_.end()) return;
    id = ticket->second;
    id_of_ticket_.erase(ticket);
    --peers_[static_cast<std::size_t>(rank)].outstanding;
    share_out();
  }
  {
    const std::lock_guard lock(sink_mutex_);
    if (!stopping()) {
      try {
        if (order_.curve) order_.curve(id) = std::move(answer.curve);
        order_.sink(id, answer.result);
        ++delivered_;
      } catch (...) {
        failure_ = std::current_exception();
        aborted_ = true;
      }
    }
  }
  const double steps = answer.result.metrics[Metric::step_count];
  if (rank > 0 && steps > 0.0) executor_.count_steps_(static_cast<std::size_t>(steps));
  {
    const std::lock_guard lock(mutex_);
    --outstanding_;  // only now: the order has ended when the last result is handed out
  }
  changed_.notify_all();
}

/// Of all that is not done, as much as the rank has of all seats; not more than it can hold.
std::uint64_t RankWork::share(const Peer& peer) const {
  std::uint64_t unfinished = waiting_, seats = 0;
  for (const Peer& each : peers_) {
    unfinished += each.outstanding;
    seats += each.seats;
  }
  const double part = static_cast<double>(peer.seats) / static_cast<double>(seats);
  const auto fair = static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(unfinished)));
  return std::min(fair, kForEachSeat * peer.seats);
}

/// Gives every rank what it may have now.
void RankWork::share_out() {
  for (std::size_t rank = 0; rank < peers_.size() && !stopping(); ++rank) {
    Peer& peer = peers_[rank];
    for (std::uint64_t most = share(peer); waiting_ > 0 && peer.outstanding < most;) {
      give(static_cast<int>(rank), peer);
    }
  }
}

/// The rank's own group while something waits in it, else one that nobody else works in, else the largest.
std::size_t RankWork::pick_group(Peer& peer) {
  if (peer.group && open_.contains(*peer.group)) return *peer.group;
  std::size_t best = *open_.begin(), looked_at = 0;
  for (const std::size_t index : open_) {
    const Group& group = groups_[index];
    const Group& best_group = groups_[best];
    const bool freer = group.peers < best_group.peers;
    if (freer || (group.peers == best_group.peers && group.waiting.size() > best_group.waiting.size())) {
      best = index;
    }
    if (++looked_at == kGroupsLookedThrough) break;
  }
  if (peer.group) --groups_[*peer.group].peers;
  peer.group = best;
  ++groups_[best].peers;
  return best;
}

void RankWork::give(int rank, Peer& peer) {
  const std::size_t index = pick_group(peer);
  Group& group = groups_[index];
  const std::uint64_t id = group.waiting.front();
  group.waiting.pop_front();
  if (group.waiting.empty()) open_.erase(index);
  --waiting_;
  ++peer.outstanding;
  ++outstanding_;
  const std::uint64_t ticket = executor_.next_ticket_++;
  id_of_ticket_.emplace(ticket, id);
  ask(rank, {.ticket = ticket, .scenario = order_.scenario(id)});
}

void RankWork::ask(int rank, RankQuestion question) {
  if (rank == 0) {
    executor_.service_.add(std::move(question));
  } else {
    executor_.link_.send(rank, bytes_of(question));
  }
}

}  // namespace unbruised::studies
