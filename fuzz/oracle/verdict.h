// SPDX-License-Identifier: Apache-2.0
// Verdicts: is a list of events what the specification permits for a case?
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
#include "fuzz/oracle/resolution.h"
#include "fuzz/oracle/widths.h"
#include "model/basis/event.h"
#include "model/basis/recorder.h"
#include "spec/language/byte_source.h"
#include "spec/language/case.h"
#include "spec/language/known.h"
#include "spec/language/reader_options.h"
#include "spec/language/setup.h"

namespace toolcomp::fuzz {

enum class Outcome : std::uint8_t { agrees, differs, undecided, nothing_judged };

// The first difference. Texts are for people; `clause` is the one that names it (spec::naming_clause).
struct Difference {
  std::uint64_t line = 0;
  std::string kind;   // what differs: "missing event", "extra event", "order", "alarm", "cause", "coordinate", …
  std::string field;  // "point.X"
  std::string expected;
  std::string actual;
  double deviation_um = 0;  // linear coordinates: how far outside the enclosure
  std::optional<spec::Clause> clause;
  spec::ClauseList clauses;  // all clauses of the event concerned
  std::size_t event = 0;     // index in the list of events, from 0
};

// "line 5, point.X: 3.5 expected, 3.25 given, 250000 um off (fanuc.leading-edge.…)".
std::string explain(const Difference& difference);

// Where a run ends without an alarm (spec::is_beyond): what a control does there, and from there on, is not known.
struct Beyond {
  std::uint64_t line = 0;
  std::uint64_t column = 1;
  const char* what = "";   // static text, names it
  std::size_t events = 0;  // that were given before the block was known: nothing behind them is certain
};

// Of the model, those that say that nothing is known of what a block does: left open by the specification, or out of
// scope.
struct OpenEvents {
  std::uint64_t count = 0;
  std::uint64_t line = 0;  // of the first
  bool out_of_scope = false;
};

struct Verdict {
  Outcome outcome = Outcome::nothing_judged;
  std::optional<Difference> difference;  // also with `undecided`, where a difference could not be settled
  std::uint64_t values = 0;              // judged: numbers, and the numbers of alarms
  std::uint64_t numbers = 0;             // judged numbers alone
  std::uint64_t wide = 0;                // numbers granted more than policy::kCap: not judged, and not among `values`
  Widths widths;                         // granted to the numbers, judged or not
  std::uint64_t events = 0;              // of the model, judged against one of the other side
  std::uint64_t left_out = 0;            // of the model: JudgeOptions::known
  std::map<spec::Clause, std::uint64_t> left_out_for;  // of them, how many rest on this clause; one may rest on several
  OpenEvents open;
  std::uint64_t out_of_scope = 0;  // of the model, behind one of reason OUT_OF_SCOPE (a controller's: not judged)
  std::optional<Beyond> beyond;    // the program was judged up to there
  std::uint64_t decisions = 0;     // of the model, by sign
  std::uint64_t near_ties = 0;     // decisions inside their band
  std::uint64_t ties = 0;          // near ties in which the engine took the other, permitted, outcome
  double worst_ulp = 0;            // largest distance outside an enclosure, in the units the policy multiplies by k
  double worst_um = 0;             // the same of linear coordinates that were judged, in micrometres
  Bias bias;                       // of rounded lengths
  std::string undecided;           // why, where the outcome is `undecided`
};

// What is judged. The default judges everything, in double. Samples are judged where the field `t` is.
struct JudgeOptions {
  std::vector<std::string> fields;  // event fields the controller announced; empty: all
  Resolution resolution;            // of the controller's numbers
  // An event of the model that rests on a clause known otherwise is counted and not judged. Where the other side
  // differs there, what follows may differ for that reason: it is not judged either until a move agrees again.
  // NOLINTNEXTLINE(*-redundant-member-init): GCC warns where braces leave it out otherwise
  spec::KnownSet known = {};
};

// The model on one case. `undecided` where a decision could not be certified.
struct ModelRun {
  std::vector<model::Event> events;
  std::optional<Beyond> beyond;
  std::vector<std::size_t> asked;  // of every event: the decisions by sign that had been taken when it was given
  model::Recorder recorder{true};
};
// Outcomes to take, by index of the decision.
using Forced = std::map<std::size_t, exact::Sign>;

// Both throw spec::InputError for a setup no control could have and for programs that are no text.
ModelRun run_model(const spec::Case& c, const Forced& forced = {});
std::vector<fast::Event> run_fast(const spec::Case& c);

// Judges `events` (in double) against the model's permitted runs of the case.
Verdict judge(const spec::Case& c, std::span<const fast::Event> events, const JudgeOptions& options = {});
// The same with the model run given, so that its recorder can be used further.
Verdict judge(const spec::Case& c, const ModelRun& run, std::span<const fast::Event> events,
              const JudgeOptions& options = {});
// The same for a controller's events: decimal texts are judged as the exact rationals they are. A text that is no
// decimal number is a difference of kind "malformed number". Where the program goes beyond what is supported only the
// events before are judged.
Verdict judge(const spec::Case& c, const ModelRun& run, std::span<const spec::TextEvent> events,
              const JudgeOptions& options = {});

// |quantity| / scale of a decision; 0 for an exact tie.
double margin(const model::Decision& decision);

// A program of any length, as text.
struct StreamedProgram {
  std::function<std::unique_ptr<spec::ByteSource>()> open;  // from the beginning
  bool once = false;                                        // standard input: it can be opened once
  std::string name = "program";                             // in messages
  // NOLINTNEXTLINE(*-redundant-member-init): GCC warns where braces leave it out otherwise
  spec::CalledProgram called_program = {};
};

// Runs both engines over it in bounded memory and judges as it goes; stops at the first difference. `samples` as in a
// case. `on_block` is called with the number of blocks read, for progress. A difference with a near tie in the last
// blocks is settled by running again with the other outcomes, at most policy::kMaxPasses times; it stays `undecided` in
// a program that can be opened once.
Verdict judge_stream(const StreamedProgram& program, const spec::Setup& setup, std::uint32_t samples = 0,
                     void (*on_block)(std::uint64_t) = nullptr);

}  // namespace toolcomp::fuzz
