#include "fast/fanuc/interpreter/interpreter.h"

#include "fast/basis/fault.h"
#include "fast/fanuc/interpreter/usual_block.h"
#include "spec/language/input_error.h"

namespace toolcomp::fast {

Interpreter::Interpreter(const spec::Setup& setup, EventSink& sink, std::uint32_t samples)
    : kinematics_(setup),
      axes_(setup, kinematics_),
      units_(setup),
      modal_(axes_.xyz),
      positions_(setup, axes_),
      attitude_(setup, kinematics_, axes_, units_, modal_, positions_, sink, samples),
      memory_(setup),
      measurement_(setup),
      sink_(sink),
      leading_edge_(setup, kinematics_, sink),
      is_b_(setup.cutter_compensation == spec::CutterCompensationType::b),
      cutter_b_(setup, sink),
      cutter_c_(setup, sink),
      tool_side_(setup, kinematics_, sink),
      cutter_value_(setup, memory_) {
  if (setup.control != spec::Control::fanuc)
    throw spec::InputError("setup", 0, 0, "control: only \"fanuc\" programs can be run");
  positions_.read(setup);
  attitude_.take_zeros();
  if (kinematics_.defined()) attitude_.turn();
}

void Interpreter::block(const spec::Block& block) {
  if (side_lines_.letters != 0)
    side_block(block);
  else
    any_block(block);
}

void Interpreter::any_block(const spec::Block& block) {
  if (stopped_) return;
  line_ = block.line;
  n_ = block.n;
  if (block.alarm) [[unlikely]] {
    if (!release_held()) send_alarm(block.alarm->number, block.alarm->message, line_, n_);
    return;
  }
  const Words words(block, axes_.letters);
  if (words.unsupported()) [[unlikely]] {
    raise(alarm::kUnknownCode);
    return;
  }
  if (!words.any()) {
    // A sequence or program number alone is a block without movement where blocks are counted.
    if (cutter_active()) {
      if (const Alarm a = cutter_move(words)) raise(a);
    } else if (tool_side_on()) {
      if (const Alarm a = tool_side_move(words)) raise(a);
    }
    return;
  }
  if (const Alarm a = run(words)) [[unlikely]] {
    raise(a);
    return;
  }
  if (words.ends_program()) end();
}

void Interpreter::end() {
  if (stopped_) return;
  if (release_held()) return;
  stopped_ = true;
}

bool Interpreter::release_held() {
  if (leading_edge_.active() && leading_edge_.release()) {
    raise_at_start(alarm::kLeadingEdgeCommand);
    return true;
  }
  if (tool_side_.active())
    if (const StageEnd held = tool_side_.release()) end_run(held);
  if (stopped_ || !cutter_active()) return stopped_;
  const StageEnd held = is_b_ ? cutter_b_.release() : cutter_c_.release();
  if (held) end_run(held);
  return stopped_;
}

// A command alarm: what is held goes out as if the block and everything after it were absent. A block held may then
// itself be at fault.
void Interpreter::raise(const Alarm& alarm) {
  if (release_held()) return;
  send_alarm(alarm.number, alarm.message, line_, n_);
}

void Interpreter::raise_at_start(const Alarm& alarm) {
  send_alarm(alarm.number, alarm.message, leading_edge_.start_line(), leading_edge_.start_n());
}

void Interpreter::send_alarm(const spec::Name& number, const char* message, std::uint64_t line,
                             const std::optional<std::uint64_t>& n, spec::EventKind kind) {
  stopped_ = true;
  notice_.kind = kind;
  notice_.number = number;
  notice_.message = message;
  notice_.line = line;
  notice_.n = n;
  const bool open = kind == spec::EventKind::undecided;  // whatever the outcome
  notice_.permitted = {open, open, open};
  sink_.on(notice_);
}

void Interpreter::end_run(const StageEnd& end) {
  if (end.undecided == nullptr)
    send_alarm(end.alarm.number, end.alarm.message, end.line, end.n);
  else
    send_alarm(end.undecided, "", end.line, end.n, spec::EventKind::undecided);
}

[[gnu::always_inline]] inline Alarm Interpreter::run(const Words& words) {
  Alarm alarm;
  if (usual_block(words, alarm)) [[likely]]
    return alarm;
  Plan plan;
  if (const Alarm a = check(words, plan)) return a;
  return apply(words, plan);
}

void Interpreter::set_feed(const Words& words) { modal_.set_feed(units_.feed(words['F'])); }

// Everything is allowed but what depends on positions (arcs) and on the length offset, whose alarms come last.
Alarm Interpreter::apply(const Words& words, const Plan& plan) {
  take_codes(words, plan);
  const Code one_shot = words.code(Words::kOneShot);
  BlockArc arc;
  if ((one_shot == kNone || words.is_tool_offset()) && modal_.motion() > 10)
    if (const Alarm a =
            plan_arc(words, arc.event, arc.words, !makes_tool_arc(words) && !(plan.side_before || plan.side_after)))
      return a;
  Shifts shifts;
  if (words.is_tool_offset())
    if (const Alarm a = plan_tool_offset(words, arc.words, arc.event, shifts)) return a;

  bool extra = false;
  if (const Alarm a = take_length(words, plan, extra)) return a;
  d_ = plan.d;
  if (plan.compensation == Compensation::starts || (plan.compensation == Compensation::stays && words.has('D')))
    radius_ = memory_.d(d_).nearest();
  if (words.suppresses_look_ahead() &&
      (plan.compensation == Compensation::stays || plan.compensation == Compensation::cancels))
    if (const Alarm a = leading_edge_.release()) return a;
  in_cutter_ = plan.cutter;
  cutter_value_.take_number(words);
  if (in_cutter_) take_cutter(words, plan);
  if (stopped_) return alarm::kNone;
  begin_tool_side(words);
  if (plan.side_before || plan.side_after) {
    if (words.suppresses_look_ahead())
      if (const StageEnd end = tool_side_.release()) {
        end_run(end);
        return alarm::kNone;
      }
    return tool_side_motion(words, extra, arc.event, arc.words);
  }
  if (const Alarm a = for_each_axis(shifts.axes, [&](std::size_t axis) {
        positions_.tool_offset().add(axis, shifts.by[axis]);
        return positions_.tool_offset()[axis].in_range() ? alarm::kNone : alarm::kRange;
      }))
    return a;
  return move(words, plan, extra, arc);
}

// The codes and values that stay in force, but for offsets.
void Interpreter::take_codes(const Words& words, const Plan& plan) {
  modal_.set_motion(plan.motion);
  if (const Code code = words.code(Words::kPlane); code != kNone) modal_.select_plane(plane_of(code));
  if (const Code code = words.code(Words::kDistance); code != kNone) modal_.set_incremental(code == 910);
  if (const Code code = words.code(Words::kUnits); code != kNone) units_.select(code);
  if (words.has('F')) set_feed(words);
  if (plan.ends_along) {
    attitude_.end(plan.along);
    send_to(sink_);
  }
  modal_.set_by_vector(plan.vector);
  if (const Code code = words.code(Words::kWorkpiece); code != kNone) {
    select_workpiece(code);
    if (plan.cutter) rename_in_cutter();
  }
}

// The length offset, on the axes or along the tool. `extra`: the block moves without axis words too.
Alarm Interpreter::take_length(const Words& words, const Plan& plan, bool& extra) {
  ToolLengthOffset& length = positions_.length();
  length.begin_block();
  if (const Alarm a = length.restore(words, memory_)) return a;
  if (const Alarm a = length.apply(words, memory_, modal_.normal_axis())) return a;
  if (length.changed()) positions_.make_stale();
  if (plan.along) attitude_.take_length();
  // G43.4 and G43.5 always make their move; the G49 that ends them makes none.
  extra = words.starts_tip_control() || (length.changed() && !plan.ends_along && !fault(Fault::zero_move_missing));
  attitude_.directions().begin_block();
  if (!plan.along) return alarm::kNone;
  // Moves that a compensation inserts are none of the block; G41.3 and its G40 take a change of the length along.
  const bool edge = plan.compensation == Compensation::starts || plan.compensation == Compensation::cancels;
  const bool type_c = tool_side_.type() == StartType::c && plan.side_before != plan.side_after;
  attitude_.set_sampled(!words.starts_tip_control() && !edge && (!type_c || extra));
  if (words.starts_tip_control()) {
    attitude_.begin(words);
    if (attitude_.completes_moves()) send_to(attitude_.tip());
  }
  if (!attitude_.tip().active() && (!attitude_.plans_tool() || attitude_.starts())) attitude_.direct(words);
  return alarm::kNone;
}

// What the codes and numbers of a block say to cutter compensation.
void Interpreter::take_cutter(const Words& words, const Plan& plan) {
  begin_cutter(words);
  const Code code = words.code(Words::kCompensation);
  const bool retires = code == 413 || is_tool_side(code) || words.is_tool_offset() || words.starts_tip_control() ||
                       plan.compensation == Compensation::cancels;
  CutterBlock& block = cutter_next();
  block.sets = plan.writes && !retires;
  if (block.sets) store_offset(plan.write, block.setting, block.setting_value);
  if (retires) retire_cutter();
}

// The moves of a block outside tool side compensation.
Alarm Interpreter::move(const Words& words, const Plan& plan, bool extra, const BlockArc& arc) {
  const Code one_shot = words.code(Words::kOneShot);
  if (words.axes() != 0) switch (one_shot) {
      case 280:
      case 300:
      case 301:
        return to_reference(words);
      case 290:
        return from_reference(words);
      case 530:
        if (!modal_.incremental()) return to_machine_position(words);
        break;
      case 370:
        return measure(words);
      default:
        break;
    }
  if (in_cutter_)
    return one_shot == 920 ? shift_in_cutter(words, extra)
                           : cutter_motion(words, one_shot, extra, arc.event, arc.words);
  const bool own = one_shot == kNone || words.is_tool_offset();
  if (const Alarm a = motion(words, plan.compensation, own, extra, arc.event)) return a;
  if (one_shot == 920) return shift_coordinates(words);
  if (plan.writes) write_offset(plan.write);
  return alarm::kNone;
}

// Where the moves of blocks go. Nothing is held where G43.4 or G43.5 begins or ends.
void Interpreter::send_to(EventSink& sink) {
  leading_edge_.set_sink(sink);
  tool_side_.set_sink(sink);
}

void Interpreter::store_offset(const OffsetMemory::Write& write, spec::Name& name, double& stored) {
  name = memory_.store(write);
  stored = memory_.value(write).nearest();
  if (memory_.changes_h(write)) positions_.length().edited(write.number);
  cutter_value_.edit();
}

void Interpreter::write_offset(const OffsetMemory::Write& write) {
  notice_.kind = spec::EventKind::setting;
  notice_.line = line_;
  notice_.n = n_;
  store_offset(write, notice_.setting, notice_.value);
  sink_.on(notice_);
}

}  // namespace toolcomp::fast
