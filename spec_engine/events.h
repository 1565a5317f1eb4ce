// SPDX-License-Identifier: Apache-2.0
// What the formal specification says of a run, as events.
#pragma once

#include "model/exact/real.h"
#include "spec/language/event.h"
#include "spec_engine/data.h"

namespace toolcomp::spec_engine {

// The trees are those of spec/formal/program/FanucCase.v and KlartextCase.v. Without line and n.
spec::Event<exact::Real> fanuc_event(const List& data, const spec::Axes& axes);
spec::Event<exact::Real> klartext_event(const List& data, const spec::Axes& axes);

}  // namespace toolcomp::spec_engine
