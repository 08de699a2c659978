#include "python/bindings/interruptible.hpp"

#include <chrono>
#include <exception>
#include <future>
#include <thread>

#include <pybind11/pybind11.h>

namespace unbruised::python {
namespace {

namespace py = pybind11;

constexpr std::chrono::milliseconds kBetweenLooks(100);

void look(const std::function<void()>& tick) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (tick) tick();
}

}  // namespace

void run_interruptibly(const std::function<void(const std::atomic<bool>& stop)>& work,
                       const std::function<void()>& tick) {
  std::atomic<bool> stop = false;
  std::promise<void> done;
  std::future<void> finished = done.get_future();
  std::thread worker([&] {
    try {
      work(stop);
      done.set_value();
    } catch (...) {
      done.set_exception(std::current_exception());
    }
  });
  std::exception_ptr raised;
  for (;;) {
    {
      const py::gil_scoped_release unlocked;
      if (finished.wait_for(kBetweenLooks) == std::future_status::ready) break;
    }
    try {
      if (!raised) look(tick);
    } catch (...) {
      raised = std::current_exception();
      stop = true;
    }
  }
  worker.join();
  if (!raised) {
    try {
      look(tick);  // the last state, and a signal that came late
    } catch (...) {
      raised = std::current_exception();
    }
  }
  if (raised) std::rethrow_exception(raised);
  finished.get();
}

}  // namespace unbruised::python
