// A recorded run judged against the exact path.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "spec/language/axes.h"
#include "spec/language/case.h"
#include "spec/language/event.h"

namespace toolcomp::certify {

struct TraceOptions {
  double tolerance = 0;             // setup units for linear axes, degrees for rotary ones; positive
  bool judge_rapids = true;         // as straight lines; false: their ends only (positioning axis by axis)
  std::size_t most_findings = 100;  // kept; all are counted
};

struct TraceFinding {
  std::string kind;          // "off the path", "corner not reached", "end not reached"
  std::uint64_t sample = 0;  // line of the CSV
  std::uint64_t line = 0;    // of the program: the move concerned
  std::optional<std::uint64_t> n;
  double distance = 0;          // setup units: from the path, or of the recording from the corner; worst of its run
  std::uint64_t samples = 1;    // in a row
  spec::AxisValues<double> at;  // of the sample; of the corner
};

struct TraceResult {
  std::uint64_t samples = 0;
  std::uint64_t off = 0;      // samples off the path
  std::uint64_t corners = 0;  // ends of moves
  std::uint64_t corners_missed = 0;
  std::uint64_t not_judged_moves = 0;  // whose inside is not judged: after a change of the workpiece system, or rapids
  double worst = 0;                    // largest distance of an accepted sample, setup units
  double worst_rotary = 0;             // degrees
  std::uint64_t worst_sample = 0;      // line of the CSV
  std::string recorded;                // axis letters
  std::string not_recorded;            // axes that were not judged
  std::uint64_t findings_total = 0;
  std::vector<TraceFinding> findings;
  std::vector<spec::Event<double>> events;  // of the exact run
  std::string undecided;                    // why the model could not decide; empty: it could
};

// Judges the samples of one run of `c.program`, recorded in the coordinates of the events' `axes`. A sample is accepted
// if it is within the tolerance of a point of the path that does not lie before those of earlier samples; a corner (the
// end of a move) is reached if the straight line between two samples in a row passes it within the tolerance, in order.
// Consecutive samples on an arc may stand half a turn apart, no more. The trace may begin anywhere on the first move
// and must end at the end. Distances are of the linear axes recorded; each rotary axis is compared by itself. Memory
// does not grow with the trace. Throws spec::InputError for a malformed CSV or case, and for a tolerance that is not
// positive.
TraceResult judge_trace(const spec::Case& c, std::istream& csv, const std::string& file, const TraceOptions& options);

// 1 a finding; 3 the model could not decide, or nothing was judged; else 0.
int exit_status(const TraceResult& result);

}  // namespace toolcomp::certify
