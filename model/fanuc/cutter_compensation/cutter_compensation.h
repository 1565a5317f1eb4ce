// SPDX-License-Identifier: Apache-2.0
// What cutter compensation B and C have in common as passes.
#pragma once

#include <cstdint>

#include "model/fanuc/cutter_compensation/cutter_block.h"
#include "model/fanuc/program/pass.h"

namespace toolcomp::model {

// Hands on every move with its compensation vector (Move::offset), the moves that belong to a block but are inserted
// before its own move (cause start-up, corner or cancel), arcs as the tool runs them. Clauses: fanuc.cutter.*; on():
// fanuc.cutter.on.
class CutterCompensation : public Pass {
 public:
  // `by_number`: number 0 in force is as G40.
  CutterCompensation(const Place& place, bool by_number);

  [[nodiscard]] Extent extent() const final { return Extent::plane; }
  [[nodiscard]] bool on_after(const Command& command) const final;
  // From the first G41, G42 or G39 of a program on.
  void read(const BlockWords& now, StepWords& words) final;
  void see(const BlockWay& way, StepWords& words) const final;
  [[nodiscard]] bool has(const StepWords& words) const final { return words.cutter != nullptr; }

 protected:
  // With this side and this number in force compensation is on, unless a vector holds it on anyway.
  [[nodiscard]] bool wanted(CutterSide side, std::uint32_t number) const {
    return side != CutterSide::none && (number != 0 || !by_number_);
  }
  [[nodiscard]] bool wanted(const CutterBlock& words) const { return wanted(words.side, words.number); }
  // The alarms that the words of a block raise, behind those that B and C share, before its movement and the value of
  // its number are known.
  virtual void check(const CutterBlock& words, const Command& command) const = 0;

 private:
  // Throws Alarm PS0028, PS0037, FORBIDDEN_IN_CUTTER_COMPENSATION or PS0042.
  void check_common(const CutterBlock& words, const Command& command) const;

  CornerWords words_;
  bool by_number_;
};

}  // namespace toolcomp::model
