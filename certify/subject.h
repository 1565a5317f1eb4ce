// SPDX-License-Identifier: Apache-2.0
// What is certified: something that turns a case into events.
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

// An answer that is no list of events.
struct Fault {
  FaultKind kind{};
  std::string what;    // for people
  std::string status;  // how the process ended: "exit status 3", "killed by signal 11 (Segmentation fault)"
  std::string errors;  // the last of standard error
};

// An answer that says: no such case for this controller.
struct NotApplicable {
  std::string why;
  // What it does otherwise by design, where that is why: "outer-corner".
  std::string known_difference = {};  // NOLINT(readability-redundant-member-init)
};

// A field that was announced, applies to an event, and is not there.
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
  std::optional<MissingField> missing;  // with events: the first one
  spec::FieldSet sent;                  // of a controller's events: the fields that any of them has
  // Of a controller: as it came; empty: nothing did. With an initializer, GCC lets aggregates leave it out.
  std::string line = {};  // NOLINT(readability-redundant-member-init)
};

// One thread uses a subject at a time.
class Subject {
 public:
  virtual ~Subject() = default;
  // What the subject says about itself; a fault if it could not be asked.
  virtual std::variant<Capabilities, Fault> capabilities() = 0;
  // The subject's answer to a case. `patience` shortens the time-out.
  virtual Answer run(const spec::Case& c, std::optional<std::chrono::milliseconds> patience = {}) = 0;
  // Whether it is the fast engine in this process.
  [[nodiscard]] virtual bool is_fast_engine() const { return false; }
  // The longest time an answer took so far.
  [[nodiscard]] virtual std::chrono::milliseconds slowest() const { return std::chrono::milliseconds(0); }
  // Cases it has answered so far, rightly or wrongly.
  [[nodiscard]] virtual std::uint64_t answers() const { return 0; }
  // Processes started so far: what one has been told, the next does not know. 0 for ever: there is none.
  [[nodiscard]] virtual std::uint64_t starts() const { return 0; }
  // The next request meets a fresh process.
  virtual void restart() {}
  // The last of standard error, and the first line on standard output that is no answer.
  [[nodiscard]] virtual std::string errors() const { return {}; }
  [[nodiscard]] virtual std::string chatter() const { return {}; }
  // The first answer to hello, as it came.
  [[nodiscard]] virtual std::string hello() const { return {}; }
};

// The formal specification in this process (formal/engine.h): exact events, which are held exactly (exactly.h).
// Requires formal::available(); from one thread, always the same. InputError passes through.
std::unique_ptr<Subject> formal_specification();

// The fast engine in this process: every section and field, in double. InputError of the engine passes through.
std::unique_ptr<Subject> built_in_engine();

}  // namespace toolcomp::certify
