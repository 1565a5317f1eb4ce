// SPDX-License-Identifier: Apache-2.0
// A controller written in Python, as the subject of a certification.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "certify/subject.h"
#include "python/interrupt.h"

namespace toolcomp::python {

// What ends a certification from Python's side: Ctrl-C, or an exception that is to be seen by who called.
class Ending {
 public:
  // Keeps the first. Needs the GIL.
  void keep(pybind11::error_already_set& error);
  // Why to come to an end; empty: go on. Without the GIL.
  std::string why();
  // Throws what was kept. Needs the GIL.
  void rethrow();

 private:
  std::mutex mutex_;
  Interrupt interrupt_;
  std::optional<pybind11::error_already_set> error_;
};

// Functions of toolcomp/controllers.py that take and give lines of the protocol (docs/protocol.md).
struct PythonController {
  pybind11::function hello;   // () -> line
  pybind11::function answer;  // (line) -> line
  pybind11::object restart;   // (), or None: it remembers nothing
  bool raise_errors = false;  // an Exception ends the certification; else it is a finding of kind "crash"
};

// It must not outlive `ending`. It runs with the GIL held; there is no time-out.
std::unique_ptr<certify::Subject> python_subject(const PythonController& controller, Ending& ending);

}  // namespace toolcomp::python
