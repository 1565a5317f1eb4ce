// SPDX-License-Identifier: Apache-2.0
// Ctrl-C while C++ works.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>

namespace toolcomp::python {

// Asked often, without the GIL held: throws what a signal handler of Python raises, KeyboardInterrupt most of all. It
// looks ten times a second. Only in the thread that runs Python's handlers does anything come of it.
class Interrupt {
 public:
  void check() {
    const auto now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    const pybind11::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

}  // namespace toolcomp::python
