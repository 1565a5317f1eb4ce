#include "certify/trace/findings.h"

#include <algorithm>
#include <utility>

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
  if (kept.size() < most_) kept.push_back(std::move(finding));
}

void Findings::sort() { std::ranges::stable_sort(result_.findings, {}, &TraceFinding::sample); }

}  // namespace toolcomp::certify
