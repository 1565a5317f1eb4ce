// SPDX-License-Identifier: Apache-2.0
// Cases, the one interchange format (corpus/schema/case.schema.json): golden vectors, findings and requests to
// controllers.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/axes.h"
#include "spec/language/event.h"
#include "spec/language/setup.h"

namespace toolcomp::spec {

// An expected or reported number as text. In golden vectors the exact value is in [v - r, v + r], and q is the exact
// value if it is rational. Controllers and the fast engine give only v.
struct NumberText {
  std::string v;
  std::string r;  // empty: not stated
  std::string q;  // empty: not rational
  friend bool operator==(const NumberText&, const NumberText&) = default;
};

using TextEvent = Event<NumberText>;

struct CaseSource {
  std::string generator;
  std::string version;
  std::string seed;
  friend bool operator==(const CaseSource&, const CaseSource&) = default;
};

// The largest number of parts of a block, with samples between them.
inline constexpr std::uint32_t kMostSamples = 1'000'000;

// The language of programs. The control alone decides it.
constexpr std::string_view dialect_of(Control control) { return control == Control::heidenhain ? "klartext" : "fanuc"; }

struct Case {
  std::string id;
  std::string section;  // "fanuc/leading-edge-offset"
  std::string comment;
  std::vector<std::string> clauses;
  std::vector<std::string> flags;
  std::string dialect = "fanuc";  // dialect_of(setup.control)
  Setup setup;
  std::string program;
  std::uint32_t samples = 0;  // parts of a block under tool center point control (docs/events.md, rule 7)
  CaseSource source;
  std::vector<TextEvent> expect;
  bool has_expect = false;
};

}  // namespace toolcomp::spec
