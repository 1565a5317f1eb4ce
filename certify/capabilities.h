// SPDX-License-Identifier: Apache-2.0
// The capabilities that a controller announces, and whether a case applies to it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "judge/oracle/resolution.h"
#include "judge/oracle/verdict.h"
#include "spec/language/case.h"
#include "spec/language/known.h"

namespace toolcomp::certify {

// The least increments that a controller announces, as it writes them; empty: double precision.
struct AnnouncedResolution {
  std::string mm;
  std::string inch;
  std::string degrees;
  std::string vectors;
  std::string rounding;  // "nearest", "down", "toward zero"; empty: not announced

  [[nodiscard]] bool empty() const { return mm.empty() && inch.empty() && degrees.empty() && vectors.empty(); }
  // "0.001 mm, 0.0001 inch, 0.001 degrees, to nearest"
  [[nodiscard]] std::string words() const;
  // In the form that the oracle needs.
  [[nodiscard]] judge::Resolution numbers() const;
};

// The answer to {"hello":1} (docs/protocol.md).
struct Capabilities {
  std::string name;
  std::string version;
  std::vector<std::string> sections;
  std::vector<std::string> fields;  // event fields it gives; the others are not judged
  AnnouncedResolution resolution;
  std::string setup;  // JSON of the settings it cannot change; empty: none
  // Chosen by the user, not announced by the controller (certify --known): only events that rest on clauses of these
  // kinds are judged.
  spec::KnownSet known;
};

// The options for judging such a controller.
judge::JudgeOptions judge_options(const Capabilities& capabilities);

// Reads that answer. Unknown keys are ignored. Throws spec::InputError for text that is not such an answer: not JSON, a
// protocol other than 1, a key of the wrong type, a resolution that is not a positive decimal, a setup that no control
// can have. A resolution given as a single decimal r means r mm, r degrees, r for unit vectors and r/10 inches; for a
// controller that has only inches, r inches.
Capabilities read_capabilities(std::string_view line);
// The same from a tree.
Capabilities capabilities_from(const nlohmann::json& tree);
// The answer as one line without a line feed.
std::string write_capabilities(const Capabilities& capabilities);

// Every event field that a controller can announce (docs/events.md).
std::vector<std::string> all_fields();
// The fields of all_fields() that are not announced.
std::vector<std::string> fields_not_judged(const Capabilities& capabilities);
// Whether kind, line, and one of point and axes are announced. Otherwise nothing can be judged.
bool meets_minimum(const Capabilities& capabilities);

// Throws spec::InputError for an announced resolution of more than 0.01 mm, or of more than 0.0004 inch for a
// controller that has only inches, if it is more than `accepted` (a decimal in the same units, or empty). A user must
// accept such a coarse controller explicitly.
void expect_fine_resolution(const Capabilities& capabilities, const std::string& accepted);

// Why the case does not apply to the controller: "section …", "setup …"; empty if it applies. A setting that the case
// does not give counts as its default (0; for a parameter, the default of the registry).
std::string why_not_applicable(const Capabilities& capabilities, const spec::Case& c);

// Whether two setups mean the same, no matter which defaults are written out.
bool same_meaning(const spec::Setup& a, const spec::Setup& b);

}  // namespace toolcomp::certify
