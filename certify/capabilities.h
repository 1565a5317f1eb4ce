// SPDX-License-Identifier: Apache-2.0
// What a controller says about itself, and whether a case applies to it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/oracle/resolution.h"
#include "fuzz/oracle/verdict.h"
#include "spec/language/case.h"
#include "spec/language/known.h"

namespace toolcomp::certify {

// The least increments that a controller announces, as it writes them; empty: double precision.
struct AnnouncedResolution {
  std::string mm;
  std::string inch;
  std::string degrees;
  std::string vectors;
  std::string rounding;  // "nearest", "down", "toward zero"; empty: not said

  [[nodiscard]] bool empty() const { return mm.empty() && inch.empty() && degrees.empty() && vectors.empty(); }
  // "0.001 mm, 0.0001 inch, 0.001 degrees, to nearest"
  [[nodiscard]] std::string words() const;
  // As the verdict takes it.
  [[nodiscard]] fuzz::Resolution numbers() const;
};

// The answer to {"hello":1} (docs/protocol.md).
struct Capabilities {
  std::string name;
  std::string version;
  std::vector<std::string> sections;
  std::vector<std::string> fields;  // event fields it gives; the others are not judged
  AnnouncedResolution resolution;
  std::string setup;  // JSON of the settings it cannot change; empty: none
  // Not the controller's word but the user's (certify --known): only what rests on clauses known so well is judged.
  spec::KnownSet known;
};

// What is judged in such a controller.
fuzz::JudgeOptions judge_options(const Capabilities& capabilities);

// Reads that answer. Unknown keys are ignored. Throws spec::InputError for text that is no such answer: not JSON, a
// protocol other than 1, a key of the wrong type, a resolution that is no positive decimal, a setup that cannot be. A
// resolution that is one decimal r is r mm, r degrees, r of unit vectors and r/10 inches; of a controller that has
// inches alone, r inches.
Capabilities read_capabilities(std::string_view line);
// The same of a tree.
Capabilities capabilities_from(const nlohmann::json& tree);
// The answer as one line without a line feed.
std::string write_capabilities(const Capabilities& capabilities);

// Every event field a controller can announce (docs/events.md).
std::vector<std::string> all_fields();
// Of all_fields(), those not announced.
std::vector<std::string> fields_not_judged(const Capabilities& capabilities);
// Whether kind, line and one of point and axes are announced: with less, nothing can be judged.
bool meets_minimum(const Capabilities& capabilities);

// Throws spec::InputError for an announced resolution of more than 0.01 mm, or 0.0004 inch in a controller of inches
// alone, that is more than `accepted`, a decimal in the same units, or empty: so coarse a
// controller is certified only for a user who says so.
void expect_fine_resolution(const Capabilities& capabilities, const std::string& accepted);

// Why the case does not apply to the controller: "section …", "setup …"; empty where it applies. A setting that the
// case leaves open counts as its default (0; of a parameter what the registry says).
std::string why_not_applicable(const Capabilities& capabilities, const spec::Case& c);

// Whether two setups mean the same, whatever is written out and what is left at its default.
bool same_meaning(const spec::Setup& a, const spec::Setup& b);

}  // namespace toolcomp::certify
