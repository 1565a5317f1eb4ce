// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/run.h"

#include <algorithm>

namespace toolcomp::certify {

void Run::add(const Sample& sample) {
  if (full()) thin();
  samples_.push_back({sample, 1, {}});
}

void Run::clear() {
  samples_.clear();
  error_ = {};
}

void Run::drop_before(std::uint64_t number) {
  const auto behind = [](std::uint64_t limit, const RunSample& s) { return limit < s.sample.number; };
  const auto keep = std::upper_bound(samples_.begin(), samples_.end(), number, behind);
  // The last one that is not behind it stays.
  if (keep - samples_.begin() <= 1) return;
  const std::size_t first = approach(static_cast<std::size_t>(keep - 1 - samples_.begin()));
  samples_.erase(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(first));
}

std::size_t Run::approach(std::size_t index) const {
  std::size_t first = index;
  for (double length = 0; first > 0 && index - first < kApproachSamples; --first) {
    length += metric_.in_tolerances(metric_.between(samples_[first - 1].sample.at, samples_[first].sample.at));
    if (length > kApproach) break;
  }
  return first;
}

// Of the line from the sample before to the one behind.
Distance Run::error_without(std::size_t index) const {
  const RunSample& a = samples_[index - 1];
  const RunSample& b = samples_[index];
  const AxisPoint& end = samples_[index + 1].sample.at;
  const AxisPoint& p = b.sample.at;
  const Distance d = metric_.at(a.sample.at, end, metric_.closest(a.sample.at, end, p, {}), p);
  return {std::max(a.error.linear, b.error.linear) + d.linear, std::max(a.error.rotary, b.error.rotary) + d.rotary};
}

void Run::thin() {
  // Every second one may go: their neighbours stay.
  std::vector<Distance> error_of_kept;
  std::vector<double> errors;
  for (std::size_t i = 1; i + 1 < samples_.size(); i += 2) {
    error_of_kept.push_back(error_without(i));
    errors.push_back(metric_.in_tolerances(error_of_kept.back()));
  }
  std::vector<double> sorted = errors;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  error_ = {};
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (i % 2 == 1 && i + 1 < samples_.size() && errors[i / 2] <= *middle) {
      samples_[kept - 1].stands_for += samples_[i].stands_for;
      samples_[kept - 1].error = error_of_kept[i / 2];
    } else {
      samples_[kept++] = samples_[i];
    }
    const Distance& error = samples_[kept - 1].error;
    error_ = {std::max(error_.linear, error.linear), std::max(error_.rotary, error.rotary)};
  }
  samples_.resize(kept);
}

std::pair<std::size_t, std::size_t> Run::between(std::uint64_t from, std::uint64_t to) const {
  const auto before = [](std::uint64_t number, const RunSample& s) { return number < s.sample.number; };
  const auto first = std::upper_bound(samples_.begin(), samples_.end(), from, before);
  const auto last = std::upper_bound(samples_.begin(), samples_.end(), to == 0 ? 0 : to - 1, before);
  const auto index = [&](auto place) { return static_cast<std::size_t>(place - samples_.begin()); };
  const std::size_t begin = first == samples_.begin() ? 0 : index(first) - 1;
  return {begin, std::clamp(to == 0 ? 0 : index(last), begin, samples_.size() - 1)};
}

RunDistance::RunDistance(const Run& run, const Metric& metric, std::size_t first, std::size_t last)
    : run_(run), metric_(metric), first_(first), last_(last), near_(first), boxes_(first) {
  for (std::size_t line = first_; line <= last_; ++line) boxes_.add(run_.samples()[line].sample.at, end_of(line));
}

// The last "line" is the last sample by itself.
const AxisPoint& RunDistance::end_of(std::size_t line) const {
  return run_.samples()[std::min(line + 1, last_)].sample.at;
}

double RunDistance::from(const AxisPoint& p, std::size_t line) const {
  const AxisPoint& a = run_.samples()[line].sample.at;
  const AxisPoint& b = end_of(line);
  return metric_.in_tolerances(metric_.at(a, b, metric_.closest(a, b, p, {}), p));
}

RunDistance::Nearest RunDistance::nearest(const AxisPoint& p) {
  Nearest best;
  best.line = near_;
  best.in_tolerances = from(p, near_);
  boxes_.visit(
      first_, last_ + 1,
      [&](const AxisBox& box) { return metric_.in_tolerances(metric_.outside(box, p)) >= best.in_tolerances; },
      [&](std::size_t line) {
        if (metric_.at_least(run_.samples()[line].sample.at, end_of(line), p, {}) >= best.in_tolerances) return;
        const double d = from(p, line);
        if (d >= best.in_tolerances) return;
        best.line = line;
        best.in_tolerances = d;
      });
  near_ = best.line;
  const AxisPoint& a = run_.samples()[best.line].sample.at;
  const AxisPoint& b = end_of(best.line);
  const double t = metric_.closest(a, b, p, {});
  best.at = point_at(a, b, t);
  best.distance = metric_.at(a, b, t, p);
  return best;
}

}  // namespace toolcomp::certify
