// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "certify/causes/recording_cause.h"
#include "certify/convert.h"
#include "certify/trace/findings.h"
#include "certify/trace/matcher.h"
#include "certify/trace/program_path.h"
#include "certify/trace/recording.h"
#include "certify/trace/time_steps.h"
#include "judge/oracle/program_facts.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

// For the picture.
constexpr std::size_t kMostEvents = 5000;
constexpr std::size_t kMostOfCourse = 10000;
// Causes are looked for in recordings of so many samples at most.
constexpr std::size_t kMostForCauses = 200000;

void expect_positive(double tolerance, const char* option, const char* unit) {
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw spec::InputError(option, 0, 0, std::string("must be a positive number of ") + unit);
}

TraceSpace recorded_space(const spec::Axes& axes, const SampleSource& samples, TraceResult& result) {
  TraceSpace space;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const char letter = axes.letter(i);
    if (std::ranges::find(samples.recorded(), i) == samples.recorded().end()) {
      result.not_recorded += letter;
      continue;
    }
    result.recorded += letter;
    (spec::is_rotary_axis(letter) ? space.rotary : space.linear).push_back(i);
  }
  return space;
}

// A time step too long: nothing is known of what the machine did.
TraceFinding gap_of(const TimeStep& step, const TraceSpace& space) {
  TraceFinding finding;
  finding.kind = "gap";
  finding.sample = step.line;
  finding.line = finding.last_line = step.move.line;
  finding.n = finding.last_n = step.move.n;
  finding.duration = step.seconds;
  finding.worst_sample = step.line;
  for (const auto* axes : {&space.linear, &space.rotary})
    for (const std::size_t axis : *axes) finding.at.set(axis, step.at[axis]);
  return finding;
}

// The recording as long as it may be asked for a cause.
struct Kept {
  RecordedRun run;
  bool whole = true;  // else nothing is kept
  void take(const RecordedSample& sample) {
    whole = whole && run.samples.size() < kMostForCauses;
    if (whole)
      run.samples.push_back(sample);
    else
      run.samples = {};
  }
};

void match(SampleSource& samples, PathSource& path, const Metric& metric, const spec::Axes& axes,
           const TraceOptions& options, TraceResult& result, Kept& kept) {
  Findings findings(result, options.most_findings);
  Matcher matcher(path, metric, axes, result, findings);
  TimeSteps steps([&](const TimeStep& step) { findings.add(gap_of(step, metric.space())); });
  RecordedSample sample;
  std::optional<double> time;
  while (samples.next(sample)) {
    for (const std::size_t axis : samples.recorded())
      if (!(std::fabs(sample.at[axis]) <= kFarthest))
        throw spec::InputError("recording", sample.line, 0, "a position is not a number, or is beyond 1e9");
    matcher.take(sample.at, sample.line);
    if (options.pictures) result.deviations.take(sample.at, matcher.place(result.deviations.keeps_next()));
    kept.take(sample);
    if (!samples.has_time()) continue;
    if (time) steps.take({sample.time - *time, sample.resolution, sample.line, matcher.move(), sample.at});
    time = sample.time;
  }
  matcher.end();
  steps.end();
  result.steps_not_judged = steps.not_judged();
  findings.sort();
}

// The path as far as a picture shows it: chords no further off than a thousandth of its size.
std::vector<AxisPoint> course(const spec::Case& c, const Metric& metric, ProgramPathOptions options,
                              const Deviations& deviations) {
  AxisBox box;
  for (const Deviations::Point& point : deviations.points()) box.add(point.recorded);
  Distance coarse{metric.tolerance().linear, 100};
  for (const std::size_t axis : metric.space().linear)
    coarse.linear = std::max(coarse.linear, (box.high[axis] - box.low[axis]) / 10);
  options.on_event = {};
  ProgramPath path(c, metric.space(), coarse, options);
  std::vector<AxisPoint> points;
  for (PathPiece piece; points.size() < kMostOfCourse && path.next(piece);) {
    if (points.empty()) points.push_back(piece.begin);
    points.push_back(piece.end);
  }
  return points;
}

}  // namespace

TraceResult judge_trace(const spec::Case& c, SampleSource& samples, const TraceOptions& options) {
  const Distance tolerance{options.tolerance, options.rotary_tolerance.value_or(options.tolerance)};
  expect_positive(tolerance.linear, "--tolerance", "setup units");
  expect_positive(tolerance.rotary, "--rotary-tolerance", "degrees");
  TraceResult result;
  const Metric metric(recorded_space(c.setup.axes, samples, result), tolerance);
  ProgramPathOptions path_options;
  path_options.judge_rapids = options.judge_rapids;
  path_options.frame = options.frame;
  path_options.on_event = [&](const model::Event& event) {
    if ((options.pictures && result.events.size() < kMostEvents) || event.kind == spec::EventKind::alarm)
      result.events.push_back(in_double(event));
  };
  ProgramPath path(c, metric.space(), tolerance, path_options);
  result.deviations = Deviations(tolerance);
  Kept kept{{samples.recorded(), samples.has_time(), {}}};
  match(samples, path, metric, c.setup.axes, options, result, kept);
  result.undecided = path.undecided();
  if (result.undecided.empty() && result.findings_total == 0 && result.samples > 0 && result.samples < result.corners)
    result.undecided = fmt::format("{} samples cannot have covered {} corners", result.samples, result.corners);
  if (options.pictures) result.course = course(c, metric, path_options, result.deviations);
  if (!result.undecided.empty()) {
    // Nobody knows what the rest of the recording should be.
    result.findings.clear();
    result.findings_total = 0;
  } else if (options.causes && result.findings_total > 0 && kept.whole) {
    result.cause = common_cause(c, kept.run, metric, path_options, result);
  }
  return result;
}

TraceResult judge_trace(const spec::Case& c, std::istream& csv, const std::string& file, const TraceOptions& options) {
  Recording recording(csv, file, c.setup.axes, judge::ProgramFacts::of(c).units().value_or(c.setup.units));
  return judge_trace(c, recording, options);
}

int exit_status(const TraceResult& result) {
  if (result.findings_total > 0) return 1;
  return !result.undecided.empty() || result.samples == 0 || result.corners == 0 ? 3 : 0;
}

}  // namespace toolcomp::certify
