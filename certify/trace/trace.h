// SPDX-License-Identifier: Apache-2.0
// Judges a recorded run against the exact path.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "certify/trace/deviations.h"
#include "certify/trace/program_path.h"
#include "certify/trace/samples.h"
#include "spec/language/axes.h"
#include "spec/language/case.h"
#include "spec/language/event.h"

namespace toolcomp::certify {

struct TraceOptions {
  double tolerance = 0;                    // linear axes, setup units; positive
  std::optional<double> rotary_tolerance;  // each rotary axis, degrees; positive; without it the number of `tolerance`
  PathFrame frame = PathFrame::workpiece;  // the coordinates of the recording
  bool judge_rapids = true;                // as straight lines; false: only their ends, and each axis in between
  std::size_t most_findings = 100;         // number of findings kept; all are counted
  bool pictures = true;                    // false: leave out the data that only pictures need
  bool causes = true;                      // look for one mistake that explains all findings
};

// The true distance is between these bounds, whatever the approximation of curves.
struct Bounds {
  double lower = 0;
  double upper = 0;
};

// docs/trace.md says what each kind means.
struct TraceFinding {
  std::string kind;           // "off the path", "corner not reached", "move left out", "gap", "out of order", …
  std::uint64_t sample = 0;   // line of the CSV: the first sample of its run
  std::uint64_t samples = 0;  // number of samples in the run; 0 if something is missing between two samples
  std::uint64_t line = 0;     // of the program: the first move concerned
  std::optional<std::uint64_t> n;
  std::uint64_t last_line = 0;  // the last one
  std::optional<std::uint64_t> last_n;
  Bounds distance;  // of the linear axes, in setup units, at the worst place
  Bounds rotary;    // degrees, there
  char rotary_axis = 0;
  spec::AxisValues<double> at;     // the worst place: a sample, or a place of the path
  std::uint64_t worst_sample = 0;  // line of the CSV if `at` is a sample, otherwise 0
  double duration = 0;             // seconds without a sample
};

struct TraceResult {
  std::uint64_t samples = 0;
  std::uint64_t off = 0;      // samples off the path
  std::uint64_t corners = 0;  // ends of moves
  std::uint64_t corners_missed = 0;
  std::uint64_t not_judged_moves = 0;  // moves whose inside is not judged
  double length = 0;                   // of the path in the linear axes, in setup units
  double covered = 0;                  // length of the path that the recording covers
  // The largest distance of an accepted sample that is not only on moves whose inside is not judged.
  Bounds worst;                    // setup units
  std::uint64_t worst_sample = 0;  // line of the CSV
  Bounds worst_rotary;             // degrees
  std::uint64_t worst_rotary_sample = 0;
  std::uint64_t steps_not_judged = 0;  // long time steps at which the recording has no steady period
  std::string recorded;                // axis letters
  std::string not_recorded;            // axes that were not judged
  std::uint64_t findings_total = 0;
  std::vector<TraceFinding> findings;       // by sample
  std::optional<std::string> cause;         // one mistake that explains all findings (certify/causes/recording_cause.h)
  Deviations deviations;                    // sample by sample, for pictures
  std::vector<AxisPoint> course;            // the exact path as far as a picture shows it
  std::vector<spec::Event<double>> events;  // events of the exact run: the first ones, for a picture, and every alarm
  std::string undecided;                    // why the model could not decide; otherwise empty
};

// Judges the samples of one run of `c.program`, in the units of its events and the coordinates of `options.frame`. The
// recording, its samples joined by straight lines, is accepted exactly if the recording and the exact path can be run
// through side by side, never backwards and never farther apart than the tolerance (the continuous Fréchet distance),
// with the linear axes as one length and each rotary axis by itself. The recording may begin anywhere on the first move
// and must end at the end. If it has times, steps of more than one and a half periods are findings too. Memory grows
// neither with the recording nor with the path. Throws spec::InputError for a malformed case and for a tolerance that
// is not positive, and whatever the source throws.
TraceResult judge_trace(const spec::Case& c, SampleSource& samples, const TraceOptions& options);
// The same for a CSV that certify::Recording reads.
TraceResult judge_trace(const spec::Case& c, std::istream& csv, const std::string& file, const TraceOptions& options);

// 1 if there is a finding; 3 if the model could not decide, or nothing was judged; otherwise 0.
int exit_status(const TraceResult& result);

}  // namespace toolcomp::certify
