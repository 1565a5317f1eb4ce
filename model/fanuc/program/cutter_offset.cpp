// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/program/cutter_offset.h"

namespace toolcomp::model {

CutterOffset offset_of(Recorder& recorder, CutterSide side, const Rational& value) {
  const int of_code = side == CutterSide::left ? 1 : -1;
  const Rational distance = abs(value);
  // fanuc.cutter.side: G41 with a positive value and G42 with a negative value offset to the left of the movement, and
  // the other two cases to the right. A negative value thus exchanges G41 and G42.
  const Sign decided = recorder.decide(Clause::fanuc_cutter_side, Rational(of_code * value), distance);
  return {decided == Sign::zero ? of_code : static_cast<int>(decided), distance, value};
}

}  // namespace toolcomp::model
