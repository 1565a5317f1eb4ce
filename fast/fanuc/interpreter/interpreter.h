// Interprets blocks: modal state, positions, tool direction; sends moves through the compensation stages.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fast/arithmetic/count.h"
#include "fast/basis/alarm.h"
#include "fast/basis/event.h"
#include "fast/basis/fault.h"
#include "fast/basis/short_cut.h"
#include "fast/fanuc/cutter_compensation_b/cutter_compensation_b.h"
#include "fast/fanuc/cutter_compensation_c/cutter_compensation_c.h"
#include "fast/fanuc/leading_edge_offset/leading_edge_offset.h"
#include "fast/fanuc/program/arc.h"
#include "fast/fanuc/program/cutter_block.h"
#include "fast/fanuc/program/words.h"
#include "fast/fanuc/tool_center_point_control/tool_center_point_control.h"
#include "fast/fanuc/tool_length_measurement/tool_length_measurement.h"
#include "fast/fanuc/tool_length_offset/offset_memory.h"
#include "fast/fanuc/tool_length_offset/tool_length_offset.h"
#include "fast/fanuc/tool_offset/tool_offset.h"
#include "fast/fanuc/tool_posture_control/posture.h"
#include "fast/fanuc/tool_side_compensation/tool_side_compensation.h"
#include "fast/kinematics/kinematics.h"
#include "fast/kinematics/machine.h"
#include "spec/language/block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Letters that make an arc of a block under G02 or G03.
inline constexpr std::uint32_t kArcLetters = Words::set_of("IJKR");

// Everything the control knows while it runs a program. Positions are exact, in workpiece coordinates without offsets,
// lengths in setup units, angles in degrees.
class Interpreter {
 public:
  // Throws spec::InputError for a setup the control could not have.
  Interpreter(const spec::Setup& setup, EventSink& sink, std::uint32_t samples);

  void block(const spec::Block& block);
  void end();
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  using Positions = std::array<Count, spec::kMaxAxes>;
  using RotaryPositions = std::array<Count, 2>;  // of the 1st and 2nd rotary axis, where they are there
  using Mask = std::uint16_t;                    // bit i: axis i
  // What a block does to leading edge offset.
  enum class Compensation : std::uint8_t { off, starts, stays, cancels };
  // A number of the cutter: D, or H where 5001#2 = 1.
  struct OffsetNumber {
    std::uint32_t number = 0;
    bool from_h = false;
  };
  // What the words of a block say about it, before anything is changed.
  struct Plan {
    Compensation compensation = Compensation::off;
    std::uint32_t d = 0;
    Code motion = 0;
    bool along = false;        // G43.4 or G43.5 is in force after the block
    bool vector = false;       // and it is G43.5
    bool ends_along = false;   // the one in force before is ended, by G49 or by another
    bool cutter = false;       // the block passes cutter compensation
    bool side_before = false;  // tool side compensation is on before the block
    bool side_after = false;   // and after it
    OffsetMemory::Write write;
    bool writes = false;
  };

  // interpreter.cpp: one block, step by step.
  void read_positions(const spec::AxisTable& table, const char* key, Positions& to) const;
  void any_block(const spec::Block& block);
  [[nodiscard]] Alarm run(const Words& words);
  // The short cut of run(), usual_block.h. False, and nothing is done: any other block.
  [[nodiscard]] bool usual_block(const Words& words, Alarm& alarm);
  [[nodiscard]] Alarm apply(const Words& words, const Plan& plan);
  void set_feed(const Words& words);
  void write_offset(const OffsetMemory::Write& write);
  void store_offset(const OffsetMemory::Write& write, spec::Name& name, double& stored);
  void raise(const Alarm& alarm);
  void raise_at_start(const Alarm& alarm);
  // Everything a stage holds goes out; true if that ended the run.
  [[nodiscard]] bool release_held();
  void send_alarm(const spec::Name& number, const char* message, std::uint64_t line,
                  const std::optional<std::uint64_t>& n, spec::EventKind kind = spec::EventKind::alarm);

  // check.cpp: the alarms of commands, in their order.
  [[nodiscard]] Alarm check(const Words& words, Plan& plan) const;
  [[nodiscard]] Alarm check_tip_control(const Words& words, const Plan& plan) const;
  [[nodiscard]] Alarm check_tip_control_start(const Words& words, const Plan& plan) const;
  [[nodiscard]] Alarm check_leading_edge(const Words& words, const Plan& plan) const;
  [[nodiscard]] Alarm check_tool_side(const Words& words, const Plan& plan) const;
  [[nodiscard]] Alarm check_cutter(const Words& words, const Plan& plan) const;
  [[nodiscard]] Alarm check_measurement(const Words& words) const;
  [[nodiscard]] bool stays(const Words& words, unsigned axes) const;
  [[nodiscard]] std::uint32_t reference_point(const Words& words) const;

  // motion.cpp: own moves and their events. `own` words are positions; `extra`: a move even without them.
  // An axis that is not there stands at 0.
  [[nodiscard]] const Count& programmed(std::size_t axis) const {
    static constexpr Count kNowhere;
    return axis == spec::Axes::kNone ? kNowhere : programmed_[axis];
  }
  [[nodiscard]] Alarm motion(const Words& words, Compensation compensation, bool own, bool extra,
                             const std::optional<spec::Arc<double>>& arc);
  [[nodiscard]] Alarm place(std::size_t axis, const Count& position);
  // The positions of these axes and what follows from them: the tool direction, and what the axes are sent to.
  [[nodiscard]] Alarm place_words(const Words& words, Mask axes);
  [[nodiscard]] Alarm place_positions(const Words& words, Mask axes);
  [[nodiscard]] bool place_usual(const spec::Decimal& word, std::size_t axis);
  void add_offset(std::size_t axis);
  [[nodiscard]] Alarm refresh();
  // Of an arc everything but event.arc.
  void fill(Event& event, spec::MoveType type, spec::Cause cause);
  // The same in place, for the usual block.
  void fill_here(Event& event, spec::MoveType type, spec::Cause cause);
  void fill_tool_axis(Event& event);
  void fill_machine(Event& event) const;
  void fill_displaced_machine(Event& event) const;
  void add_length(Event& event) const;
  // A word in setup units.
  [[nodiscard]] Count value(const spec::Decimal& word, bool linear, bool inch_program) const {
    if (!counts_increments_ && inch_program == inch_setup_) [[likely]]
      return Count::of(word);
    return converted(word, linear, inch_program);
  }
  // A linear one into `to`: the usual word without a copy.
  void read_word(Count& to, const spec::Decimal& word) const;
  [[nodiscard]] Count converted(const spec::Decimal& word, bool linear, bool inch_program) const;
  [[nodiscard]] Count target(const Words& words, std::size_t axis) const;
  [[nodiscard]] Factor factor(bool inch_program) const;
  [[nodiscard]] spec::MoveType straight() const {
    return motion_ == 0 ? spec::MoveType::rapid : spec::MoveType::linear;
  }

  // arc_words.cpp
  // G02 or G03 in force, and an axis word of the plane or a letter of an arc: anything else is straight. A block with a
  // code of group 00 but G45 to G48, a dwell say, is no arc, whatever its words.
  [[nodiscard]] bool is_arc(const Words& words) const {
    return motion_ > 10 && ((words.axes() & plane_axes_) != 0 || words.has_any(arc_letters_)) &&
           (words.code(Words::kOneShot) == kNone || words.is_tool_offset());
  }
  // Into an ArcWords or a CutterBlock.
  template <class Arc>
  void read_arc(const Words& words, Arc& arc) const;
  // Without `geometry` the arc has its centre, but neither sweep nor radii.
  [[nodiscard]] Alarm plan_arc(const Words& words, std::optional<spec::Arc<double>>& arc, ArcWords& arc_words,
                               bool geometry) const;
  [[nodiscard]] std::array<std::size_t, 2> plane_axes(spec::Plane plane) const;
  void select_plane(spec::Plane plane);
  [[nodiscard]] std::size_t normal_axis() const;

  // machine_moves.cpp: G53, G28, G30, G30.1, G29, G92, G54 to G59.
  [[nodiscard]] Alarm to_machine_position(const Words& words);
  [[nodiscard]] Alarm to_reference(const Words& words);
  [[nodiscard]] Alarm from_reference(const Words& words);
  [[nodiscard]] Alarm place_at_machine(std::size_t axis, const Count& machine);
  // The next rapid move, named `motion` to cutter compensation.
  [[nodiscard]] Alarm send_rapid(spec::Cause cause, bool with_machine, CutterMotion motion);
  [[nodiscard]] Alarm shift_coordinates(const Words& words);
  void rename_in_cutter();
  [[nodiscard]] Alarm shift_in_cutter(const Words& words, bool extra);
  void select_workpiece(Code code);
  void mark_displaced();
  // Axes whose angles, programmed positions and their zeros, are rounded.
  [[nodiscard]] Mask rounded_angles() const {
    return machine_angles_ ? static_cast<Mask>(rounded_ | shift_rounded_) : rounded_;
  }
  [[nodiscard]] Count machine_origin(std::size_t axis) const { return origin_[workpiece_][axis] + shift_[axis]; }

  // cutter.cpp: blocks that pass cutter compensation B or C.
  [[nodiscard]] bool cutter_active() const { return is_b_ ? cutter_b_.active() : cutter_c_.active(); }
  // G41 or G42 is in force after the codes of the block.
  [[nodiscard]] bool cutter_in_force(const Words& words) const {
    const CutterSide word = cutter_side(words.code(Words::kCompensation));
    return (word == CutterSide::unchanged ? cutter_side_ : word) != CutterSide::off;
  }
  // The sweep and the radii of an arc are made by cutter compensation, for the tool.
  [[nodiscard]] bool makes_tool_arc(const Words& words) const {
    if (words.is_tool_offset()) return false;
    return is_b_ ? cutter_b_.active() && words.code(Words::kCompensation) == kNone : cutter_c_.on();
  }
  // And with a number: 0 is none in C.
  [[nodiscard]] bool cutter_wanted(const Words& words) const {
    return cutter_in_force(words) && (is_b_ || commanded_number(words).value_or(cutter_number_).number != 0);
  }
  [[nodiscard]] bool cutter_on() const { return is_b_ ? cutter_b_.active() : cutter_c_.on(); }
  [[nodiscard]] CutterBlock& cutter_next() { return is_b_ ? cutter_b_.next() : cutter_c_.next(); }
  [[nodiscard]] std::optional<OffsetNumber> commanded_number(const Words& words) const;
  [[nodiscard]] Count cutter_value(const OffsetNumber& number) const {
    return number.from_h ? memory_.h(number.number) : memory_.d(number.number);
  }
  [[nodiscard]] static CutterSide cutter_side(Code code);
  // Whether this block takes an edited value of the cutter into force (EVR).
  [[nodiscard]] bool takes_edited_value() const {
    return cutter_edited_ && (evr_ || fault(Fault::edited_cutter_value_at_once));
  }
  // Where an axis stands, with the shift of G45 to G48 and without length offset; 0 for an axis that is not there.
  [[nodiscard]] Count actual(std::size_t axis) const {
    return axis == spec::Axes::kNone ? Count() : programmed_[axis] + tool_offset_[axis];
  }
  void begin_cutter(const Words& words);
  void start_cutter_leg(const Words& words, CutterSide word, bool d_word);
  // The plane has both its axes, and G45 to G48 have shifted none.
  [[nodiscard]] bool is_usual_cutter_plane() const {
    return is_open(ShortCut::cutter_block) && plane_axis_[0] != spec::Axes::kNone &&
           plane_axis_[1] != spec::Axes::kNone && tool_offset_.live() == 0;
  }
  [[nodiscard]] Alarm cutter_move(const Words& words);
  [[nodiscard]] Alarm read_cutter_arc(const Words& words, CutterBlock& block, std::array<double, 2>& center) const;
  [[nodiscard]] Alarm refuse_cutter_move(const Words& words, CutterBlock& block, const Alarm& placed);
  void retire_cutter();
  [[nodiscard]] Alarm corner_direction(const Words& words, CutterBlock& block) const;
  [[nodiscard]] Alarm cutter_motion(const Words& words, Code one_shot, bool extra,
                                    const std::optional<spec::Arc<double>>& arc, const ArcWords& arc_words);
  [[nodiscard]] Alarm send_cutter(CutterBlock& block);
  void end_run(const StageEnd& end);

  // tool_side.cpp: blocks that pass tool side compensation.
  // A code of the section is in force with a number, or a vector is not removed yet.
  [[nodiscard]] bool tool_side_on() const { return tool_side_wanted_ || tool_side_.active(); }
  [[nodiscard]] static CutterSide tool_side(Code code);
  [[nodiscard]] static bool is_tool_side(Code code) { return code == 412 || code == 416 || code == 422 || code == 426; }
  void begin_tool_side(const Words& words);
  void start_tool_side_leg(ToolSideBlock& block) const;
  [[nodiscard]] Alarm tool_side_move(const Words& words);
  // Behind a block that the stage has taken: whether the next one may be a usual line.
  void await_side_lines();
  // The usual line, without a detour: positions of few places, under G43.5 I J K, F and G00 or G01, and nothing of the
  // modal state that needs a look. False, and nothing is done: any other block.
  [[nodiscard]] bool side_line(const spec::Block& block);
  // A block while usual lines may come.
  void side_block(const spec::Block& block);
  // Positions in 10^-6.
  void fill_side_line(const spec::Block& block, DoublePair xy, double z);
  // Where usual lines have led to becomes the programmed position. Before any other block.
  void leave_side_lines();
  void place_side_lines(double x, double y, double z);
  [[nodiscard]] Alarm tool_side_motion(const Words& words, bool extra, const std::optional<spec::Arc<double>>& arc,
                                       const ArcWords& arc_words);

  // one_shot_moves.cpp: G45 to G48, G37.
  struct Shifts {  // what G45 to G48 add to the shift of the axes of the block
    Mask axes = 0;
    Positions by;
  };
  [[nodiscard]] Alarm plan_tool_offset(const Words& words, const ArcWords& arc_words,
                                       std::optional<spec::Arc<double>>& arc, Shifts& shifts) const;
  [[nodiscard]] Alarm measure(const Words& words);
  [[nodiscard]] Alarm send_measuring_move(std::size_t axis, const Count& to, double commanded, bool measuring);

  // tool_direction.cpp: rotary axes and I J K.
  void turn();
  // Under G43.5 without kinematics.
  void direct(const Words& words);
  // The direction of the I J K of a block.
  void read_direction(const Words& words, Direction& direction) const;
  // The same of usual words, in place; false, and nothing done, for any other.
  [[nodiscard]] bool read_usual_direction(const Words& words, Direction& direction) const;
  // I J K are not all zero, or none is there.
  [[nodiscard]] static bool names_direction(const Words& words) {
    if (!words.has_any(Words::set_of("IJK"))) return true;
    const auto some = [&](char letter) { return words.has(letter) && !words[letter].is_zero(); };
    return some('I') || some('J') || some('K');
  }
  void take_position_along_tool();
  void end_tool_direction(bool again);
  [[nodiscard]] Direction& new_direction() {
    direction_ = static_cast<std::uint8_t>((direction_ + 1U) % directions_.size());
    return directions_[direction_];
  }
  // Under G43.4 or G43.5.
  [[nodiscard]] bool along_tool() const { return length_.mode() == ToolLengthOffset::Mode::along_tool; }
  // L: the offset of the H number and the tool holder offset.
  [[nodiscard]] Count tool_length() const { return length_.length() + machine_.holder_offset(); }

  [[nodiscard]] std::uint32_t tag_direction();
  void send_to(EventSink& sink);

  // tip_control.cpp: blocks under G43.4 or G43.5 on a machine with kinematics.
  // place_words() in the mode and in the block that starts it.
  [[nodiscard]] Alarm place_tip_words(const Words& words, Mask axes);
  // The words of the block that starts it.
  void begin_tip_control(const Words& words);
  [[nodiscard]] Alarm start_tip_control(const Words& words);
  [[nodiscard]] Alarm plan_posture(const Words& words, Mask axes, const std::array<Count, 3>& from,
                                   const RotaryPositions& before);
  void end_tip_control(bool again);
  [[nodiscard]] bool stands_as_before() const;
  [[nodiscard]] Alarm plan_direction(const Words& words, const std::array<Count, 3>& from, TipBlock& block);
  [[nodiscard]] bool asks_direction(const Words& words, const std::array<Count, 3>& from);
  // Of a block that asks for a direction: the one commanded or kept, under Q leaned where it can be.
  [[nodiscard]] const Direction& leaned(const Words& words, const std::array<Count, 3>& from);
  [[nodiscard]] bool lean(const Words& words, const std::array<Count, 3>& from, Direction& to_direction) const;
  [[nodiscard]] Alarm check_workpiece_arc(const RotaryPositions& before) const;
  void keep_tip_on_table(Mask axes, const Pose& start, const Pose& end, const std::array<Count, 3>& from);
  void take_posture(const Pose& pose);
  void set_programmed(std::size_t axis, const DoubleDouble& position);
  [[nodiscard]] std::array<Count, 3> programmed_xyz() const;
  [[nodiscard]] std::array<Count, 3> shift_xyz() const;  // of G45 to G48
  [[nodiscard]] Vector3<DoubleDouble> fine_origin() const;

  // Setup.
  spec::Axes axes_;
  std::size_t count_;
  Mask linear_ = 0;
  Mask rotary_ = 0;
  Mask all_ = 0;
  Mask turning_ = 0;  // axes that turn the tool
  std::array<std::size_t, 3> xyz_;
  AxisLetters letters_;
  bool inch_setup_;
  bool counts_increments_;  // 3401#0 = 0
  int increment_places_;
  bool machine_angles_;  // rotary_angles: machine coordinates turn tool and table
  std::array<Positions, 6> origin_;
  std::array<Positions, 5> reference_;  // 0: floating, 1 to 4

  // Stages.
  Kinematics kinematics_;
  Machine machine_;
  ToolPostureControl posture_;
  OffsetMemory memory_;
  ToolLengthOffset length_;
  ToolOffset tool_offset_;
  ToolLengthMeasurement measurement_;
  EventSink& sink_;
  LeadingEdgeOffset leading_edge_;
  bool is_b_;  // cutter compensation B, not C
  CutterCompensationB cutter_b_;
  CutterCompensationC cutter_c_;
  ToolSideCompensation tool_side_;
  ToolCenterPointControl tip_;

  // Modal state.
  Code motion_ = 0;
  spec::Plane plane_ = spec::Plane::xy;
  std::array<std::size_t, 2> plane_axis_{};  // of plane_
  Mask plane_axes_ = 0;                      // those of them that are there
  std::array<char, 2> plane_letter_{};       // the letters I J K of plane_
  bool incremental_ = false;
  bool inch_program_;
  bool plain_words_ = true;  // a word counts as written: no conversion, no least increments
  std::size_t workpiece_ = 0;
  std::uint32_t d_ = 0;
  double radius_ = 0;  // of D, when it was applied
  bool ofh_;           // 5001#2: an H number counts for the cutter too
  bool evr_;           // 5001#4: an edited cutter value counts from the next block on
  CutterSide cutter_side_ = CutterSide::off;
  CutterSide tool_side_word_ = CutterSide::off;
  int tool_side_sign_ = 1;         // +1 left: by code and sign of the value
  bool tool_side_wanted_ = false;  // a code is in force with a number
  // Usual lines under tool side compensation, while they may come.
  struct SideLines {
    std::uint32_t letters = 0;  // those of such a block; 0: none may come
    bool plain = false;         // the axes are sent to the programmed position
    // Of their words in 10^-6 the last ones, by letter (A: 1), and where X Y Z stand.
    std::array<std::int64_t, 32> word{};
    Vector3<double> at;
  };
  SideLines side_lines_;
  OffsetNumber cutter_number_;
  Count cutter_offset_;  // of that number, when it was applied
  bool cutter_edited_ = false;
  bool in_cutter_ = false;  // this block passes cutter compensation
  std::uint32_t arc_letters_ = kArcLetters;
  bool by_vector_ = false;  // G43.5
  // Under G43.4 or G43.5 on a machine with kinematics, and under G43.5 without where Q leans the tool.
  bool plans_tool_ = false;
  bool posture_control_ = false;  // P1
  bool starts_tip_ = false;       // this block starts it
  bool samples_block_ = true;     // the own move of this block is run in the mode
  bool has_table_tip_ = false;    // WKP = 1: the tip has kept its place on the table since table_tip_
  Count lean_angle_;              // Q
  Direction commanded_;           // the direction kept, without the lean
  // Where a head stood, and its rotary positions, as another G43.4 or G43.5 ended the mode of I J K.
  std::optional<Pose> standing_;
  std::array<Count, 2> standing_at_;
  Direction leaned_;  // and with it
  Positions frozen_;  // of the rotary axes where the mode began
  Vector3<DoubleDouble> table_tip_;
  std::optional<double> feed_;
  double along_length_ = 0;  // tool_length(), under G43.4 or G43.5

  // Positions.
  Positions programmed_;
  Positions shift_;     // G92
  Mask displaced_ = 0;  // axes with a workpiece origin in force or a shift
  Positions intermediate_;
  Mask has_intermediate_ = 0;
  // Axes whose programmed position (shift, intermediate point) was rounded to 1 / (127 * 10^18): a G49 ended G43.5 at
  // an irrational position.
  Mask rounded_ = 0;
  Mask shift_rounded_ = 0;
  Mask intermediate_rounded_ = 0;
  std::array<double, spec::kMaxAxes> programmed_value_{};  // nearest doubles
  std::array<double, spec::kMaxAxes> axes_value_{};        // with the length offset
  Mask stale_ = 0;                                         // axes whose axes_value_ is to be made again

  // Directions live in a ring because held moves refer to theirs: at most three blocks have one at a time, and a block
  // makes three at most.
  std::array<Direction, 8> directions_;
  std::uint8_t direction_ = 0;
  std::uint8_t direction_before_ = 0;  // where the block started

  // The block.
  std::uint64_t line_ = 0;
  std::optional<std::uint64_t> n_;
  bool stopped_ = false;
  Event notice_;  // alarms and settings
};

// Calls f(axis) for each bit of the mask, lowest first; stops at an alarm and returns it.
template <class Function>
Alarm for_each_axis(std::uint16_t mask, Function f) {
  for (unsigned rest = mask; rest != 0; rest &= rest - 1)
    if (const Alarm a = f(static_cast<std::size_t>(__builtin_ctz(rest)))) return a;
  return alarm::kNone;
}

// G17 G18 G19.
constexpr spec::Plane plane_of(Code code) {
  return code == 170 ? spec::Plane::xy : (code == 180 ? spec::Plane::zx : spec::Plane::yz);
}

// Which of X Y Z (0, 1, 2) is axis i (0, 1) of a plane: XY, ZX, YZ.
constexpr std::size_t in_plane(spec::Plane plane, std::size_t i) {
  const std::size_t first = plane == spec::Plane::xy ? 0 : (plane == spec::Plane::zx ? 2 : 1);
  return (first + i) % 3;
}

// The letter I J K of that axis.
constexpr char direction_letter(spec::Plane plane, std::size_t i) {
  return static_cast<char>('I' + static_cast<int>(in_plane(plane, i)));
}

// The mask of one axis.
constexpr std::uint16_t bit(std::size_t axis) { return static_cast<std::uint16_t>(1U << axis); }

}  // namespace toolcomp::fast
