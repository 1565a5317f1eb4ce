#include "model/fanuc/engine.h"

#include <memory>
#include <string>
#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/cutter_compensation_b/cutter_compensation_b.h"
#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"
#include "model/fanuc/leading_edge_offset/leading_edge_offset.h"
#include "model/fanuc/program/cutter_words.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/program/offset_memory.h"
#include "model/fanuc/reporter.h"
#include "model/fanuc/tool_center_point_control/tool_center_point_control.h"
#include "model/fanuc/tool_length_measurement/tool_length_measurement.h"
#include "model/fanuc/tool_length_offset/tool_length_offset.h"
#include "model/fanuc/tool_offset/tool_offset.h"
#include "model/fanuc/tool_side_compensation/tool_side_compensation.h"
#include "model/fanuc/tool_side_compensation/tool_side_words.h"
#include "spec/language/input_error.h"

namespace toolcomp::model {
namespace {

// The setup, once it is known to be one this engine can run.
spec::Setup checked(const spec::Setup& setup) {
  if (setup.control != spec::Control::fanuc) throw spec::InputError("setup", 0, 0, "control: only \"fanuc\" is built");
  return setup;
}

bool is_reference_return(OneShot code) {
  return code == OneShot::reference || code == OneShot::other_reference || code == OneShot::floating_reference;
}

bool goes_by_machine_coordinates(OneShot code) {
  return is_reference_return(code) || code == OneShot::machine_coordinates;
}

// The stage that the setup asks for.
std::unique_ptr<CutterCompensation> cutter_compensation(const spec::Setup& setup, Recorder& recorder,
                                                        CutterCompensation::Output output) {
  if (setup.cutter_compensation == spec::CutterCompensationType::b)
    return std::make_unique<CutterCompensationB>(setup, recorder, std::move(output));
  return std::make_unique<CutterCompensationC>(setup, recorder, std::move(output));
}

}  // namespace

// The stages of one run, and the order in which a block passes through them: interpretation, tool offset, length offset
// (and its measurement) or the pose of tool center point control, leading edge offset, cutter compensation, tool side
// compensation, control point, events; of the three compensations one at most is on. The length offset is decided when
// the block is read, so that its alarms are known before a stage of compensation looks at the block; all of them only
// add to the programmed end, so the order does not show in the coordinates. The pose is known then too: compensation
// reads the direction of the tool, and moves the tip; the control point follows from both at last.
struct Engine::State {
  State(const spec::Setup& given, Recorder& the_recorder, EventSink& the_sink, std::uint32_t samples_in_a_block)
      : setup(checked(given)),
        recorder(the_recorder),
        interpreter(setup, recorder),
        memory(setup, recorder),
        tip_control(setup, recorder, interpreter.work(), interpreter.position(), samples_in_a_block > 1),
        length(setup, memory, recorder),
        edge(setup, recorder, [this](const Step& step) { cutter->take(step); }),
        tool_offset(setup, memory, recorder),
        measurement(setup, recorder),
        cutter_words(setup, memory, recorder),
        cutter(cutter_compensation(setup, recorder, [this](const Step& step) { tool_side.take(step); })),
        tool_side_words(setup, memory, recorder),
        tool_side(setup, recorder, [this](const Step& step) { report(step); }),
        reporter(setup.axes, recorder, the_sink, samples_in_a_block) {}

  void run(const spec::Block& block);
  void finish();
  // What the stages hold goes out as if nothing followed.
  void release();
  // Runs `work`, and ends the run where it raises an alarm or cannot decide.
  template <class Work>
  void guarded(const Work& work);
  void fail(const Alarm& alarm);
  void report(const Step& step);

  Step step(const Command& command);
  [[nodiscard]] Compensated compensated(const Command& command) const;
  // The move of a leg, with what the length offset and the tool say about its end.
  [[nodiscard]] Move move(const Leg& leg, const LengthVector& offset, const ToolAtEnd& tool, bool machine) const;
  Move turned_move(const Command& command, const TipMarks& tip, const LengthPlan& plan, Leg& leg);
  std::vector<Leg> measure(const Command& command, const Leg& leg, const LengthPlan& plan, Step& step);
  void stand_where_measured(const Leg& leg, std::size_t axis);
  [[nodiscard]] LengthCommand length_command(const Command& command, const std::vector<Leg>& legs) const;

  spec::Setup setup;
  Recorder& recorder;
  Interpreter interpreter;
  OffsetMemory memory;
  ToolCenterPointControl tip_control;
  ToolLengthOffset length;
  LeadingEdgeOffset edge;
  ToolOffset tool_offset;
  ToolLengthMeasurement measurement;
  CutterWords cutter_words;
  std::unique_ptr<CutterCompensation> cutter;
  ToolSideWords tool_side_words;
  ToolSideCompensation tool_side;
  Reporter reporter;
  std::uint64_t line = 0;  // of the block being interpreted
  std::optional<std::uint64_t> n;
  std::optional<OffsetWrite> pending_write;  // of a G10 block, until its step is made
  bool stopped = false;
};

Engine::Engine(const spec::Setup& setup, Recorder& recorder, EventSink& sink, std::uint32_t samples)
    : state_(std::make_unique<State>(setup, recorder, sink, samples)) {}
Engine::~Engine() = default;

void Engine::block(const spec::Block& block) {
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
  } catch (const LeftOpen& open) {
    stopped = true;
    reporter.report(open);
  } catch (const exact::Undecided&) {
    stopped = true;
    reporter.report_undecided();
  }
}

void Engine::State::report(const Step& step) {
  if (step.alarm) stopped = true;
  reporter.report(step);
}

// What is held goes out as if nothing followed; where nothing may follow, the block held is at fault before this one.
void Engine::State::fail(const Alarm& alarm) {
  stopped = true;
  const spec::ClauseList clauses = recorder.take_clauses();
  guarded([&] {
    release();
    reporter.report(alarm, clauses);
  });
}

void Engine::State::release() {
  edge.finish();
  cutter->finish();
  tool_side.finish();
}

void Engine::State::finish() {
  release();
  stopped = true;
}

void Engine::State::run(const spec::Block& block) {
  reporter.at(block);
  line = block.line;
  n = block.n;
  recorder.at(line);
  const Command command = interpreter.read(block);
  Step next = step(command);
  if (pending_write) {
    next.setting = memory.write(*pending_write);
    next.setting->clauses = recorder.take_clauses();
    pending_write.reset();
  }
  edge.take(next);
  if (recorder.decide(Clause::fanuc_program_end, command.codes.ends_program)) finish();
}

// The compensations in space before and after a block.
Compensated Engine::State::compensated(const Command& command) const {
  return {edge.active(), edge.active_after(command), tool_side.on(), tool_side_words.wanted(command)};
}

// Everything about a block but its compensation vector. The alarms of a command are found here, in this order.
Step Engine::State::step(const Command& command) {
  const Numbers& numbers = interpreter.numbers();
  const TipMarks tip = tip_control.read(command, length, compensated(command));
  const bool moves = command.axes != 0 || (tip.directed && command.direction);
  const LeadingEdgeOffset::Marks marks = edge.read(command, moves, memory);
  std::optional<ToolSideBlock> side_block = tool_side_words.read(command, tip.directed, interpreter);
  if (side_block) {
    tool_side.read(*side_block);
    tool_side_words.add_value(*side_block);
  }
  if (tip.ends || tip.again)
    tip_control.rename_position(tip, tool_offset.shifted(interpreter.stay(command)), interpreter);
  interpreter.select_workpiece_system(command);
  std::optional<CutterBlock> cutter_block = cutter_words.read(command, interpreter);
  if (cutter_block) {
    cutter->read(*cutter_block);
    cutter_words.add_value(*cutter_block);
  }
  const bool measures = command.codes.one_shot == OneShot::measure;
  if (measures) {
    const bool cutter_on = cutter_block && (cutter->on() || cutter->wanted(*cutter_block));
    measurement.read(command, length.number(), cutter_on);
  }
  if (command.codes.one_shot == OneShot::data)
    pending_write = memory.read_write(command.words, numbers, command.incremental);
  const bool compensated =
      cutter_block && setup.cutter_compensation == spec::CutterCompensationType::c && cutter->wanted(*cutter_block);
  std::vector<Leg> legs = interpreter.legs(command, tip.directed, tip.starts, compensated);
  const Leg start = cutter_block ? tool_offset.shifted(interpreter.stay(command)) : Leg();
  tool_offset.apply(command, interpreter, cutter_words.number(),
                    {command.codes.h.value_or(length.number()), length.axis_mode(command.codes.length)}, legs);
  if (cutter_block) cutter_words.add_movement(*cutter_block, start, legs);
  if (cutter_block && cutter_block->position) cutter_block->tool = tip_control.at(*cutter_block->position).tool;
  const bool machine = tip.tip_control || (!legs.empty() && goes_by_machine_coordinates(command.codes.one_shot));
  const LengthPlan plan = length.plan(length_command(command, legs));
  if (legs.empty() && !tip.ends && recorder.decide(Clause::fanuc_length_offset_move_without_axis_word, plan.changed))
    legs.push_back(tool_offset.shifted(interpreter.stay(command)));

  Step step;
  if (measures) legs = measure(command, legs.front(), plan, step);
  step.line = line;
  step.n = n;
  if (tip.tip_control && !legs.empty()) {
    step.moves.push_back(turned_move(command, tip, plan, legs.front()));
  } else {
    for (const Leg& leg : legs) {
      const bool on_way = is_reference_return(command.codes.one_shot) && &leg == &legs.front();
      step.moves.push_back(move(leg, on_way ? plan.on_way : plan.at_end, tip_control.at(leg.end), machine));
      if (leg.cause == spec::Cause::measure)
        if (const auto feed = measurement.feed()) step.moves.back().feed = *feed;
    }
  }
  interpreter.arrive(command, legs);
  if (measures) stand_where_measured(legs.back(), measurement.axis(command));
  if (!tip.tip_control) tip_control.follow(interpreter.position());
  if (edge.concerns(command) || cutter_block || side_block) {
    // A move inserted behind G53 or a reference return is no move of that code; under tool center point control every
    // move has machine coordinates, and the leading edge offset inserts some even where G41 or G40 came before it.
    const Leg rest = tool_offset.shifted(interpreter.stay(command));
    const bool known = tip.tip_control || !step.moves.empty();
    step.rest = move(rest, plan.at_end, known ? tip_control.standing() : tip_control.at(rest.end), tip.tip_control);
    if (!step.moves.empty()) step.rest.feed = step.moves.back().feed;
  }
  step.has_word = command.codes.any;
  step.stops_look_ahead = command.codes.stops_look_ahead;
  step.edge = marks.edge;
  step.radius = marks.radius;
  step.cutter = std::move(cutter_block);
  step.side = std::move(side_block);
  if (edge.concerns(command) && marks.edge == EdgeCommand::none)
    step.travels =
        !recorder.decide(Clause::fanuc_leading_edge_no_movement, legs.empty() || is_zero(legs.front().travel));
  step.clauses = recorder.take_clauses();
  return step;
}

// The own move of a block under tool center point control; the leg ends where the rotary axes then stand.
Move Engine::State::turned_move(const Command& command, const TipMarks& tip, const LengthPlan& plan, Leg& leg) {
  TurnedBlock turned = tip_control.turn(command, tip, interpreter, plan.at_end.along_tool, leg);
  Move result = move(leg, plan.at_end, turned.end, true);
  if (turned.motion) {
    if (turned.end.tip->frame) tip_control.place(turned.end.tip->pose, result.leg.end);
    result.inside = std::make_shared<const OwnMotion>(std::move(*turned.motion));
  }
  return result;
}

// The legs of a G37 block, and what it writes or the alarm it ends with.
std::vector<Leg> Engine::State::measure(const Command& command, const Leg& leg, const LengthPlan& plan, Step& step) {
  const std::size_t axis = measurement.axis(command);
  const MeasurementStart start{plan.at_end.axis.at(axis), tool_offset.shift(axis), length.minus()};
  Measurement measured = measurement.measure(command, interpreter.position(), leg, start);
  if (measured.in_zone)
    pending_write = memory.measured(length.number(), measured.difference);
  else
    step.alarm = Alarm("PS0080", "G37: the approach-end signal came too early or not at all");
  return std::move(measured.legs);
}

// The programmed position is where the measurement has stopped, the shift of the tool offset apart.
void Engine::State::stand_where_measured(const Leg& leg, std::size_t axis) {
  const Rational by = leg.shift->at(axis) - tool_offset.shift(axis);
  interpreter.stand(axis, leg.end.at(axis) + Coordinate(by));
}

LengthCommand Engine::State::length_command(const Command& command, const std::vector<Leg>& legs) const {
  LengthCommand result;
  result.code = command.codes.length;
  result.h = command.codes.h;
  result.plane = command.plane;
  result.axes = command.axes;
  result.has_word = command.codes.any;
  const std::optional<Compensation>& code = command.codes.compensation;
  result.cutter_code = code && (*code == Compensation::cancel || is_cutter_side(*code));
  if (!legs.empty() && goes_by_machine_coordinates(command.codes.one_shot)) result.cancelled = command.axes;
  return result;
}

Move Engine::State::move(const Leg& leg, const LengthVector& offset, const ToolAtEnd& tool, bool machine) const {
  Move result;
  result.leg = leg;
  result.tool = tool.tool;
  result.tip = tool.tip;
  for (std::size_t i = 0; i < setup.axes.size(); ++i) result.length.at(i) = offset.axis.at(i);
  if (machine) {
    auto& zero = result.zero.emplace();
    for (std::size_t i = 0; i < setup.axes.size(); ++i) zero.at(i) = interpreter.work().zero(i).value();
  }
  if (interpreter.feed()) result.feed = *interpreter.feed();
  return result;
}

}  // namespace toolcomp::model
