// The compensation vectors at one corner, in the order the tool takes their heads.
#pragma once

#include <optional>
#include <vector>

#include "model/fanuc/corner/corner.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Where the head of a vector lies as a block sees it.
enum class Seat : std::uint8_t {
  off,    // anywhere
  on,     // on the block's offset path
  square  // at right angles to the programmed path, at the distance of the offset
};

struct CornerVector {
  PlanePoint vector;  // from the corner, setup units
  Seat former = Seat::off;
  Seat latter = Seat::off;
};

// At least one vector, at most four.
using VectorGroup = std::vector<CornerVector>;

// The same in X Y Z, whatever the plane of the corner.
struct SpaceVector {
  Vector vector;
  Seat former = Seat::off;
  Seat latter = Seat::off;
  bool after_stop = false;  // the tool gets there behind the single-block stop point
};
using SpaceGroup = std::vector<SpaceVector>;
// The stop point is the first head.
SpaceGroup in_space(spec::Plane plane, const VectorGroup& group);

// The way round an outer corner: along the tangents, with the vectors at right angles to the former and to the latter
// block where they are asked for.
VectorGroup way_round(CornerClass kind, const PathEnd& former, const PathEnd& latter, bool with_p1, bool with_p2);

// Whether an arc from `start` to `end`, seen from its centre, sweeps less than a half circle. Clause:
// fanuc.cutter-c.small-corner-before-half-circle.
bool is_under_half_circle(Recorder& recorder, const PlanePoint& start, const PlanePoint& end, int turn,
                          const Real& radii);

// The rules that make the vectors of one corner out of the block that ends there and the one that starts there. The
// offset at the end of `former` is not 0 (but for square_to).
class CornerRules {
 public:
  // Parameters 5003#0 and 5010.
  CornerRules(const spec::Setup& setup, Recorder& recorder);

  // `former` is the start-up block. Clauses: fanuc.cutter-c.start-up-*.
  [[nodiscard]] VectorGroup start_up(const PathEnd& former, const PathEnd& latter) const;
  // Offset mode; nothing where an inner corner has no intersection (PS0033). Clauses: fanuc.cutter-c.tangent-join,
  // outer-obtuse, outer-acute, inner-lines.
  [[nodiscard]] std::optional<VectorGroup> offset_mode(const PathEnd& former, const PathEnd& latter) const;
  // `latter` is the cancel block. Clauses: fanuc.cutter-c.cancel-*.
  [[nodiscard]] VectorGroup cancel(const PathEnd& former, const PathEnd& latter) const;
  // Cancel by G40 with a direction I J that is not zero. Clause: fanuc.cutter-c.cancel-direction-parallel.
  [[nodiscard]] VectorGroup cancel_along(const PathEnd& former, const PlanePoint& direction) const;
  // The side changes; `latter.offset` is the opposite of `former.offset`. Clauses: fanuc.cutter-c.direction-change-*.
  [[nodiscard]] VectorGroup direction_change(const PathEnd& former, const PathEnd& latter) const;
  // P1 alone; of an offset of 0 the vector 0 (fanuc.cutter-c.value-zero).
  [[nodiscard]] VectorGroup square_to(const PathEnd& former) const;

  // No. 5010: a vector that differs from the last one kept by no more than the limit in both coordinates is dropped.
  // `latter`: the block that starts at the corner. Clauses: fanuc.cutter-c.small-corner-movement,
  // small-corner-before-half-circle.
  void drop_small_movements(VectorGroup& group, const OffsetPath& latter) const;

 private:
  // The class of a corner of start-up or cancel of type B, or nothing where it has one perpendicular vector as in
  // type A. `to_line`: the block of the offset mode there is a line.
  [[nodiscard]] std::optional<CornerClass> detour(const PathEnd& former, const PathEnd& latter, bool to_line) const;
  // `movement`: from head to head of a group made with this offset.
  [[nodiscard]] bool is_small(const PlanePoint& movement, const Rational& offset) const;

  Recorder& recorder_;
  bool type_b_;     // 5003#0, SUP
  Rational limit_;  // 5010, setup units
};

}  // namespace toolcomp::model
