// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/fault.h"

#include <algorithm>

namespace toolcomp::certify {
namespace {

Distance larger(const Distance& a, const Distance& b) {
  return {std::max(a.linear, b.linear), std::max(a.rotary, b.rotary)};
}

TraceFinding finding_of(const Farthest& farthest, const FaultScene& scene) {
  const Metric& metric = scene.metric;
  const double searched = std::max(0.0, farthest.upper - farthest.lower);
  const double rounding = Metric::rounding(std::max(metric.magnitude(farthest.at), metric.magnitude(farthest.other)));
  const auto bounds = [&](double alone, double most, double error, double tolerance) -> Bounds {
    return {std::max(0.0, alone - error - rounding), most + searched * tolerance + error + rounding};
  };
  TraceFinding finding;
  if (!metric.space().linear.empty())
    finding.distance =
        bounds(farthest.alone.linear, farthest.most.linear, farthest.error.linear, metric.tolerance().linear);
  if (farthest.turned) {
    finding.rotary =
        bounds(farthest.alone.rotary, farthest.most.rotary, farthest.error.rotary, metric.tolerance().rotary);
    finding.rotary_axis = scene.axes.letter(*farthest.turned);
  }
  for (const auto* axes : {&metric.space().linear, &metric.space().rotary})
    for (const std::size_t axis : *axes) finding.at.set(axis, farthest.at[axis]);
  finding.worst_sample = farthest.csv_line;
  return finding;
}

void name_moves(TraceFinding& finding, const MoveName& first, const MoveName& last) {
  finding.line = first.line;
  finding.n = first.n;
  finding.last_line = last.line;
  finding.last_n = last.n;
}

}  // namespace

void Farthest::take(const AxisPoint& p, const AxisPoint& nearest, const Distance& lines_off, const Metric& metric,
                    std::uint64_t line) {
  const Distance distance = metric.between(p, nearest);
  Farthest here;
  here.lower = here.upper = metric.in_tolerances(distance);
  here.at = p;
  here.other = nearest;
  here.most = distance;
  if (!metric.mixed()) here.alone = distance;
  here.error = lines_off;
  here.csv_line = line;
  here.turned = metric.turned(p, nearest);
  take(here);
}

void Farthest::take(const Farthest& part) {
  if (part.lower > lower) {
    lower = part.lower;
    at = part.at;
    other = part.other;
    csv_line = part.csv_line;
  }
  upper = std::max(upper, part.upper);
  alone = larger(alone, part.alone);
  if (part.most.rotary > most.rotary) turned = part.turned;
  most = larger(most, part.most);
  error = larger(error, part.error);
}

void report(const LostMatch& fault, const FaultScene& scene, TraceResult& result, Findings& findings) {
  const SamplesOff samples = samples_off(fault, scene);
  PathLeftOut path = path_left_out(fault, scene);
  // Samples between that all lie on a move say that it was not left out.
  if (path.kind != nullptr && !fault.end && path.corners == 0 && samples.any && samples.count == 0) path.kind = "gap";
  result.off += samples.count;
  result.corners_missed += path.corners;
  result.covered -= path.length;
  if (samples.count > 0) {
    TraceFinding finding = finding_of(samples.farthest, scene);
    finding.kind = "off the path";
    if (samples.on_other_path) finding.kind = fault.begin ? "begin not reached" : "out of order";
    finding.sample = samples.csv_line;
    finding.samples = samples.count;
    name_moves(finding, samples.move, path.kind == nullptr ? samples.move : path.last);
    if (fault.continued)
      findings.extend(finding);
    else
      findings.add(std::move(finding));
    // A gap is where there are no samples.
    const bool farther = path.farthest.lower > samples.farthest.upper;
    if (path.kind == nullptr || path.is_gap || !farther) return;
  }
  if (fault.cut || (fault.continued && path.kind == nullptr)) return;
  TraceFinding finding = finding_of(path.farthest, scene);
  finding.kind = path.kind == nullptr ? "out of order" : path.kind;
  if (fault.begin && samples.count == 0) finding.kind = "begin not reached";
  finding.sample = fault.line;
  name_moves(finding, path.first, path.last);
  findings.add(std::move(finding));
}

}  // namespace toolcomp::certify
