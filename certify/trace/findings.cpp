// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/findings.h"

#include <algorithm>
#include <utility>

#include "certify/sort_by.h"

namespace toolcomp::certify {

void Findings::add(TraceFinding finding) {
  std::vector<TraceFinding>& kept = result_.findings;
  if (finding.kind == "gap") {
    const auto same = std::ranges::find_if(
        kept, [&](const TraceFinding& f) { return f.kind == "gap" && f.sample == finding.sample; });
    if (same != kept.end()) {
      // The one that measured the path says where; the time says how long.
      const double duration = std::max(same->duration, finding.duration);
      if (finding.duration == 0) *same = std::move(finding);
      same->duration = duration;
      return;
    }
  }
  ++result_.findings_total;
  const bool keep = kept.size() < most_;
  if (finding.samples > 0) run_ = keep ? std::optional(kept.size()) : std::nullopt;
  if (keep) kept.push_back(std::move(finding));
}

void Findings::extend(const TraceFinding& more) {
  if (!run_) return;
  TraceFinding& run = result_.findings[*run_];
  run.samples += more.samples;
  run.last_line = more.last_line;
  run.last_n = more.last_n;
  if (run.kind != more.kind) run.kind = "off the path";
  if (std::max(more.distance.upper, more.rotary.upper) <= std::max(run.distance.upper, run.rotary.upper)) return;
  run.distance = more.distance;
  run.rotary = more.rotary;
  run.rotary_axis = more.rotary_axis;
  run.at = more.at;
  run.worst_sample = more.worst_sample;
}

void Findings::sort() { sort_by(result_.findings, &TraceFinding::sample); }

}  // namespace toolcomp::certify
