#pragma once

/// @file
/// SIGINT, SIGTERM and SIGHUP: the first asks the program to stop properly, the second ends it at once.

#include <atomic>

namespace unbruised::studies {

/// Listens from now on to the end of the process.
void listen_for_interrupts();
/// True after the first signal.
const std::atomic<bool>& interrupt_requested();
/// 130 after SIGINT, 143 after SIGTERM, 129 after SIGHUP, 0 before.
int interrupt_exit_status();

}  // namespace unbruised::studies
