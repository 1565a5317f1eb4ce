#include "certify/trace/fault.h"

#include <algorithm>

namespace toolcomp::certify {
namespace {

Bounds bounds(double distance, double error, double searched) {
  return {std::max(0.0, distance - error), distance + error + searched};
}

TraceFinding finding_of(const Farthest& farthest, const FaultScene& scene) {
  const Metric& metric = scene.metric;
  TraceFinding finding;
  const double searched = std::max(0.0, farthest.upper - farthest.lower);
  finding.distance = bounds(farthest.distance.linear, farthest.error.linear, searched * metric.tolerance().linear);
  if (!metric.space().rotary.empty())
    finding.rotary = bounds(farthest.distance.rotary, farthest.error.rotary, searched * metric.tolerance().rotary);
  if (const auto axis = metric.turned(farthest.at, farthest.other)) finding.rotary_axis = scene.axes.letter(*axis);
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

void report(const Fault& fault, const FaultScene& scene, TraceResult& result, Findings& findings) {
  const SamplesOff samples = samples_off(fault, scene);
  PathLeftOut path = path_left_out(fault, scene);
  // Samples between that all lie on a move say that it was not left out.
  if (path.kind != nullptr && !fault.end && path.corners == 0 && samples.any && samples.count == 0) path.kind = "gap";
  result.off += samples.count;
  result.corners_missed += path.corners;
  result.covered -= path.length;
  if (samples.count > 0) {
    TraceFinding finding = finding_of(samples.farthest, scene);
    finding.kind = fault.begin ? "begin not reached" : samples.on_other_path ? "out of order" : "off the path";
    finding.sample = samples.csv_line;
    finding.samples = samples.count;
    name_moves(finding, samples.move, path.kind == nullptr ? samples.move : path.last);
    findings.add(std::move(finding));
    if (path.kind == nullptr || path.farthest.upper <= samples.farthest.lower) return;
  }
  TraceFinding finding = finding_of(path.farthest, scene);
  finding.kind = path.kind == nullptr ? "out of order" : path.kind;
  if (fault.begin && samples.count == 0) finding.kind = "begin not reached";
  finding.sample = fault.line;
  name_moves(finding, path.first, path.last);
  findings.add(std::move(finding));
}

}  // namespace toolcomp::certify
