// SPDX-License-Identifier: Apache-2.0
// A block between the vectors at its start and at its end: the arc that the tool runs about the programmed centre, and
// the interference check.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "model/fanuc/corner/corner.h"
#include "spec/language/event.h"
#include "spec/language/setup.h"

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

// One arc block between two heads. Its sweep is decided once, when it is asked for.
class ToolArcRun {
 public:
  ToolArcRun(Recorder& recorder, OffsetPath path, const CornerVector& from, const CornerVector& to,
             HeadPair heads = HeadPair::any);

  // Whether the tool's own sweep and the programmed one differ by more than 180°; not where a head lies in the centre.
  // Clauses: fanuc.cutter-c.arc-sweep, interference-sweep.
  bool sweeps_far_apart();
  // Sweep and radii of the tool's own arc, as an event reports them. Clauses: fanuc.cutter-c.arc-radii, arc-sweep.
  void report(spec::Arc<Real>& arc);

 private:
  struct Head {
    Head(const PathEnd& end, const PlanePoint& vector, Seat seat);
    [[nodiscard]] Real distance(const PathEnd& end) const;

    bool on;  // on the offset circle, whose radius is known
    PlanePoint from_center;
    Real distance2;
    Sign sign;  // of R', or of the distance
  };

  [[nodiscard]] bool in_center() const { return start_.sign == Sign::zero || end_.sign == Sign::zero; }
  [[nodiscard]] Sweep programmed() const;
  const Sweep& sweep();

  Recorder& recorder_;
  OffsetPath path_;
  Head start_;
  Head end_;
  bool as_programmed_;  // square to the path at both ends: the tool turns as programmed
  HeadPair heads_;
  std::optional<Sweep> sweep_;
};

// What becomes of a block.
enum class Passage : std::uint8_t {
  free,       // the block runs as it is
  shortened,  // vectors were dropped: an arc becomes a line
  blocked     // the last pair interferes too: PS0041
};

// How far the tool goes along a block, times the length of the block as it is seen, and against what that is measured.
struct WayAlong {
  Real product;
  Real scale;
  Real length2;
};

// How a section sees its block.
struct CheckedPath {
  PathEnd start;  // of an arc
  PathEnd end;
  // As a line, between two vectors.
  std::function<WayAlong(const Vector& from, const Vector& to)> along;
};
// In a plane of G17, G18 or G19. Refers to the path.
CheckedPath between_vectors(spec::Plane plane, const OffsetPath& path);

// Drops vectors, the last ones at the start and the first ones at the end of a block, until it does not interfere; at
// each end one vector stays. `setup`: where parameters concern the section. `run`: of an arc, between the inner
// vectors. `crossing`: of a blocked one, by how much its paths cross, setup units; 0 where the sweep of an arc
// interferes. Clauses: fanuc.cutter-c.interference-*.
struct Checked {
  Passage passage = Passage::free;
  Real crossing;
};
Checked check_interference(Recorder& recorder, const spec::Setup* setup, const CheckedPath& path, SpaceGroup& at_start,
                           SpaceGroup& at_end, ToolArcRun* run);

}  // namespace toolcomp::model
