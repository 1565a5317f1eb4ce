// SPDX-License-Identifier: Apache-2.0
// Verdicts: whether the specification permits a list of events for a case.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fast/basis/event.h"
#include "judge/oracle/resolution.h"
#include "judge/oracle/widths.h"
#include "model/basis/event.h"
#include "model/basis/recorder.h"
#include "spec/language/byte_source.h"
#include "spec/language/case.h"
#include "spec/language/known.h"
#include "spec/language/reader_options.h"
#include "spec/language/setup.h"

namespace toolcomp::judge {

enum class Outcome : std::uint8_t { agrees, differs, undecided, nothing_judged };

// The first difference. Texts are for people. `clause` is the clause to which it is attributed (spec::naming_clause).
struct Difference {
  std::uint64_t line = 0;
  std::string kind;   // what differs: "missing event", "extra event", "order", "alarm", "cause", "coordinate", …
  std::string field;  // "point.X"
  std::string expected;
  std::string actual;
  double deviation_um = 0;  // of a linear coordinate: how far it is outside the enclosure
  std::optional<spec::Clause> clause;
  spec::ClauseList clauses;  // all clauses of the event concerned
  std::size_t event = 0;     // index in the list of events, from 0
};

// "line 5, point.X: 3.5 expected, 3.25 given, 250000 um off (fanuc.leading-edge.…)".
std::string explain(const Difference& difference);

// The end of a run without an alarm (spec::is_beyond): it is not known what a control does there, and from there on.
struct Beyond {
  std::uint64_t line = 0;
  std::uint64_t column = 1;
  const char* what = "";   // static text that names it
  std::size_t events = 0;  // number of events given before the block was read: events after them are not certain
};

// Events of the model that say that it is not known what a block does: left open by the specification, or out of scope.
struct OpenEvents {
  std::uint64_t count = 0;
  std::uint64_t line = 0;  // line of the first one
  bool out_of_scope = false;
};

struct Verdict {
  Outcome outcome = Outcome::nothing_judged;
  std::optional<Difference> difference;  // also with `undecided`, if a difference could not be settled
  std::uint64_t values = 0;              // number of judged numbers and alarm numbers
  std::uint64_t numbers = 0;             // number of judged numbers only
  std::uint64_t wide = 0;      // numbers that were granted more than policy::kCap: not judged, and not in `values`
  Widths widths;               // widths granted to the numbers, judged or not
  std::uint64_t events = 0;    // events of the model that were judged against an event of the other side
  std::uint64_t left_out = 0;  // events of the model left out by JudgeOptions::known
  // How many of them rest on each clause; an event may rest on several.
  std::map<spec::Clause, std::uint64_t> left_out_for;
  OpenEvents open;
  // Events of the model after one with the reason OUT_OF_SCOPE (of a controller: not judged).
  std::uint64_t out_of_scope = 0;
  std::optional<Beyond> beyond;  // the place up to which the program was judged
  std::uint64_t decisions = 0;   // of the model, by sign
  std::uint64_t near_ties = 0;   // decisions inside their band
  std::uint64_t ties = 0;        // near ties at which the engine took the other, permitted outcome
  double worst_ulp = 0;          // largest distance outside an enclosure, in the units that the policy multiplies by k
  double worst_um = 0;           // the same for judged linear coordinates, in micrometres
  Bias bias;                     // of rounded lengths
  std::string undecided;         // why, if the outcome is `undecided`
};

// What is judged. The default judges everything, in double. Samples are judged if the field `t` is among the fields.
struct JudgeOptions {
  std::vector<std::string> fields;  // event fields the controller announced; empty: all
  Resolution resolution;            // of the controller's numbers
  // An event of the model that rests on a clause of another kind is counted and not judged. If the other side differs
  // there, the next events may differ for the same reason, so they are not judged either until a move agrees again.
  // NOLINTNEXTLINE(*-redundant-member-init): GCC warns where braces leave it out otherwise
  spec::KnownSet known = {};
};

// A run of the model on one case. `undecided` is set if a decision could not be certified.
struct ModelRun {
  std::vector<model::Event> events;
  std::optional<Beyond> beyond;
  // For every event: the number of decisions by sign that had been taken when it was given.
  std::vector<std::size_t> asked;
  model::Recorder recorder{true};
};
// Forced outcomes, by index of the decision.
using Forced = std::map<std::size_t, exact::Sign>;

// Both throw spec::InputError for a setup that no control could have and for programs that are not text.
ModelRun run_model(const spec::Case& c, const Forced& forced = {});
std::vector<fast::Event> run_fast(const spec::Case& c);

// Judges `events` (in double) against the model's permitted runs of the case.
Verdict judge(const spec::Case& c, std::span<const fast::Event> events, const JudgeOptions& options = {});
// The same with a given run of the model, so that the caller can use its recorder.
Verdict judge(const spec::Case& c, const ModelRun& run, std::span<const fast::Event> events,
              const JudgeOptions& options = {});
// The same for a controller's events: decimal texts are judged as the exact rationals they are. A text that is not a
// decimal number is a difference of kind "malformed number". If the program comes to a block that is not supported or
// not judged, only the events before are judged.
Verdict judge(const spec::Case& c, const ModelRun& run, std::span<const spec::TextEvent> events,
              const JudgeOptions& options = {});

// |quantity| / scale of a decision; 0 for an exact tie.
double margin(const model::Decision& decision);

// A program of any length, as text.
struct StreamedProgram {
  std::function<std::unique_ptr<spec::ByteSource>()> open;  // from the beginning
  bool once = false;                                        // true for standard input, which can be opened only once
  std::string name = "program";                             // in messages
  // NOLINTNEXTLINE(*-redundant-member-init): GCC warns where braces leave it out otherwise
  spec::CalledProgram called_program = {};
};

// Runs both engines over the program in bounded memory, judges at the same time, and stops at the first difference.
// `samples` as in a case. `on_block` is called with the number of blocks read, for progress. A difference with a near
// tie in the last blocks is settled by running again with the other outcomes, at most policy::kMaxPasses times; it
// stays `undecided` in a program that can be opened once.
Verdict judge_stream(const StreamedProgram& program, const spec::Setup& setup, std::uint32_t samples = 0,
                     void (*on_block)(std::uint64_t) = nullptr);

}  // namespace toolcomp::judge
