// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/program/offset_in_force.h"

namespace toolcomp::model {

OffsetInForce::OffsetInForce(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder)
    : memory_(memory), recorder_(recorder), ofh_(setup.bit(5001, 2)), evr_(setup.bit(5001, 4)) {}

std::optional<OffsetNumber> OffsetInForce::given(const Codes& codes) const {
  if (codes.d) return OffsetNumber{*codes.d, false};
  if (ofh_ && codes.h) return OffsetNumber{*codes.h, true};
  return std::nullopt;
}

OffsetNumber OffsetInForce::number_after(const Codes& codes) const { return given(codes).value_or(number_); }

bool OffsetInForce::take(const Codes& codes) {
  const auto given_here = given(codes);
  if (given_here) number_ = *given_here;
  return given_here.has_value();
}

void OffsetInForce::decide_address(const Codes& codes) const {
  // fanuc.cutter.number: The offset number is that of the last D. If OFH = 1, an H in any block gives the number as
  // well, and the value is then that of the H number. If a block has both a D and an H, the D counts.
  if (codes.h && !codes.d) recorder_.decide(Clause::fanuc_cutter_number, ofh_);
}

const Rational& OffsetInForce::value(bool taken_anew) {
  // fanuc.cutter.value-edited: The value in force is the one that the memory held in the last block in which the number
  // was given (even if it was the same number again), or in which G41 or G42 came into force after G40.
  if (recorder_.decide(Clause::fanuc_cutter_value_edited, taken_anew || evr_))
    value_ = number_.of_h ? memory_.h(number_.number) : memory_.d(number_.number);
  return value_;
}

CutterOffset offset_of(Recorder& recorder, CutterSide side, const Rational& value) {
  const int of_code = side == CutterSide::left ? 1 : -1;
  const Rational distance = abs(value);
  // fanuc.cutter.side: G41 with a positive value and G42 with a negative value offset to the left of the movement, and
  // the other two cases to the right. A negative value thus exchanges G41 and G42.
  const Sign decided = recorder.decide(Clause::fanuc_cutter_side, Rational(of_code * value), distance);
  return {decided == Sign::zero ? of_code : static_cast<int>(decided), distance, value};
}

}  // namespace toolcomp::model
