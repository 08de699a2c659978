#include "studies/cli/interrupt.hpp"

#include <csignal>
#include <string_view>

#include <unistd.h>

namespace unbruised::studies {
namespace {

constexpr int kSignalExitBase = 128;

std::atomic<bool> requested = false;
std::atomic<int> received_signal = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "both are used in a signal handler");

extern "C" void handle_interrupt(int signal_number) {
  if (requested.exchange(true)) ::_exit(kSignalExitBase + signal_number);
  received_signal = signal_number;
  constexpr std::string_view kMessage = "\nunbruised: stopping; once more ends at once\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kMessage.data(), kMessage.size());
}

}  // namespace

void listen_for_interrupts() {
  struct sigaction action = {};
  action.sa_handler = handle_interrupt;
  ::sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  struct sigaction before = {};
  ::sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) ::sigaction(SIGHUP, &action, nullptr);  // nohup wants it ignored
}

const std::atomic<bool>& interrupt_requested() { return requested; }

int interrupt_exit_status() {
  const int number = received_signal;
  return number == 0 ? 0 : kSignalExitBase + number;
}

}  // namespace unbruised::studies
