// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/corner/offset_path.h"

namespace toolcomp::model {
namespace {

// The offset lies away from the centre: the offset circle is larger than the programmed one.
bool grows(const PathEnd& end) { return end.turn * end.offset <= 0; }
// R - |offset| has the sign of R² - offset².
Real radius_difference(const PathEnd& end) { return end.heading.length2 - Rational(end.offset * end.offset); }

}  // namespace

Heading heading(const PlanePoint& along) {
  Heading result{along, squared_norm(along), {}};
  result.length = sqrt(result.length2);
  return result;
}

OffsetPath line_path(const PlanePoint& travel, const Rational& offset_at_start, const Rational& offset_at_end) {
  const Heading way = heading(travel);
  return {travel, {way, 0, offset_at_start}, {way, 0, offset_at_end}};
}

PathEnd arc_end(const PlanePoint& from_center, int turn, const std::optional<Rational>& radius,
                const Rational& offset) {
  const PlanePoint along = Real(turn) * left(from_center);
  return {radius ? Heading{along, Rational(*radius * *radius), *radius} : heading(along), turn, offset};
}

OffsetPath arc_path(const ArcEnds& arc, const Rational& offset_at_start, const Rational& offset_at_end) {
  return {arc.end - arc.start, arc_end(arc.start, arc.turn, arc.radius, offset_at_start),
          arc_end(arc.end, arc.turn, arc.radius, offset_at_end), arc.one_radius};
}

Sign decide_offset_radius(Recorder& recorder, Clause clause, const PathEnd& end) {
  const Real scale = end.heading.length2 + end.offset * end.offset;
  return recorder.decide(clause, grows(end) ? scale : radius_difference(end), scale);
}

Sign offset_radius(const PathEnd& end) { return grows(end) ? Sign::positive : radius_difference(end).sign(); }

}  // namespace toolcomp::model
