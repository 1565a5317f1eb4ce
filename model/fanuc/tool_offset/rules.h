// SPDX-License-Identifier: Apache-2.0
// The rules of the tool offset: by how much G45 to G48 lengthen a travel, which way, and what becomes of an arc.
#pragma once

#include "model/basis/recorder.h"
#include "model/fanuc/program/interpreter.h"

namespace toolcomp::model {

// The arc with its radius changed.
struct LengthenedArc {
  char axis = 'X';        // on which its centre moves
  Rational by;            // by this, setup units
  bool is_point = false;  // the radius is 0
};

// Setup units. Clauses: fanuc.tool-offset.*.
class ToolOffsetRules {
 public:
  explicit ToolOffsetRules(Recorder& recorder) : recorder_(recorder) {}

  // By how much one of G45 to G48 lengthens a travel, with the offset value in force.
  [[nodiscard]] Rational lengthening(OneShot code, const Rational& value) const;
  // What is added to the position of an axis that the block names, where its travel is lengthened.
  [[nodiscard]] Rational shift(const Command& command, char axis, const Real& travel, const Rational& by) const;
  // `travel`: of the block as programmed, X Y Z. Throws Alarm G45_ARC or PS0038.
  [[nodiscard]] LengthenedArc arc(const Command& command, const Numbers& numbers, const Vector& travel,
                                  const Rational& by) const;

 private:
  // +1 or −1.
  [[nodiscard]] int sense_of_zero(const spec::Decimal& word) const;

  Recorder& recorder_;
};

}  // namespace toolcomp::model
