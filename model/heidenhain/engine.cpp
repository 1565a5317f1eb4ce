// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/engine.h"

#include <optional>
#include <utility>

#include "model/basis/alarm.h"
#include "model/heidenhain/face_milling/face_milling.h"
#include "model/heidenhain/peripheral_milling/rules.h"
#include "model/heidenhain/program/interpreter.h"
#include "model/heidenhain/program/report.h"
#include "model/heidenhain/program/tool_checks.h"
#include "model/heidenhain/programmed_contour/rules.h"
#include "spec/language/input_error.h"

namespace toolcomp::model::klartext {
namespace {

// The setup, once it is known to be one of this control.
spec::Setup checked(const spec::Setup& setup) {
  if (setup.control != spec::Control::heidenhain)
    throw spec::InputError("setup", 0, 0, "control: expected \"heidenhain\" for a Klartext program");
  return setup;
}

}  // namespace

// A block is read and executed. If it moves, its tool is checked, and one of four rules applies: face milling (a
// normal), peripheral milling (RL, RR under TCPM), out of scope (RL, RR without), none. The end of a peripheral motion
// depends on the motion that follows it, so it waits for that one.
struct Engine::State {
  State(const spec::Setup& given, Recorder& the_recorder, EventSink& the_sink)
      : setup(checked(given)),
        recorder(the_recorder),
        sink(the_sink),
        interpreter(setup, recorder),
        checks(recorder),
        face(recorder),
        peripheral(recorder) {}

  struct Planned {
    Motion motion;
    std::optional<FaceContact> contact;
    std::optional<DrilledHole> hole;

    [[nodiscard]] bool is_peripheral() const { return !hole && motion.is_peripheral(); }
  };

  void run(const spec::klartext::Block& block);
  void plan(Motion&& motion);
  void plan(const DrilledHole& hole);
  // The next motion: that of peripheral milling waits, any other is made at once.
  void take(Planned&& coming);
  // Makes the motion that waits, if one does.
  void make_waiting(const Motion* next);
  // What is decided from here on belongs to this motion.
  void go_back_to(Motion& motion);
  void make(Planned& now, const Motion* next);
  void make_peripheral(Motion& motion, const Motion* next, bool first);
  void make_hole(DrilledHole& hole);
  Compensated compensated(Motion& motion, const std::optional<FaceContact>& contact);
  [[nodiscard]] Compensated uncompensated(const Motion& motion) const;
  // What waits goes out as if nothing followed.
  void finish() {
    make_waiting(nullptr);
    stopped = true;
  }
  // Runs `work`, and ends the run if it raises an alarm or cannot decide.
  template <class Work>
  void guarded(const Work& work);
  void fail(const Alarm& alarm);

  spec::Setup setup;
  Recorder& recorder;
  EventSink& sink;
  Interpreter interpreter;
  ToolChecks checks;
  FaceMilling face;
  PeripheralRules peripheral;
  std::optional<Planned> waiting;          // a motion of peripheral milling, for the motion that follows it
  bool on = false;                         // the last motion was compensated by peripheral milling
  std::optional<LateralDirection> former;  // made last, since the first compensated block
  Place current;                           // the block being executed
  bool stopped = false;
};

Engine::Engine(const spec::Setup& setup, Recorder& recorder, EventSink& sink)
    : state_(std::make_unique<State>(setup, recorder, sink)) {}
Engine::~Engine() = default;

void Engine::block(const spec::klartext::Block& block) {
  if (!state_->stopped) state_->guarded([&] { state_->run(block); });
}

void Engine::end() {
  if (!state_->stopped) state_->guarded([&] { state_->finish(); });
}

bool Engine::stopped() const { return state_->stopped; }

template <class Work>
void Engine::State::guarded(const Work& work) {
  try {
    work();
  } catch (const Alarm& alarm) {
    fail(alarm);
  } catch (const exact::Undecided&) {
    stopped = true;
    report_undecided(recorder, current, sink);
  }
}

// A motion that waits is at fault before the block that follows it.
void Engine::State::fail(const Alarm& alarm) {
  stopped = true;
  const spec::ClauseList clauses = recorder.take_clauses();
  guarded([&] {
    finish();
    report_alarm(alarm, spec::AlarmNumbers(setup), current, clauses, sink);
  });
}

void Engine::State::run(const spec::klartext::Block& block) {
  current = {block.line, block.n};
  recorder.at(block.line);
  std::optional<Motion> motion = interpreter.read(block);
  if (interpreter.tool_call()) face.forget();
  if (motion) plan(*std::move(motion));
  if (interpreter.hole()) plan(*interpreter.hole());
  // heidenhain.program.end: M2, M30 and END PGM end the program after their block, and so does the end of the text.
  const bool ends = recorder.decide(Clause::heidenhain_program_end, interpreter.ends());
  recorder.take_clauses();  // of a block without an event
  if (ends) finish();
}

void Engine::State::plan(Motion&& motion) {
  std::optional<FaceContact> contact;
  if (motion.normal)
    contact = face.check(motion);
  else if (motion.vectors || motion.is_peripheral())
    checks.without_normal(motion);
  if (!contact) face.forget();
  take({std::move(motion), std::move(contact), {}});
}

// A motion as any under R0, for whatever waits for one.
void Engine::State::plan(const DrilledHole& hole) {
  face.forget();
  take({hole.motion, {}, hole});
}

void Engine::State::take(Planned&& coming) {
  Motion& motion = coming.motion;
  if (waiting) {
    motion.clauses = recorder.take_clauses();
    make_waiting(&motion);
    go_back_to(motion);
  }
  if (!coming.is_peripheral()) return make(coming, nullptr);
  motion.clauses = recorder.take_clauses();
  waiting = std::move(coming);
}

void Engine::State::make_waiting(const Motion* next) {
  auto now = std::exchange(waiting, std::nullopt);
  if (!now) return;
  go_back_to(now->motion);
  make(*now, next);
}

void Engine::State::go_back_to(Motion& motion) {
  recorder.at(motion.line);
  recorder.resume(std::move(motion.clauses));
}

void Engine::State::make(Planned& now, const Motion* next) {
  Motion& motion = now.motion;
  const bool before = std::exchange(on, now.is_peripheral());
  if (now.hole) return make_hole(*now.hole);
  if (on) return make_peripheral(motion, next, !before);
  if (motion.is_out_of_scope()) {
    // heidenhain.peripheral.out-of-scope: RL or RR without TCPM, in an L block or an LN block without a normal, is the
    // ordinary compensation in the plane by the full radius, which is not modelled. In place of the move there is an
    // undecided event with the reason OUT_OF_SCOPE. The run goes on from the programmed end point.
    recorder.reach(Clause::heidenhain_peripheral_out_of_scope);
    motion.clauses = recorder.take_clauses();
    report_out_of_scope(motion, sink);
    return;
  }
  // heidenhain.program.length-along-the-tool: DL acts along the tool vector T. The axes of an event are the tip of a
  // tool of exactly the table length. The real tool is displaced by dL t from where it would be without deltas.
  recorder.reach(Clause::heidenhain_program_length_along_the_tool);
  Compensated end = compensated(motion, now.contact);
  if (before) {
    // heidenhain.peripheral.cancel: The first block that moves after the last compensated block goes straight to its
    // own end point, and its move has the cause cancel. If that block is out of scope, it is the cancel block, but it
    // makes no move.
    recorder.reach(Clause::heidenhain_peripheral_cancel);
    end.cause = spec::Cause::cancel;
  }
  motion.clauses = recorder.take_clauses();
  report_move(motion, end, setup, sink);
}

// Compensated perpendicular to movement and tool. `next`: the motion that follows, if one does.
void Engine::State::make_peripheral(Motion& motion, const Motion* next, bool first) {
  Compensated result;
  try {
    // heidenhain.program.length-along-the-tool: DL acts along the tool vector T. The axes of an event are the tip of a
    // tool of exactly the table length. The real tool is displaced by dL t from where it would be without deltas.
    recorder.reach(Clause::heidenhain_program_length_along_the_tool);
    PeripheralEnd made = peripheral.compensate(motion, next, first, former);
    result = std::move(made.end);
    former = std::move(made.latest);
  } catch (Alarm& alarm) {
    alarm.line = motion.line;
    alarm.n = motion.n;
    alarm.unmade = unmade(motion);
    throw;
  }
  if (next == nullptr || !next->is_peripheral()) former.reset();
  result.cause = first ? spec::Cause::start_up : spec::Cause::programmed;
  motion.clauses = recorder.take_clauses();
  report_move(motion, result, setup, sink);
}

void Engine::State::make_hole(DrilledHole& hole) {
  // heidenhain.program.length-along-the-tool: DL acts along the tool vector T. The axes of an event are the tip of a
  // tool of exactly the table length. The real tool is displaced by dL t from where it would be without deltas.
  recorder.reach(Clause::heidenhain_program_length_along_the_tool);
  hole.motion.clauses = recorder.take_clauses();
  report_hole(hole, setup, sink);
}

Compensated Engine::State::compensated(Motion& motion, const std::optional<FaceContact>& contact) {
  if (contact) return face.compensate(motion, *contact);
  // heidenhain.peripheral.no-lateral: An LN block without a normal under R0 has no side, so it has no lateral
  // compensation and gives W_NO_LATERAL. The manual calls compensation possible in an LN block without a normal. It
  // needs RL or RR of an earlier block.
  if (motion.vectors)
    motion.warn(recorder, Clause::heidenhain_peripheral_no_lateral, "W_NO_LATERAL",
                "LN without a surface normal under R0 has no lateral compensation");
  return uncompensated(motion);
}

Compensated Engine::State::uncompensated(const Motion& motion) const {
  // heidenhain.program.no-compensation: A straight line L without RL and RR has no 3D compensation, whatever the deltas
  // are. The same holds for LN without a normal under R0.
  recorder.reach(Clause::heidenhain_program_no_compensation);
  Compensated end;
  end.point = ProgrammedContour::tip_of_reference(motion);
  end.tool_center = end.point + (motion.tool->r2 + motion.tool->dr2) * motion.direction.unit;
  return end;
}

}  // namespace toolcomp::model::klartext
