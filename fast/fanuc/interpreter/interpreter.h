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
#include "fast/fanuc/interpreter/axes.h"
#include "fast/fanuc/interpreter/axis_positions.h"
#include "fast/fanuc/interpreter/cutter_value.h"
#include "fast/fanuc/interpreter/modal_state.h"
#include "fast/fanuc/interpreter/tool_attitude.h"
#include "fast/fanuc/interpreter/word_units.h"
#include "fast/fanuc/leading_edge_offset/leading_edge_offset.h"
#include "fast/fanuc/program/arc.h"
#include "fast/fanuc/program/cutter_block.h"
#include "fast/fanuc/program/words.h"
#include "fast/fanuc/tool_length_measurement/tool_length_measurement.h"
#include "fast/fanuc/tool_length_offset/offset_memory.h"
#include "fast/fanuc/tool_side_compensation/tool_side_compensation.h"
#include "fast/kinematics/kinematics.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

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
  // What a block does to leading edge offset.
  enum class Compensation : std::uint8_t { off, starts, stays, cancels };
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

  // The arc of a block, if it is one.
  struct BlockArc {
    std::optional<spec::Arc<double>> event;
    ArcWords words;
  };

  // interpreter.cpp: one block, step by step.
  void any_block(const spec::Block& block);
  [[nodiscard]] Alarm run(const Words& words);
  // The short cut of run(), usual_block.h. False, and nothing is done: any other block.
  [[nodiscard]] bool usual_block(const Words& words, Alarm& alarm);
  [[nodiscard]] Alarm apply(const Words& words, const Plan& plan);
  void take_codes(const Words& words, const Plan& plan);
  [[nodiscard]] Alarm take_length(const Words& words, const Plan& plan, bool& extra);
  void take_cutter(const Words& words, const Plan& plan);
  [[nodiscard]] Alarm move(const Words& words, const Plan& plan, bool extra, const BlockArc& arc);
  void set_feed(const Words& words);
  void send_to(EventSink& sink);
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
  [[nodiscard]] Alarm motion(const Words& words, Compensation compensation, bool own, bool extra,
                             const std::optional<spec::Arc<double>>& arc);
  void set_any_travel(Move& move, const std::array<Count, 3>& from, Mask rounded) const;
  [[nodiscard]] Alarm edge_motion(Compensation compensation);
  // The positions of these axes and what follows from them: the tool direction, and what the axes are sent to.
  [[nodiscard]] Alarm place_words(const Words& words, Mask axes);
  // Of an arc everything but event.arc.
  void fill(Event& event, spec::MoveType type, spec::Cause cause);
  // The same in place, for the usual block.
  void fill_here(Event& event, spec::MoveType type, spec::Cause cause);
  [[nodiscard]] Count target(const Words& words, std::size_t axis) const {
    return positions_.target(words, axis, units_, modal_.incremental());
  }

  // arc_words.cpp
  // Without `geometry` the arc has its centre, but neither sweep nor radii.
  [[nodiscard]] Alarm plan_arc(const Words& words, std::optional<spec::Arc<double>>& arc, ArcWords& arc_words,
                               bool geometry) const;

  // machine_moves.cpp: G53, G28, G30, G30.1, G29, G92, G54 to G59.
  [[nodiscard]] Alarm to_machine_position(const Words& words);
  [[nodiscard]] Alarm to_reference(const Words& words);
  [[nodiscard]] Alarm from_reference(const Words& words);
  // The next rapid move, named `motion` to cutter compensation.
  [[nodiscard]] Alarm send_rapid(spec::Cause cause, bool with_machine, CutterMotion motion);
  [[nodiscard]] Alarm shift_coordinates(const Words& words);
  void rename_in_cutter();
  [[nodiscard]] Alarm shift_in_cutter(const Words& words, bool extra);
  void select_workpiece(Code code);
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
    return cutter_in_force(words) && (is_b_ || cutter_value_.number_after(words).number != 0);
  }
  [[nodiscard]] bool cutter_on() const { return is_b_ ? cutter_b_.active() : cutter_c_.on(); }
  [[nodiscard]] CutterBlock& cutter_next() { return is_b_ ? cutter_b_.next() : cutter_c_.next(); }
  [[nodiscard]] static CutterSide cutter_side(Code code);
  void begin_cutter(const Words& words);
  void start_cutter_leg(const Words& words, CutterSide word, bool d_word);
  // The plane has both its axes, and G45 to G48 have shifted none.
  [[nodiscard]] bool is_usual_cutter_plane() const {
    return is_open(ShortCut::cutter_block) && modal_.plane_axis()[0] != spec::Axes::kNone &&
           modal_.plane_axis()[1] != spec::Axes::kNone && positions_.tool_offset().live() == 0;
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
  [[nodiscard]] bool read_side_line(const spec::Block& block, std::uint32_t& letters);
  void turn_side_line(std::uint32_t letters, const std::array<std::int64_t, 3>& ijk);
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

  Kinematics kinematics_;

  // The parts.
  const ControlAxes axes_;
  WordUnits units_;
  ModalState modal_;
  AxisPositions positions_;
  ToolAttitude attitude_;

  // Stages.
  OffsetMemory memory_;
  ToolLengthMeasurement measurement_;
  EventSink& sink_;
  LeadingEdgeOffset leading_edge_;
  bool is_b_;  // cutter compensation B, not C
  CutterCompensationB cutter_b_;
  CutterCompensationC cutter_c_;
  ToolSideCompensation tool_side_;

  // Numbers of compensation.
  std::uint32_t d_ = 0;
  double radius_ = 0;  // of D, when it was applied
  CutterValue cutter_value_;
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
  bool in_cutter_ = false;  // this block passes cutter compensation
  // The block.
  std::uint64_t line_ = 0;
  std::optional<std::uint64_t> n_;
  bool stopped_ = false;
  Event notice_;  // alarms and settings
};

}  // namespace toolcomp::fast
