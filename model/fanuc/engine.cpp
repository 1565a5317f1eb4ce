// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/engine.h"

#include <memory>
#include <type_traits>
#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/passes/passes.h"
#include "model/fanuc/program/offset_memory.h"
#include "model/fanuc/reporter.h"
#include "model/fanuc/step_maker.h"
#include "spec/language/input_error.h"

namespace toolcomp::model {
namespace {

// The setup, once it is known to be one this engine can run.
spec::Setup checked(const spec::Setup& setup) {
  if (setup.control != spec::Control::fanuc)
    throw spec::InputError("setup", 0, 0, "control: expected \"fanuc\" for a FANUC program");
  return setup;
}

}  // namespace

// The way of a block: a step is made of it, goes through the passes of compensation, and is reported.
struct Engine::State {
  State(const spec::Setup& given, Recorder& the_recorder, EventSink& sink, std::uint32_t samples, MotionSink* motions)
      : setup(checked(given)),
        recorder(the_recorder),
        memory(setup, recorder),
        maker(setup, memory, recorder, samples > 1 || motions != nullptr),
        compensation(passes_of(setup), {setup, memory, recorder}),
        reporter(setup, recorder, sink, samples, motions) {
    if (motions != nullptr) motions->stand(maker.zero(), 0, {});
  }

  void run(const spec::Block& block) {
    reporter.at(block);
    recorder.at(block.line);
    OwnedStep step = maker.make(block, compensation);
    const bool ends = step->ends_program;
    compensation.put(std::move(step));
    report_made();
    // fanuc.program.end: M02 and M30 end the program after their block, and so does the end of the text.
    if (recorder.decide(Clause::fanuc_program_end, ends)) finish();
  }

  void finish() {
    compensation.end();
    report_made();
    stopped = true;
  }

  // What the passes have made.
  void report_made() {
    while (const auto step = compensation.next()) {
      if (step->alarm) stopped = true;
      reporter.report(*step);
    }
  }

  // Runs `work`, and ends the run if it raises an alarm or cannot decide.
  template <class Work>
  void guarded(const Work& work) {
    try {
      work();
    } catch (const Alarm& alarm) {
      fail(alarm);
    } catch (const LeftOpen& open) {
      fail(open);
    } catch (const exact::Undecided&) {
      stopped = true;
      reporter.report_undecided();
    }
  }

  // First the blocks that wait are made and given, as if this block were absent. If one of them raises an alarm now,
  // that alarm ends the run instead. Otherwise this one is given (fanuc.cutter.order-of-alarms).
  template <class Fault>
  void fail(const Fault& fault) {
    stopped = true;
    spec::ClauseList clauses = recorder.take_clauses();
    guarded([&] {
      finish();
      // A clause that stands alone applies once the blocks before it have gone out.
      if constexpr (std::is_same_v<Fault, LeftOpen>) {
        if (clauses.empty()) {
          recorder.reach(fault.clause);
          clauses = recorder.take_clauses();
        }
      }
      reporter.report(fault, clauses);
    });
  }

  spec::Setup setup;
  Recorder& recorder;
  OffsetMemory memory;
  StepMaker maker;
  Passes compensation;
  Reporter reporter;
  bool stopped = false;
};

Engine::Engine(const spec::Setup& setup, Recorder& recorder, EventSink& sink, std::uint32_t samples,
               MotionSink* motions)
    : state_(std::make_unique<State>(setup, recorder, sink, samples, motions)) {}
Engine::~Engine() = default;

void Engine::block(const spec::Block& block) {
  if (!state_->stopped) state_->guarded([&] { state_->run(block); });
}

void Engine::end() {
  if (!state_->stopped) state_->guarded([&] { state_->finish(); });
}

bool Engine::stopped() const { return state_->stopped; }

}  // namespace toolcomp::model
