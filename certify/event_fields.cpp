// SPDX-License-Identifier: Apache-2.0
#include "certify/event_fields.h"

namespace toolcomp::certify {
namespace {

using spec::EventKind;
using spec::Field;
using spec::FieldSet;

void add_if(FieldSet& fields, bool there, Field field) {
  if (there) fields.add(field);
}

void add_arc(FieldSet& fields, const spec::Arc<exact::Real>& arc) {
  fields.add({Field::center, Field::plane, Field::direction});
  add_if(fields, arc.sweep.has_value(), Field::sweep);
  add_if(fields, arc.radius.has_value(), Field::radius);
}

void add_space(FieldSet& fields, const spec::SpaceCompensation<exact::Real>& space) {
  fields.add({Field::tool_center, Field::shift, Field::tool_shift});
  add_if(fields, space.carrier.has_value(), Field::carrier);
  if (!space.contact) return;
  fields.add({Field::contact, Field::normal});
  add_if(fields, space.contact->angle.has_value(), Field::angle);
  add_if(fields, space.contact->flat, Field::flat);
}

}  // namespace

FieldSet fields_of(const model::Event& event) {
  FieldSet fields{Field::kind, Field::line};
  add_if(fields, event.n.has_value(), Field::n);
  add_if(fields, !event.clauses.empty(), Field::clauses);
  switch (event.kind) {
    case EventKind::move:
      fields.add({Field::type, Field::cause});
      add_if(fields, !event.programmed.empty(), Field::programmed);
      if (event.arc) add_arc(fields, *event.arc);
      add_if(fields, event.unknown != 0, Field::unknown);
      if (event.space) add_space(fields, *event.space);
      add_if(fields, event.feed.has_value(), Field::feed);
      break;
    case EventKind::sample:
      fields.add(Field::t);
      break;
    case EventKind::hole:
      fields.add({Field::r, Field::bottom, Field::level});
      break;
    case EventKind::alarm:
    case EventKind::warning:
      fields.add({Field::number, Field::message});
      add_if(fields, event.alarm != spec::AlarmCause::none, Field::cause);
      return fields;
    case EventKind::not_supported:
    case EventKind::not_judged:
      fields.add({Field::code, Field::message});
      return fields;
    case EventKind::setting:
      fields.add({Field::name, Field::value});
      return fields;
    case EventKind::undecided:
      fields.add({Field::clause, Field::permitted});
      add_if(fields, event.out_of_scope, Field::reason);
      return fields;
  }
  add_if(fields, !event.point.empty(), Field::point);
  add_if(fields, !event.axes.empty(), Field::axes);
  add_if(fields, !event.machine.empty(), Field::machine);
  add_if(fields, event.tool_axis.has_value(), Field::tool_axis);
  return fields;
}

FieldSet fields_of(const judge::ModelRun& run) {
  FieldSet fields;
  for (const model::Event& event : run.events) fields.add(fields_of(event));
  return fields;
}

}  // namespace toolcomp::certify
