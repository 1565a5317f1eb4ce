// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/reading.h"

#include <utility>

#include "judge/oracle/number.h"

namespace toolcomp::judge {

using exact::Rational;

spec::Event<Rational> Reading::event(const spec::TextEvent& e) {
  spec::Event<Rational> r;
  r.kind = e.kind;
  r.line = e.line;
  r.n = e.n;
  r.type = e.type;
  r.cause = e.cause;
  r.alarm = e.alarm;
  r.number = e.number;
  r.permitted = e.permitted;
  r.out_of_scope = e.out_of_scope;
  r.setting = e.setting;
  r.t_numerator = e.t_numerator;
  r.t_denominator = e.t_denominator;
  table("programmed", e.programmed, r.programmed);
  table("point", e.point, r.point);
  table("axes", e.axes, r.axes);
  table("machine", e.machine, r.machine);
  if (e.tool_axis) r.tool_axis = vector("tool_axis", *e.tool_axis);
  if (e.space) space(*e.space, r.space.emplace());
  if (e.arc) {
    r.arc.emplace();
    r.arc->plane = e.arc->plane;
    r.arc->direction = e.arc->direction;
    table("center", e.arc->center, r.arc->center);
    if (e.arc->sweep) r.arc->sweep = number("sweep", *e.arc->sweep);
    if (e.arc->radius)
      r.arc->radius = std::pair(number("radius", e.arc->radius->first), number("radius", e.arc->radius->second));
  }
  r.unknown = e.unknown;
  if (e.hole)
    r.hole = {e.hole->axis, number("r", e.hole->point_r), number("bottom", e.hole->bottom),
              number("return", e.hole->level)};
  if (e.feed) r.feed = number("feed", *e.feed);
  if (e.kind == spec::EventKind::setting) r.value = number("value", e.value);
  return r;
}

Rational Reading::number(std::string_view field, const spec::NumberText& text) {
  const std::optional<Rational> value = parse_number(text.v);
  if (value) return *value;
  if (!bad_ && rules_.judges(field)) {
    bad_.emplace();
    bad_->kind = "malformed number";
    bad_->field = field;
    bad_->expected = "a decimal number";
    bad_->actual = text.v;
  }
  return 0;
}

std::array<Rational, 3> Reading::vector(std::string_view field, const std::array<spec::NumberText, 3>& from) {
  std::array<Rational, 3> to;
  for (std::size_t i = 0; i < 3; ++i) to[i] = number(field, from[i]);
  return to;
}

void Reading::space(const spec::SpaceCompensation<spec::NumberText>& from, spec::SpaceCompensation<Rational>& to) {
  to.tool_center = vector("tool_center", from.tool_center);
  to.shift = vector("shift", from.shift);
  to.tool_shift = vector("tool_shift", from.tool_shift);
  if (from.carrier) to.carrier = vector("carrier", *from.carrier);
  if (!from.contact) return;
  to.contact.emplace();
  to.contact->point = vector("contact", from.contact->point);
  to.contact->normal = vector("normal", from.contact->normal);
  to.contact->flat = from.contact->flat;
  if (from.contact->angle) to.contact->angle = number("angle", *from.contact->angle);
}

void Reading::table(std::string_view field, const TextTable& from, RationalTable& to) {
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (from.has(i)) to.set(i, number(field, from[i]));
}

}  // namespace toolcomp::judge
