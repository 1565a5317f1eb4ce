// SPDX-License-Identifier: Apache-2.0
// A subject, the thing that is certified: it turns a case into events.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "certify/capabilities.h"
#include "fast/basis/event.h"
#include "model/basis/event.h"
#include "spec/language/case.h"
#include "spec/language/fields.h"

namespace toolcomp::certify {

enum class FaultKind : std::uint8_t {
  crash,      // the controller ended before it answered
  hang,       // no answer in time
  malformed,  // an answer that breaks the protocol
  too_long,   // an answer longer than the limit
  error,      // an answer that says why there are no events
};
inline constexpr std::size_t kFaultKinds = 5;
// "crash", "hang", "malformed reply", "reply too long", "error": the kind of the finding.
std::string name(FaultKind kind);

// An answer that is not a list of events.
struct Fault {
  FaultKind kind{};
  std::string what;    // for people
  std::string status;  // how the process ended: "exit status 3", "killed by signal 11 (Segmentation fault)"
  std::string errors;  // last lines of standard error
};

// An answer that the case does not apply to this controller.
struct NotApplicable {
  std::string why;
  // What it does otherwise by design, where that is why: "outer-corner".
  std::string known_difference = {};  // NOLINT(readability-redundant-member-init)
};

// A field that was announced, applies to an event, and is missing.
struct MissingField {
  std::uint64_t line = 0;
  std::size_t event = 0;  // index
  std::string field;
};

using FastEvents = std::vector<fast::Event>;
using TextEvents = std::vector<spec::TextEvent>;
using ExactEvents = std::vector<model::Event>;

struct Answer {
  std::variant<FastEvents, TextEvents, ExactEvents, Fault, NotApplicable> result;
  std::optional<MissingField> missing;  // with events: the first missing field
  spec::FieldSet sent;                  // of a controller's events: the fields that at least one of them has
  // The line of a controller as it came; empty if nothing came. With an initializer, GCC lets aggregates leave it out.
  std::string line = {};  // NOLINT(readability-redundant-member-init)
};

// One thread uses a subject at a time.
class Subject {
 public:
  virtual ~Subject() = default;
  // The capabilities of the subject; a fault if it could not be asked.
  virtual std::variant<Capabilities, Fault> capabilities() = 0;
  // The subject's answer to a case. `patience` shortens the time-out.
  virtual Answer run(const spec::Case& c, std::optional<std::chrono::milliseconds> patience = {}) = 0;
  // Whether it is the fast engine in this process.
  [[nodiscard]] virtual bool is_fast_engine() const { return false; }
  // The longest time an answer took so far.
  [[nodiscard]] virtual std::chrono::milliseconds slowest() const { return std::chrono::milliseconds(0); }
  // Number of cases it has answered so far, right or wrong.
  [[nodiscard]] virtual std::uint64_t answers() const { return 0; }
  // Number of processes started so far. A process does not know the requests to an earlier one. Always 0 if there is no
  // process.
  [[nodiscard]] virtual std::uint64_t starts() const { return 0; }
  // Makes the next request go to a fresh process.
  virtual void restart() {}
  // The last lines of standard error, and the first line on standard output that is not an answer.
  [[nodiscard]] virtual std::string errors() const { return {}; }
  [[nodiscard]] virtual std::string chatter() const { return {}; }
  // The first answer to hello, as it came.
  [[nodiscard]] virtual std::string hello() const { return {}; }
};

// The formal specification in this process (spec_engine/engine.h). Its events are exact and are compared exactly
// (exactly.h). Requires spec_engine::available(), and always the same thread. InputError passes through.
std::unique_ptr<Subject> formal_specification();

// The fast engine in this process: every section and field, in double. InputError of the engine passes through.
std::unique_ptr<Subject> built_in_engine();

}  // namespace toolcomp::certify
