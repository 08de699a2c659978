#pragma once

/// @file
/// Work that takes long, without Python's lock, and with Ctrl-C.

#include <atomic>
#include <functional>

namespace unbruised::python {

/// Runs `work` on a thread of its own, while this one has let go of Python's lock. A few times a second it looks
/// for signals and calls `tick` (may be empty) with the lock held; what they raise sets `stop`, and is thrown on
/// once `work` has returned. What `work` throws is thrown on too.
void run_interruptibly(const std::function<void(const std::atomic<bool>& stop)>& work,
                       const std::function<void()>& tick);

}  // namespace unbruised::python
