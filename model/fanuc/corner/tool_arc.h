// SPDX-License-Identifier: Apache-2.0
// The arc that the tool runs about the programmed centre, from the head of one vector to the head of another.
#pragma once

#include <cstdint>
#include <optional>

#include "model/basis/recorder.h"
#include "model/fanuc/corner/offset_path.h"
#include "model/fanuc/corner/vector_group.h"
#include "spec/language/event.h"

namespace toolcomp::model {

// Sine and cosine of a sweep up to one positive factor, and its side of the half circle: the sign of the sine.
struct Sweep {
  Real sine;
  Real cosine;
  Sign side = Sign::zero;

  [[nodiscard]] bool up_to_half() const {
    return side == Sign::positive || (side == Sign::zero && cosine.sign() == Sign::negative);
  }
};

// What is known of the heads of an arc without a proof.
enum class HeadPair : std::uint8_t {
  any,
  same,     // a whole circle from one head back to it
  opposite  // a half circle, the heads opposite with respect to the centre
};

// One arc block between two heads. Sweeps are decided once, when they are asked for.
class ToolArcRun {
 public:
  ToolArcRun(Recorder& recorder, OffsetPath path, const CornerVector& from, const CornerVector& to,
             HeadPair heads = HeadPair::any);

  // A head lies in the centre.
  [[nodiscard]] bool in_center() const { return start_sign_ == Sign::zero || end_sign_ == Sign::zero; }
  // Square to the path at both ends: the tool turns as programmed.
  [[nodiscard]] bool turns_as_programmed() const { return as_programmed_; }
  // The tool's own sweep; not where a head lies in the centre. Clause: fanuc.cutter-c.arc-sweep.
  const Sweep& sweep();
  // The programmed sweep.
  [[nodiscard]] Sweep programmed() const;
  // The product of the four radii, for scales.
  [[nodiscard]] Real radii() const;
  // Sweep and radii of the tool's own arc, as an event reports them. Clause: fanuc.cutter-c.arc-radii.
  void report(spec::Arc<Real>& arc);

 private:
  Recorder& recorder_;
  OffsetPath path_;
  PlanePoint start_;  // the heads, from the centre
  PlanePoint end_;
  bool start_on_;  // on the offset circle, whose radius is known
  bool end_on_;
  Real start2_;  // squares of the heads' distances from the centre
  Real end2_;
  Sign start_sign_;  // of R', or of the distance
  Sign end_sign_;
  bool as_programmed_;
  HeadPair heads_;
  std::optional<Sweep> sweep_;
};

}  // namespace toolcomp::model
