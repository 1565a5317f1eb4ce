#include "fast/program/interpreter.h"

#include <bit>
#include <cmath>
#include <string>

#include "fast/arithmetic/wide.h"
#include "fast/fault.h"
#include "spec/language/input_error.h"

namespace toolcomp::fast {
namespace {

constexpr std::uint16_t bit(std::size_t axis) { return static_cast<std::uint16_t>(1U << axis); }

// Calls f(axis) for each bit of the mask, lowest first; stops at an alarm.
template <class Function>
Alarm for_each_axis(std::uint16_t mask, Function f) {
  for (unsigned rest = mask; rest != 0; rest &= rest - 1)
    if (const Alarm a = f(static_cast<std::size_t>(std::countr_zero(rest)))) return a;
  return alarm::kNone;
}

constexpr std::uint32_t kIjk = Words::set_of("IJK");
constexpr std::uint32_t kMst = Words::set_of("MST");

// The square root of a sum of squares, if it is whole.
std::optional<Int128> whole_length(const std::array<Int128, 3>& v) {
  const Wide square = Wide(v[0]) * Wide(v[0]) + Wide(v[1]) * Wide(v[1]) + Wide(v[2]) * Wide(v[2]);
  const DoubleDouble root = sqrt(square.to_double_double());
  // Exact for roots below 2^100 or so; the test below decides.
  const Int128 whole = static_cast<Int128>(root.hi) + static_cast<Int128>(std::nearbyint(root.lo));
  if ((square - Wide(whole) * Wide(whole)).sign() != 0) return std::nullopt;
  return whole;
}

}  // namespace

Interpreter::Interpreter(const spec::Setup& setup, EventSink& sink)
    : axes_(setup.axes),
      count_(setup.axes.size()),
      xyz_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')},
      inch_setup_(setup.units == spec::Units::inch),
      counts_increments_(!setup.bit(3401, 0, true)),
      increment_places_(2 + static_cast<int>(setup.increment)),
      kinematics_(setup),
      memory_(setup),
      length_(setup),
      sink_(sink),
      leading_edge_(setup, kinematics_, sink),
      inch_program_(inch_setup_) {
  if (setup.control != spec::Control::fanuc)
    throw spec::InputError("setup", 0, 0, "control: only \"fanuc\" programs can be run");
  for (std::size_t axis = 0; axis < count_; ++axis)
    if (spec::is_linear_axis(axes_.letter(axis)))
      linear_ = static_cast<Mask>(linear_ | bit(axis));
    else
      rotary_ = static_cast<Mask>(rotary_ | bit(axis));
  for (std::size_t i = 0; i < origin_.size(); ++i) read_positions(setup.workpiece[i], "workpiece", origin_[i]);
  read_positions(setup.floating_reference, "reference.floating", reference_[0]);
  for (const auto& [number, table] : setup.reference)
    if (number >= 1 && number <= 4) read_positions(table, "reference", reference_[static_cast<std::size_t>(number)]);
  read_positions(setup.position, "position", programmed_);
  for (const std::uint32_t number : {19666U, 19709U, 19710U, 19711U, 19712U, 19713U, 19714U})
    if (const auto value = setup.parameter(number); value && !value->is_zero()) head_offsets_ = true;
  for (std::size_t axis = 0; axis < count_; ++axis)
    if (place(axis, programmed_[axis])) throw spec::InputError("setup", 0, 0, "position: out of range");
  if (kinematics_.defined()) kinematics_.direct(programmed_, pose_);
}

void Interpreter::read_positions(const spec::AxisTable& table, const char* key, Positions& to) const {
  for (const auto& [letter, decimal] : table) {
    const std::size_t axis = axes_.index(letter);
    if (axis == spec::Axes::kNone) continue;
    if (!fits_count(decimal)) throw spec::InputError("setup", 0, 0, std::string(key) + "." + letter + ": too large");
    to[axis] = Count::of(decimal);
  }
}

void Interpreter::block(const spec::Block& block) {
  if (stopped_) return;
  line_ = block.line;
  n_ = block.n;
  if (block.alarm) [[unlikely]] {
    // The reader's alarm has its own inline name.
    if (leading_edge_.active() && leading_edge_.release())
      raise_at(alarm::kLeadingEdgeCommand, leading_edge_.start_line(), leading_edge_.start_n());
    else {
      alarm_event_.number = block.alarm->number;
      raise_at({nullptr, block.alarm->message}, line_, n_);
    }
    return;
  }
  const Words words(block, axes_);
  if (words.unsupported()) return raise(alarm::kUnknownCode);
  if (!words.any()) return;
  if (const Alarm a = run(words)) return raise(a);
  if (words.ends_program()) end();
}

void Interpreter::end() {
  if (stopped_) return;
  if (leading_edge_.active() && leading_edge_.release())
    raise_at(alarm::kLeadingEdgeCommand, leading_edge_.start_line(), leading_edge_.start_n());
  stopped_ = true;
}

// A command alarm: what is held goes out as if the block and everything after it were absent. A start-up that waits for
// its movement then is itself at fault.
void Interpreter::raise(const Alarm& alarm) {
  if (leading_edge_.active() && leading_edge_.release())
    raise_at(alarm::kLeadingEdgeCommand, leading_edge_.start_line(), leading_edge_.start_n());
  else
    raise_at(alarm, line_, n_);
}

void Interpreter::raise_at(const Alarm& alarm, std::uint64_t line, const std::optional<std::uint64_t>& n) {
  alarm_event_.kind = spec::EventKind::alarm;
  if (alarm) alarm_event_.number = alarm.number;
  alarm_event_.message = alarm.message;
  alarm_event_.line = line;
  alarm_event_.n = n;
  stopped_ = true;
  sink_.on(alarm_event_);
}

Interpreter::Compensation Interpreter::compensation_after(const Words& words, std::uint32_t d) const {
  const Code code = words.code(Words::kCompensation);
  const bool active = leading_edge_.active();
  const bool after = (code == kNone ? active : code == 413) && d != 0;
  if (after) return active ? Compensation::stays : Compensation::starts;
  return active ? Compensation::cancels : Compensation::off;
}

Alarm Interpreter::check(const Words& words, Compensation compensation) const {
  const bool compensated = compensation == Compensation::starts || compensation == Compensation::stays;
  const Code motion = words.code(Words::kMotion) == kNone ? motion_ : words.code(Words::kMotion);
  const Code length = words.code(Words::kLength);
  const auto mode_before = length_.mode();
  const bool along_before = mode_before == ToolLengthOffset::Mode::along_tool;
  const bool along = length == 435 || (along_before && length != 490);
  const bool ijk = words.has_any(kIjk);
  const bool moves = words.axes() != 0 || (along && ijk);
  const Code one_shot = words.code(Words::kOneShot);

  // G41.3, G40 and the commands the mode forbids.
  if (compensated) {
    if (one_shot != kNone || words.code(Words::kWorkpiece) != kNone || words.code(Words::kUnits) != kNone)
      return alarm::kForbiddenInCompensation;
    if (words.has_any(kMst) && words.axes() != 0 && compensation == Compensation::stays)
      return alarm::kForbiddenInCompensation;
  }
  if (compensation == Compensation::starts) {
    if (moves || words.suppresses_look_ahead()) return alarm::kLeadingEdgeFormat;
    if (motion != 0 && motion != 10) return alarm::kLeadingEdgeStart;
  }
  if (compensation == Compensation::cancels && moves) return alarm::kLeadingEdgeFormat;
  if (compensation == Compensation::stays && (motion > 10 || words.code(Words::kCompensation) == 413))
    return alarm::kLeadingEdgeCommand;

  // G43.5.
  if (length == 435 || along_before) {
    if (along_before && (length == 430 || length == 440)) return alarm::kLengthExclusion;
    if (length == 435 && length_.live() != 0) return alarm::kLengthExclusion;
    if (compensated && (length == 435 || length == 490)) return alarm::kDirectionFormat;
    if (along && motion > 10 && (length == 435 || ijk)) return alarm::kDirectionFormat;
    if (along && words.has('Q')) return alarm::kLeanAngle;
    if (length == 435 && (kinematics_.type() == 12 || kinematics_.type() == 21 || head_offsets_))
      return alarm::kKinematics;
    if (along && (words.axes() & rotary_) != 0) return alarm::kToolDirection;
    if (along && ijk && (!words.has('I') || words['I'].is_zero()) && (!words.has('J') || words['J'].is_zero()) &&
        (!words.has('K') || words['K'].is_zero()))
      return alarm::kToolDirection;
    if (along && ((one_shot != kNone && one_shot != 40 && one_shot != 100) || words.code(Words::kWorkpiece) != kNone))
      return alarm::kForbiddenUnderDirection;
  }
  return alarm::kNone;
}

Alarm Interpreter::run(const Words& words) {
  std::uint32_t d = d_;
  if (words.has('D')) d = whole_number(words['D'], memory_.count());
  if (d > memory_.count()) return alarm::kOffsetNumber;
  if (words.has('H') && whole_number(words['H'], memory_.count()) > memory_.count()) return alarm::kOffsetNumber;
  const Compensation compensation = compensation_after(words, d);
  if (const Alarm a = check(words, compensation)) return a;

  // Modal state.
  if (const Code code = words.code(Words::kMotion); code != kNone) motion_ = code;
  if (const Code code = words.code(Words::kPlane); code != kNone)
    plane_ = code == 170 ? spec::Plane::xy : (code == 180 ? spec::Plane::zx : spec::Plane::yz);
  if (const Code code = words.code(Words::kDistance); code != kNone) incremental_ = code == 910;
  if (const Code code = words.code(Words::kUnits); code != kNone) inch_program_ = code == 200;
  if (words.has('F')) {
    const Factor factor = inch_program_ == inch_setup_ ? Factor::one
                          : inch_program_              ? Factor::inch_to_mm
                                                       : Factor::mm_to_inch;
    feed_ = Count::of(words['F'], fault(Fault::feed_not_converted) ? Factor::one : factor).nearest();
  }

  // Tool length offset.
  const auto mode_before = length_.mode();
  length_.begin_block();
  if (const Alarm a = length_.restore(words, memory_)) return a;
  if (mode_before == ToolLengthOffset::Mode::along_tool && words.code(Words::kLength) == 490) {
    end_tool_direction();
    length_.begin_block();
  }
  if (const Alarm a = length_.apply(words, memory_, normal_axis())) return a;
  const bool ended = mode_before == ToolLengthOffset::Mode::along_tool && length_.mode() == ToolLengthOffset::Mode::off;
  const bool changed = length_.changed() && !ended && !fault(Fault::zero_move_missing);
  if (length_.changed()) stale_ = static_cast<Mask>(linear_ | rotary_);
  if (const Alarm a = tool_direction_words(words, mode_before)) return a;

  // Radius of leading edge offset.
  d_ = d;
  if (words.has('D') || compensation == Compensation::starts) {
    if (compensation == Compensation::starts || compensation == Compensation::stays) {
      const Count value = memory_.d(d_);
      if (!memory_.fits(value)) return alarm::kOffsetValue;
      radius_ = value.nearest();
    }
  }

  if (const Code code = words.code(Words::kWorkpiece); code != kNone) select_workpiece(code);
  if (words.suppresses_look_ahead() && compensation == Compensation::stays)
    if (leading_edge_.release()) return alarm::kLeadingEdgeCommand;

  const bool forced = words.code(Words::kLength) == 435;
  switch (words.code(Words::kOneShot)) {
    case kNone:
      return motion(words, compensation, true, changed || forced);
    case 280:
    case 300:
    case 301:
      if (words.axes() != 0) return to_reference(words);
      break;
    case 290:
      if (words.axes() != 0) return from_reference(words);
      break;
    case 530:
      if (words.axes() != 0 && !incremental_) return to_machine_position(words);
      break;
    case 920:
      if (const Alarm a = motion(words, compensation, false, changed)) return a;
      return shift_coordinates(words);
    case 100:
      if (const Alarm a = motion(words, compensation, false, changed || forced)) return a;
      return write_offset(words);
    default:
      break;
  }
  return motion(words, compensation, false, changed || forced);
}

Count Interpreter::value(const spec::Decimal& word, bool linear) const {
  const int places = counts_increments_ && !word.point
                         ? increment_places_ + (linear && inch_program_ && !fault(Fault::inch_increment) ? 1 : 0)
                         : 0;
  if (!linear || inch_program_ == inch_setup_ || fault(Fault::inch_not_converted))
    return Count::of(word, Factor::one, places);
  return Count::of(word, inch_program_ ? Factor::inch_to_mm : Factor::mm_to_inch, places);
}

Count Interpreter::target(const Words& words, std::size_t axis) const {
  const Count word = axis_value(words, axis);
  if (!incremental_) return word;
  if (fault(Fault::incremental_from_offset_position)) return programmed_[axis] + length_[axis] + word;
  return programmed_[axis] + word;
}

Alarm Interpreter::place(std::size_t axis, const Count& position) {
  if (!position.in_range()) return alarm::kRange;
  programmed_[axis] = position;
  programmed_value_[axis] = position.nearest();
  stale_ = static_cast<Mask>(stale_ | bit(axis));
  return alarm::kNone;
}

Alarm Interpreter::refresh() {
  const Alarm a = for_each_axis(stale_, [this](std::size_t axis) {
    axes_value_[axis] = programmed_value_[axis];
    if ((length_.live() & bit(axis)) != 0) {
      const Count sum = programmed_[axis] + length_[axis];
      if (!sum.in_range()) return alarm::kRange;
      axes_value_[axis] = sum.nearest();
    }
    return alarm::kNone;
  });
  stale_ = 0;
  return a;
}

const Direction& Interpreter::direction() const {
  return length_.mode() == ToolLengthOffset::Mode::along_tool ? tool_ : pose_;
}

std::size_t Interpreter::normal_axis() const {
  if (plane_ == spec::Plane::xy) return xyz_[2];
  return plane_ == spec::Plane::zx ? xyz_[1] : xyz_[0];
}

spec::MoveType Interpreter::straight() const {
  return motion_ == 0 ? spec::MoveType::rapid : spec::MoveType::linear;
}

void Interpreter::fill(Event& event, spec::MoveType type, spec::Cause cause) {
  event.line = line_;
  event.n = n_;
  event.type = type;
  event.cause = cause;
  event.programmed.present = linear_;
  event.point.present = linear_;
  event.axes.present = static_cast<Mask>(linear_ | rotary_);
  event.machine.present = 0;
  for (std::size_t axis = 0; axis < count_; ++axis) {
    event.programmed.value[axis] = programmed_value_[axis];
    event.point.value[axis] = programmed_value_[axis];
    event.axes.value[axis] = axes_value_[axis];
  }
  event.arc.reset();
  event.feed.reset();
  if (type != spec::MoveType::rapid) event.feed = feed_;
  const bool along = length_.mode() == ToolLengthOffset::Mode::along_tool;
  if (!along && !kinematics_.defined()) {
    event.tool_axis.reset();
    return;
  }
  const Eigen::Vector3d& unit = direction().unit;
  event.tool_axis.emplace(std::array<double, 3>{unit[0] + 0.0, unit[1] + 0.0, unit[2] + 0.0});  // never -0
  if (along) {
    const double length = length_.length().nearest();
    for (std::size_t i = 0; i < 3; ++i)
      if (xyz_[i] != spec::Axes::kNone)
        event.axes.value[xyz_[i]] = programmed_value_[xyz_[i]] + length * unit[static_cast<Eigen::Index>(i)];
  }
}

void Interpreter::fill_machine(Event& event) const {
  event.machine.present = event.axes.present;
  for (std::size_t axis = 0; axis < count_; ++axis)
    event.machine.value[axis] = (programmed_[axis] + length_[axis] + machine_origin(axis)).nearest();
}

Alarm Interpreter::motion(const Words& words, Compensation compensation, bool own, bool extra) {
  Move& move = leading_edge_.next();
  const bool along = length_.mode() == ToolLengthOffset::Mode::along_tool;
  const Mask axes = own ? words.axes() : Mask{0};
  const bool compensated = compensation == Compensation::stays;
  std::array<Count, 3> before;
  const Mask rounded_before = rounded_;
  if (compensated)
    for (std::size_t i = 0; i < 3; ++i) before[i] = xyz_[i] == spec::Axes::kNone ? Count() : programmed_[xyz_[i]];

  std::optional<spec::Arc<double>> arc;
  bool event = axes != 0 || extra || (own && along && words.has_any(kIjk));
  if (own && motion_ > 10) {
    if (const Alarm a = plan_arc(words, arc)) return a;
    event |= arc.has_value();
  }

  bool turned = false;
  if (const Alarm a = for_each_axis(axes, [&](std::size_t axis) {
        turned |= kinematics_.turns_with(axis);
        if (!incremental_) rounded_ = static_cast<Mask>(rounded_ & ~bit(axis));
        return place(axis, target(words, axis));
      }))
    return a;
  if (turned) kinematics_.direct(programmed_, pose_);
  if (const Alarm a = refresh()) return a;

  const spec::MoveType type = arc ? spec::MoveType::arc : straight();
  if (event) {
    fill(move.event, type, spec::Cause::programmed);
    move.event.arc = arc;
  }
  switch (compensation) {
    case Compensation::off:
      if (event) leading_edge_.pass();
      break;
    case Compensation::starts: {
      if (event) leading_edge_.pass();
      Move& start = leading_edge_.next();
      fill(start.event, straight(), spec::Cause::start_up);
      start.direction = direction();
      start.radius = radius_;
      leading_edge_.start();
      break;
    }
    case Compensation::stays: {
      std::array<Count, 3> delta;
      Mask rounded = 0;
      for (std::size_t i = 0; i < 3; ++i)
        if (xyz_[i] != spec::Axes::kNone) {
          delta[i] = programmed_[xyz_[i]] - before[i];
          rounded = static_cast<Mask>(rounded | ((rounded_before | rounded_) & bit(xyz_[i]) & axes));
        }
      set(move.displacement, delta, rounded != 0 ? 2 : 0);
      move.direction = direction();
      move.radius = radius_;
      const Alarm a = leading_edge_.block(event, !move.displacement.zero);
      if (a) {
        raise_at(a, leading_edge_.start_line(), leading_edge_.start_n());
      }
      break;
    }
    case Compensation::cancels: {
      if (const Alarm a = leading_edge_.finish()) {
        raise_at(a, leading_edge_.start_line(), leading_edge_.start_n());
        break;
      }
      if (event) leading_edge_.send_compensated();
      Move& cancel = leading_edge_.next();
      fill(cancel.event, straight(), spec::Cause::cancel);
      leading_edge_.cancel();
      break;
    }
  }
  return alarm::kNone;
}

// G02, G03: an arc in the plane where the block names an axis of it, a centre or, with an axis word, a radius.
Alarm Interpreter::plan_arc(const Words& words, std::optional<spec::Arc<double>>& arc) const {
  const std::size_t first = plane_ == spec::Plane::xy ? 0 : (plane_ == spec::Plane::zx ? 2 : 1);
  const std::array<std::size_t, 2> in_plane{first, (first + 1) % 3};  // of X, Y, Z
  std::array<Count, 2> start;
  std::array<Count, 2> end;
  std::array<Count, 2> to_center;
  bool named = false;
  bool centered = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t axis = xyz_[in_plane[i]];
    const char letter = static_cast<char>('I' + in_plane[i]);
    if (axis != spec::Axes::kNone) {
      start[i] = end[i] = programmed_[axis];
      if ((words.axes() & bit(axis)) != 0) {
        end[i] = target(words, axis);
        named = true;
      }
    }
    if (words.has(letter)) {
      to_center[i] = value(words[letter], true);
      centered = true;
    }
  }
  const bool by_radius = words.has('R') && (words.axes() != 0 || centered);
  if (!named && !centered && !by_radius) return alarm::kNone;
  if (!end[0].in_range() || !end[1].in_range()) return alarm::kRange;
  const bool clockwise = motion_ == 20;
  ArcGeometry geometry;
  if (const Alarm a = by_radius ? arc_by_radius(start, end, value(words['R'], true), clockwise, geometry)
                                : arc_by_center(start, end, to_center, clockwise, geometry))
    return a;
  arc.emplace();
  arc->plane = plane_;
  arc->direction = clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  for (std::size_t i = 0; i < 2; ++i)
    if (const std::size_t axis = xyz_[in_plane[i]]; axis != spec::Axes::kNone)
      arc->center.set(axis, geometry.center[i]);
  arc->sweep = geometry.sweep;
  arc->radius = geometry.radius;
  return alarm::kNone;
}

Alarm Interpreter::tool_direction_words(const Words& words, ToolLengthOffset::Mode before) {
  if (length_.mode() != ToolLengthOffset::Mode::along_tool) return alarm::kNone;
  if (words.has_any(kIjk)) {
    std::array<Count, 3> component;
    for (std::size_t i = 0; i < 3; ++i)
      if (const char letter = static_cast<char>('I' + i); words.has(letter)) component[i] = value(words[letter], true);
    const bool small = component[0].is_small() && component[1].is_small() && component[2].is_small();
    std::array<Int128, 3> whole;
    for (std::size_t i = 0; i < 3; ++i) whole[i] = small ? Int128{component[i].small()} : component[i].units();
    tool_ = whole_direction(whole);
  } else if (before != ToolLengthOffset::Mode::along_tool) {
    tool_ = pose_;
  }
  return alarm::kNone;
}

// G49 after G43.5: the programmed position becomes that of the axes, P + L V. It is exact where |V| is whole and L V_i a
// multiple of the unit; elsewhere it is rounded to the unit, 8e-21, and the axis is marked.
void Interpreter::end_tool_direction() {
  const Int128 length = length_.length().units();
  const std::optional<Int128> norm = tool_.is_whole ? whole_length(tool_.whole) : std::nullopt;
  const FineVector unit = kinematics_.refine(tool_);
  for (std::size_t i = 0; i < 3; ++i) {
    if (xyz_[i] == spec::Axes::kNone) continue;
    const DoubleDouble along = to_double_double(length) * unit[i];
    const Int128 units = static_cast<Int128>(along.hi) + static_cast<Int128>(std::nearbyint(along.lo));
    const bool exact =
        length == 0 || (norm && (Wide(units) * Wide(*norm) - Wide(length) * Wide(tool_.whole[i])).sign() == 0);
    // Both terms are far below the limit, so the sum is checked with the next position.
    programmed_[xyz_[i]] += Count::of_units(units);
    programmed_value_[xyz_[i]] = programmed_[xyz_[i]].nearest();
    if (!exact) rounded_ = static_cast<Mask>(rounded_ | bit(xyz_[i]));
  }
  stale_ = static_cast<Mask>(linear_ | rotary_);
}

// The machine stays where it is: the programmed position shifts by the difference of the origins.
void Interpreter::select_workpiece(Code code) {
  const auto chosen = static_cast<std::size_t>((code - 540) / 10);
  for (std::size_t axis = 0; axis < count_; ++axis) {
    programmed_[axis] += origin_[workpiece_][axis] - origin_[chosen][axis];
    programmed_value_[axis] = programmed_[axis].nearest();
  }
  workpiece_ = chosen;
  stale_ = static_cast<Mask>(linear_ | rotary_);
  if (kinematics_.defined()) kinematics_.direct(programmed_, pose_);
}

Alarm Interpreter::shift_coordinates(const Words& words) {
  const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
    const Count word = axis_value(words, axis);
    shift_[axis] += programmed_[axis] - word;
    if ((rounded_ & bit(axis)) != 0) shifted_rounded_ = static_cast<Mask>(shifted_rounded_ | bit(axis));
    rounded_ = static_cast<Mask>(rounded_ & ~bit(axis));
    if (!shift_[axis].in_range()) return alarm::kRange;
    return place(axis, word);
  });
  if (kinematics_.defined()) kinematics_.direct(programmed_, pose_);
  return a;
}

Alarm Interpreter::write_offset(const Words& words) {
  if (!words.has('L') || !words.has('R')) return alarm::kNone;
  const std::uint32_t list = whole_number(words['L'], 99);
  const std::uint32_t number = words.has('P') ? whole_number(words['P'], memory_.count()) : 0;
  const auto written = memory_.write(list, number, value(words['R'], true), incremental_);
  if (written.alarm) return written.alarm;
  if (written.changes_h) length_.edited(number);
  Event& event = setting_event_;
  event.kind = spec::EventKind::setting;
  event.line = line_;
  event.n = n_;
  event.setting = written.setting;
  event.value = written.value.nearest();
  sink_.on(event);
  return alarm::kNone;
}

Alarm Interpreter::to_machine_position(const Words& words) {
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
        length_.cancel(axis);
        rounded_ = static_cast<Mask>((rounded_ & ~bit(axis)) | (shifted_rounded_ & bit(axis)));
        return place(axis, axis_value(words, axis) - machine_origin(axis));
      }))
    return a;
  return send_machine_move(spec::Cause::programmed);
}

Alarm Interpreter::to_reference(const Words& words) {
  std::size_t point = 1;
  if (words.code(Words::kOneShot) == 301) point = 0;
  if (words.code(Words::kOneShot) == 300) {
    point = words.has('P') ? whole_number(words['P'], 4) : 2;
    if (point < 2 || point > 4) return alarm::kReferenceNumber;
  }
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
        if (!incremental_) rounded_ = static_cast<Mask>(rounded_ & ~bit(axis));
        intermediate_[axis] = target(words, axis);
        has_intermediate_ = static_cast<Mask>(has_intermediate_ | bit(axis));
        return place(axis, intermediate_[axis]);
      }))
    return a;
  if (const Alarm a = send_machine_move(spec::Cause::reference)) return a;
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
        length_.cancel(axis);
        rounded_ = static_cast<Mask>((rounded_ & ~bit(axis)) | (shifted_rounded_ & bit(axis)));
        return place(axis, reference_[point][axis] - machine_origin(axis));
      }))
    return a;
  return send_machine_move(spec::Cause::reference);
}

Alarm Interpreter::from_reference(const Words& words) {
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
        return (has_intermediate_ & bit(axis)) != 0 ? place(axis, intermediate_[axis]) : alarm::kNone;
      }))
    return a;
  if (const Alarm a = send_rapid(spec::Cause::programmed)) return a;
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) { return place(axis, target(words, axis)); }))
    return a;
  return send_rapid(spec::Cause::programmed);
}

Alarm Interpreter::send_rapid(spec::Cause cause) {
  if (kinematics_.defined()) kinematics_.direct(programmed_, pose_);
  if (const Alarm a = refresh()) return a;
  fill(leading_edge_.next().event, spec::MoveType::rapid, cause);
  leading_edge_.pass();
  return alarm::kNone;
}

Alarm Interpreter::send_machine_move(spec::Cause cause) {
  if (kinematics_.defined()) kinematics_.direct(programmed_, pose_);
  if (const Alarm a = refresh()) return a;
  Event& event = leading_edge_.next().event;
  fill(event, spec::MoveType::rapid, cause);
  fill_machine(event);
  leading_edge_.pass();
  return alarm::kNone;
}

}  // namespace toolcomp::fast
