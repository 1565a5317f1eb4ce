// Leading edge offset: G41.3 and G40. One stage with a look-ahead of one moving and two other blocks.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "model/basis/recorder.h"
#include "model/fanuc/leading_edge_offset/edge_vector.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/program/offset_memory.h"
#include "model/fanuc/program/step.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Takes steps in order and gives every move its compensation vector. Clauses: fanuc.leading-edge.*.
class LeadingEdgeOffset {
 public:
  // Receives the steps in order, with the vector of every move (Move::offset).
  using Output = std::function<void(const Step& step)>;

  // Throws spec::InputError naming parameter 19631.
  LeadingEdgeOffset(const spec::Setup& setup, Recorder& recorder, Output output);

  // What the next step is to be marked with.
  struct Marks {
    EdgeCommand edge = EdgeCommand::none;
    Rational radius;
  };
  // Reads G41.3, G40 and D. `moves`: the block has an axis word, or I J K as a tool direction. Throws Alarm PS5406,
  // PS5408, PS5407, FORBIDDEN_IN_3D_COMPENSATION or PS0029.
  Marks read(const Command& command, bool moves, const OffsetMemory& memory);

  // The mode is on before the next command that is read, or after this one.
  [[nodiscard]] bool active() const { return active_; }
  [[nodiscard]] bool active_after(const Command& command) const;
  // The mode is on for this command: before it, or from it on.
  [[nodiscard]] bool concerns(const Command& command) const;

  // The step after read() of its block. Throws Alarm PS5407 or PS5408 for a G41.3 block before it.
  void take(const Step& step);
  // No block follows: the end of the program, or a block that ends the run by an alarm. Throws Alarm PS5407.
  void finish();

 private:
  [[nodiscard]] std::uint32_t number(const Command& command) const { return command.codes.d.value_or(number_); }
  void forbid(const Command& command, bool moves);
  void take_cancel(const Step& step);
  void take_moving(const Step& step);
  void take_other(const Step& step);
  // The blocks held go out: the moving one (or the start) with the vector now in force, those behind it too.
  void release(const Step* now);
  // The step as it is, with the vector in force; or with one move instead, inserted where it ends.
  void emit(const Step& step);
  void emit(const Step& step, spec::Cause inserted);
  // Decisions from here on belong to the block held.
  void decide_held() { recorder_.at(held_->line); }
  [[noreturn]] void start_alarm(Clause clause, spec::Name alarm, const char* message);

  Recorder& recorder_;
  Output output_;
  EdgeRules rules_;
  std::uint32_t number_ = 0;  // D in force
  bool active_ = false;
  bool starting_ = false;     // the block held is the G41.3 block
  EdgeVector vector_;         // in force at the end of the last block that went out
  std::optional<Step> held_;  // the last moving block, or the G41.3 block
  std::vector<Step> behind_;  // blocks without movement after it
};

}  // namespace toolcomp::model
