// SPDX-License-Identifier: Apache-2.0
// Turns the tree of an event into a TextEvent. Internal to the readers of cases and replies.
#pragma once

#include "spec/language/case.h"
#include "spec/language/document.h"
#include "spec/language/fields.h"

namespace toolcomp::spec {

// Cases may have only the fields of docs/events.md, and must have those without which an event has no meaning. Replies
// of controllers may leave out fields, and unknown parts of them are ignored.
enum class Strictness : std::uint8_t { of_cases, of_replies };

struct EventWithFields {
  TextEvent event;
  FieldSet fields;
};

EventWithFields event_from(const document::Node& node, const document::Reader& read, const Axes& axes,
                           Strictness strictness);

}  // namespace toolcomp::spec
