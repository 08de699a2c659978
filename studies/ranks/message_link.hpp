#pragma once

/// @file
/// How the processes of one run talk: messages of bytes between ranks. One implementation is MPI
/// (mpi_link.cpp, a module of its own); tests have one in memory.

#include <chrono>
#include <optional>
#include <string>

namespace unbruised::studies {

struct RankMessage {
  int from = 0;
  std::string bytes;
};

/// Messages between two ranks arrive in the order in which they were sent.
class MessageLink {
 public:
  virtual ~MessageLink() = default;
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  /// Thread-safe; returns at once. It goes out while somebody receives.
  virtual void send(int to, std::string bytes) = 0;
  /// Nothing where none came within `wait`. One thread at a time.
  virtual std::optional<RankMessage> receive(std::chrono::milliseconds wait) = 0;
  /// Leaves properly once all that was sent has gone out; all ranks do. Without it, they are left to the kill that
  /// ends them. One thread at a time, as `receive`.
  virtual void leave() = 0;
};

}  // namespace unbruised::studies
