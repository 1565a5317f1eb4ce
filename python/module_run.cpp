// SPDX-License-Identifier: Apache-2.0
// Runs, a few events at a time.
#include <pybind11/stl.h>

#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "certify/input/program.h"
#include "judge/oracle/control.h"
#include "python/bindings.h"
#include "python/formal_thread.h"
#include "python/interrupt.h"
#include "python/numbers.h"
#include "spec/language/event_json.h"
#include "spec/language/input_error.h"
#include "spec_engine/engine.h"

namespace py = pybind11;

namespace toolcomp::python {
namespace {

using certify::input::Program;
using Lines = std::vector<std::string>;

class EventRun {
 public:
  virtual ~EventRun() = default;
  // More events as JSON; none at the end. What goes wrong is thrown behind the events before it.
  virtual Lines next() = 0;
};

// An engine that is fed block by block.
template <class Control, class Number, class AppendNumber>
class EngineRun final : public EventRun, private spec::EventSink<Number> {
 public:
  EngineRun(std::shared_ptr<Program> program, AppendNumber append)
      : program_(std::move(program)),
        append_(append),
        text_(program_->text()),
        reader_(Control::reader(text_.open(), program_->setup(), text_.name, text_.called_program)),
        engine_(make_engine()) {}

  Lines next() override {
    constexpr std::size_t kAtOnce = 256;
    const std::scoped_lock lock(mutex_);
    Interrupt interrupt;
    while (!ended_ && lines_.size() < kAtOnce) {
      interrupt.check();
      feed();
    }
    if (lines_.empty() && error_) std::rethrow_exception(std::exchange(error_, nullptr));
    return std::exchange(lines_, {});
  }

 private:
  auto make_engine() {
    if constexpr (std::is_same_v<Number, double>)
      return Control::fast(program_->setup(), *this, program_->samples());
    else
      return Control::model(program_->setup(), recorder_, *this, program_->samples());
  }

  void feed() {
    try {
      if (!engine_.stopped() && reader_.next(block_)) {
        engine_.block(block_);
        return;
      }
      engine_.end();
    } catch (const spec::InputError& error) {
      error_ = std::make_exception_ptr(program_->placed(error));
    } catch (...) {
      error_ = std::current_exception();
    }
    ended_ = true;
  }

  void on(const spec::Event<Number>& event) override {
    std::string line;
    spec::append_event_json(line, event, program_->setup().axes, append_);
    lines_.push_back(std::move(line));
  }

  std::mutex mutex_;
  std::shared_ptr<Program> program_;
  AppendNumber append_;
  judge::StreamedProgram text_;
  typename Control::Reader reader_;
  typename Control::Block block_;
  model::Recorder recorder_;
  std::conditional_t<std::is_same_v<Number, double>, typename Control::Fast, typename Control::Model> engine_;
  Lines lines_;
  std::exception_ptr error_;
  bool ended_ = false;
};

// The formal specification, which takes a program as a whole.
class SpecifiedRun final : public EventRun {
 public:
  SpecifiedRun(std::shared_ptr<Program> program, ExactNumber append) : program_(std::move(program)), append_(append) {}

  Lines next() override {
    Lines lines;
    if (std::exchange(ended_, true)) return lines;
    const spec::Case c = program_->as_case();
    in_formal_thread([&] {
      const spec_engine::Run run = spec_engine::run(c);
      if (!run.not_said.empty()) throw spec::InputError(program_->path(), 0, 0, run.not_said);
      for (const auto& event : run.events) spec::append_event_json(lines.emplace_back(), event, c.setup.axes, append_);
    });
    return lines;
  }

 private:
  std::shared_ptr<Program> program_;
  ExactNumber append_;
  bool ended_ = false;
};

std::unique_ptr<EventRun> run(std::shared_ptr<Program> program, const std::string& engine, int digits) {
  if (engine == "spec") {
    if (!spec_engine::available())
      throw spec::InputError("engine", 0, 0, "this toolcomp was built without the formal specification");
    return std::make_unique<SpecifiedRun>(std::move(program), ExactNumber{digits});
  }
  return judge::with_control(program->setup(), [&]<class Control>(Control) -> std::unique_ptr<EventRun> {
    if (engine == "fast")
      return std::make_unique<EngineRun<Control, double, DoubleNumber>>(std::move(program), DoubleNumber{});
    return std::make_unique<EngineRun<Control, exact::Real, ExactNumber>>(std::move(program), ExactNumber{digits});
  });
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<EventRun>(module, "Run").def("next", &EventRun::next, py::call_guard<py::gil_scoped_release>());
  module.def("run", &run, py::arg("program"), py::arg("engine"), py::arg("digits"),
             py::call_guard<py::gil_scoped_release>());
}

}  // namespace toolcomp::python
