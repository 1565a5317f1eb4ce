// SPDX-License-Identifier: Apache-2.0
// Leading edge offset: G41.3 and G40. One stage with a look-ahead of one moving and two other blocks.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "model/fanuc/leading_edge_offset/rules.h"
#include "model/fanuc/program/stage.h"

namespace toolcomp::model {

// What a block says to the leading edge offset, where that is on before it or from it on.
struct EdgeBlock final : StageWords {
  enum class Code : std::uint8_t { none, start, cancel };
  Code code = Code::none;
  Rational radius;       // offset of the D number in force at the end of the block, but for a cancel block
  bool travels = false;  // it has a linear movement, X Y Z
};

// Gives every move its compensation vector (Move::offset). Clauses: fanuc.leading-edge.*.
class LeadingEdgeOffset : public StageOf<EdgeBlock> {
 public:
  // Throws spec::InputError naming parameter 19631.
  explicit LeadingEdgeOffset(const Place& place);

  [[nodiscard]] Extent extent() const override { return Extent::space; }
  [[nodiscard]] int look_ahead() const override { return 2; }
  [[nodiscard]] bool on() const override { return active_; }
  [[nodiscard]] bool on_after(const Command& command) const override;

  // Reads G41.3, G40 and D. Throws Alarm PS5406, PS5408, PS5407, FORBIDDEN_IN_3D_COMPENSATION or PS0029.
  std::shared_ptr<StageWords> read(const StageCommand& now) override;
  void complete(StageWords& words, const Step& step) const override;
  // Throws Alarm PS5407 or PS5408 for a G41.3 block before it.
  void take(const Step& step) override;
  // Throws Alarm PS5407.
  void finish() override;

 private:
  [[nodiscard]] std::uint32_t number(const Command& command) const { return command.codes.d.value_or(number_); }
  void forbid(const StageCommand& now) const;
  void take_cancel(const Step& step);
  void take_moving(const Step& step);
  void take_other(const Step& step);
  // The blocks held go out: the moving one (or the start) with the vector now in force, those behind it too.
  void release(const Step* now);
  // The step as it is, with the vector in force; or with one move instead, inserted where it ends.
  void emit(const Step& step);
  void emit(const Step& step, spec::Cause inserted);
  // Decisions from here on belong to the block held.
  void decide_held() { recorder().at(held_->line); }
  [[noreturn]] void start_alarm(Clause clause, AlarmCause cause);

  const OffsetMemory& memory_;
  EdgeRules rules_;
  std::uint32_t number_ = 0;  // D in force
  bool active_ = false;
  bool starting_ = false;     // the block held is the G41.3 block
  EdgeVector vector_;         // in force at the end of the last block that went out
  std::optional<Step> held_;  // the last moving block, or the G41.3 block
  std::vector<Step> behind_;  // blocks without movement after it
};

}  // namespace toolcomp::model
