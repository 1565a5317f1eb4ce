// SPDX-License-Identifier: Apache-2.0
// What cutter compensation B and C have in common: what a block says to them, what it does in the plane, and the pass.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "model/fanuc/corner/corner_block.h"

namespace toolcomp::model {

// What a block does in the plane of cutter compensation.
enum class PlaneMotion : std::uint8_t {
  none,         // no axis word of the plane; G39
  zero_travel,  // an axis word of the plane, and no travel in it
  line,
  arc,        // G02, G03; a full circle too
  reference,  // G28, G30, G30.1, whatever axes they name: two moves
  machine     // G53, and G29 with its two moves, whatever axes they name
};
constexpr bool is_machine_move(PlaneMotion motion) { return motion >= PlaneMotion::reference; }

// What a block says to cutter compensation B and C. Plane coordinates (first and second axis of the block's plane,
// setup units), tool offset G45–G48 included, before compensation.
struct CutterBlock : CornerBlock {
  // The words.
  OneShot one_shot = OneShot::none;     // G39, G92 …
  std::optional<PlanePoint> direction;  // I J (K I, J K) that are no arc's centre, an absent letter 0; of G39 also X Y
  bool direction_letters = false;       // it was given by I J K
  spec::Plane plane = spec::Plane::xy;  // in force at the end of the block
  std::array<bool, 2> word{};           // an axis word of the first, of the second axis of the plane
  bool axis_word = false;               // of whatever axis

  // The movement.
  PlaneMotion motion = PlaneMotion::none;
  PlanePoint start;
  PlanePoint first_end;        // of the first of the step's moves
  PlanePoint end;              // of the block
  std::optional<ArcEnds> arc;  // with PlaneMotion::arc

  // Its path is that of G00, G01, G02 or G03 seen in the plane.
  [[nodiscard]] bool moves() const { return motion == PlaneMotion::line || motion == PlaneMotion::arc; }
  [[nodiscard]] bool has_plane_word() const { return word[0] || word[1]; }
};

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
  // Makes the move of G39 this arc about the programmed point. It has its direction, sweep and radii.
  void make_corner_arc(Leg& leg, const CutterBlock& block, spec::Arc<Real> arc) const;

 private:
  // Throws Alarm PS0028, PS0037, FORBIDDEN_IN_CUTTER_COMPENSATION or PS0042.
  void check_common(const CutterBlock& words, const Command& command) const;

  CornerWords words_;
  bool by_number_;
};

}  // namespace toolcomp::model
