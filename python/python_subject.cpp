// SPDX-License-Identifier: Apache-2.0
#include "python/python_subject.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "certify/controller.h"
#include "spec/language/input_error.h"

namespace py = pybind11;

namespace toolcomp::python {
namespace {

using certify::Answer;
using certify::Capabilities;
using certify::Fault;
using certify::FaultKind;

class PythonSubject final : public certify::Subject {
 public:
  PythonSubject(PythonController controller, Ending& ending) : controller_(std::move(controller)), ending_(ending) {
    starts_ = controller_.restart.is_none() ? 0 : 1;
  }
  ~PythonSubject() override {
    const py::gil_scoped_acquire gil;
    controller_ = {};
  }
  PythonSubject(const PythonSubject&) = delete;
  PythonSubject& operator=(const PythonSubject&) = delete;

  std::variant<Capabilities, Fault> capabilities() override {
    auto line = call([this] { return controller_.hello(); });
    if (auto* fault = std::get_if<Fault>(&line)) {
      fault->what = "hello: " + fault->what;
      return std::move(*fault);
    }
    hello_ = std::get<std::string>(line);
    try {
      return capabilities_ = certify::read_capabilities(hello_);
    } catch (const spec::InputError& error) {
      return Fault{FaultKind::malformed, "hello: " + error.message(), {}, {}};
    }
  }

  Answer run(const spec::Case& c, std::optional<std::chrono::milliseconds> /*patience*/) override {
    const auto begun = std::chrono::steady_clock::now();
    const std::string request = certify::request_line(c);
    auto line = call([&] { return controller_.answer(request); });
    slowest_ = std::max(
        slowest_, std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begun));
    if (auto* fault = std::get_if<Fault>(&line)) {
      Answer answer;
      answer.result = std::move(*fault);
      return answer;
    }
    return certify::read_answer(capabilities_, c, std::move(std::get<std::string>(line)));
  }

  [[nodiscard]] std::chrono::milliseconds slowest() const override { return slowest_; }
  [[nodiscard]] std::uint64_t starts() const override { return starts_; }
  void restart() override {
    if (controller_.restart.is_none()) return;
    static_cast<void>(call([this] {
      controller_.restart();
      return py::str();
    }));
    ++starts_;
  }
  [[nodiscard]] std::string hello() const override { return hello_; }

 private:
  // The line that Python gives, or that it raised.
  template <class Ask>
  std::variant<std::string, Fault> call(Ask ask) {
    const py::gil_scoped_acquire gil;
    try {
      return py::cast<std::string>(ask());
    } catch (py::error_already_set& error) {
      const bool ends = controller_.raise_errors || !error.matches(PyExc_Exception);
      Fault fault = raised(error);
      if (ends) ending_.keep(error);
      return fault;
    }
  }

  static Fault raised(const py::error_already_set& error) {
    const py::object line = py::module_::import("toolcomp.controllers").attr("words_of_exception")(error.value());
    return {FaultKind::crash, "raised " + py::cast<std::string>(line), {}, error.what()};
  }

  PythonController controller_;
  Ending& ending_;
  Capabilities capabilities_;
  std::string hello_;
  std::chrono::milliseconds slowest_{0};
  std::uint64_t starts_ = 0;
};

}  // namespace

void Ending::keep(py::error_already_set& error) {
  const std::scoped_lock lock(mutex_);
  if (!error_) error_ = error;
}

std::string Ending::why() {
  {
    const std::scoped_lock lock(mutex_);
    if (error_) return "interrupted (by an exception of Python)";
  }
  try {
    interrupt_.check();
  } catch (py::error_already_set& error) {
    const py::gil_scoped_acquire gil;
    keep(error);
    return "interrupted (by a signal)";
  }
  return {};
}

void Ending::rethrow() {
  if (!error_) return;
  throw py::error_already_set(*std::exchange(error_, std::nullopt));
}

std::unique_ptr<certify::Subject> python_subject(const PythonController& controller, Ending& ending) {
  const py::gil_scoped_acquire gil;
  return std::make_unique<PythonSubject>(controller, ending);
}

}  // namespace toolcomp::python
