// MPI as a link between ranks, in a module of its own: the program needs no MPI to start.

#include <algorithm>
#include <deque>
#include <list>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include <mpi.h>

#include "studies/ranks/message_link.hpp"

namespace unbruised::studies {
namespace {

constexpr int kTag = 1;
/// Between two looks for a message: a scenario takes milliseconds and more.
constexpr std::chrono::microseconds kBetweenLooks{200};

/// All calls of MPI but the first and the last are made by whoever receives.
class MpiLink final : public MessageLink {
 public:
  MpiLink() {
    int given = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &given);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }

  void send(int to, std::string bytes) override {
    const std::lock_guard lock(mutex_);
    waiting_.emplace_back(to, std::move(bytes));
  }

  std::optional<RankMessage> receive(std::chrono::milliseconds wait) override {
    const auto until = std::chrono::steady_clock::now() + wait;
    for (;;) {
      push();
      if (auto message = take()) return message;
      if (std::chrono::steady_clock::now() >= until) return std::nullopt;
      std::this_thread::sleep_for(kBetweenLooks);
    }
  }

  /// Once all that this rank has sent is gone it waits for the others, and takes what they still send.
  void leave() override {
    MPI_Request everybody = MPI_REQUEST_NULL;
    bool waits = false;
    for (int all_wait = 0; all_wait == 0;) {
      push();
      while (take()) {
      }
      if (!waits && flying_.empty()) {
        MPI_Ibarrier(MPI_COMM_WORLD, &everybody);
        waits = true;
      }
      if (waits) MPI_Test(&everybody, &all_wait, MPI_STATUS_IGNORE);
      std::this_thread::sleep_for(kBetweenLooks);
    }
    MPI_Finalize();
  }

 private:
  struct Flight {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  /// Begins to send what waits, and forgets what has arrived.
  void push() {
    std::deque<std::pair<int, std::string>> begun;
    {
      const std::lock_guard lock(mutex_);
      begun.swap(waiting_);
    }
    for (auto& [to, bytes] : begun) {
      Flight& flight = flying_.emplace_back(Flight{std::move(bytes)});
      MPI_Isend(flight.bytes.data(), static_cast<int>(flight.bytes.size()), MPI_BYTE, to, kTag, MPI_COMM_WORLD,
                &flight.request);
    }
    std::erase_if(flying_, [](Flight& flight) {
      int done = 0;
      MPI_Test(&flight.request, &done, MPI_STATUS_IGNORE);
      return done != 0;
    });
  }

  /// A message that is there.
  static std::optional<RankMessage> take() {
    int there = 0, length = 0;
    MPI_Message handle = MPI_MESSAGE_NULL;
    MPI_Status status{};
    MPI_Improbe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &there, &handle, &status);
    if (there == 0) return std::nullopt;
    MPI_Get_count(&status, MPI_BYTE, &length);
    RankMessage message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(length), '\0')};
    MPI_Mrecv(message.bytes.data(), length, MPI_BYTE, &handle, MPI_STATUS_IGNORE);
    return message;
  }

  int rank_ = 0;
  int size_ = 1;
  std::mutex mutex_;
  std::deque<std::pair<int, std::string>> waiting_;
  std::list<Flight> flying_;  ///< stay where they are while they are sent
};

}  // namespace

extern "C" MessageLink* unbruised_mpi_link() { return new MpiLink; }

}  // namespace unbruised::studies
