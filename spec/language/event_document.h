// SPDX-License-Identifier: Apache-2.0
// The tree of an event to a TextEvent. Internal to the readers of cases and replies.
#pragma once

#include "spec/language/case.h"
#include "spec/language/document.h"
#include "spec/language/fields.h"

namespace toolcomp::spec {

// Cases admit the fields of docs/events.md, and demand those without which an event means nothing; replies of
// controllers may leave out fields, and what is unknown in them is ignored.
enum class Strictness : std::uint8_t { of_cases, of_replies };

struct EventWithFields {
  TextEvent event;
  FieldSet fields;
};

EventWithFields event_from(const document::Node& node, const document::Reader& read, const Axes& axes,
                           Strictness strictness);

}  // namespace toolcomp::spec
