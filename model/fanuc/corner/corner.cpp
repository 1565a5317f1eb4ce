#include "model/fanuc/corner/corner.h"

#include "model/basis/event.h"

namespace toolcomp::model {

CornerClass classify(Recorder& recorder, const PathEnd& former, const PathEnd& latter) {
  const PlanePoint& t1 = former.heading.along;
  const PlanePoint& t2 = latter.heading.along;
  const Real scale = former.heading.length * latter.heading.length;
  const Real turn = cross(t1, t2);
  const Sign side = recorder.decide(Clause::fanuc_cutter_c_corner_side, former.offset > 0 ? turn : -turn, scale);
  if (side == Sign::positive) return CornerClass::inner;
  const bool parallel = side == Sign::zero;
  const Clause clause = parallel ? Clause::fanuc_cutter_c_straight_or_reversal : Clause::fanuc_cutter_c_obtuse_or_acute;
  const Sign ahead = recorder.decide(clause, dot(t1, t2), scale);
  if (ahead == Sign::negative) return CornerClass::acute;
  return parallel ? CornerClass::straight : CornerClass::obtuse;
}

bool is_under_one_degree(Recorder& recorder, const PathEnd& former, const PathEnd& latter) {
  return is_under_one_degree(recorder, square(cross(former.heading.along, latter.heading.along)),
                             square(dot(former.heading.along, latter.heading.along)));
}

bool is_under_one_degree(Recorder& recorder, const Real& cross2, const Real& dot2) {
  static const Rational tangent = Rational("174550649282175857651288952197/10000000000000000000000000000000");
  const Real ahead2 = Rational(tangent * tangent) * dot2;
  return recorder.decide(Clause::fanuc_cutter_c_under_one_degree, ahead2 - cross2, ahead2 + cross2) == Sign::positive;
}

PlanePoint perpendicular(const PathEnd& end) { return (end.offset / end.heading.length) * left(end.heading.along); }

// ρ (N1 + N2) / (1 + k) with N = left(t) / |t| and k = t1·t2 / (|t1| |t2|).
PlanePoint tangents_meet(const PathEnd& former, const PathEnd& latter) {
  const Heading& a = former.heading;
  const Heading& b = latter.heading;
  const Real denominator = a.length * b.length + dot(a.along, b.along);
  if (denominator.sign() == Sign::zero) throw NotFinite();  // a reversal comes here only if its class is forced
  return (former.offset / denominator) * left(b.length * a.along + a.length * b.along);
}

PlanePoint prolonged(const PathEnd& former) {
  const Rational reach = abs(former.offset);
  const Heading& t = former.heading;
  return (1 / t.length) * (former.offset * left(t.along) + reach * t.along);
}

PlanePoint begun_before(const PathEnd& latter) {
  const Rational reach = abs(latter.offset);
  const Heading& t = latter.heading;
  return (1 / t.length) * (latter.offset * left(t.along) - reach * t.along);
}

}  // namespace toolcomp::model
