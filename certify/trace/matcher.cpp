// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/matcher.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace toolcomp::certify {
namespace {

void widen(Bounds& worst, std::uint64_t& line, double distance, double error, std::uint64_t sample) {
  if (distance + error > worst.upper || line == 0) line = sample;
  worst = {std::max(worst.lower, distance - error), std::max(worst.upper, distance + error)};
}

}  // namespace

Matcher::Matcher(PathSource& path, const Metric& metric, const spec::Axes& axes, TraceResult& result,
                 Findings& findings)
    : metric_(metric),
      path_(path, metric),
      free_(path_, metric),
      run_(metric),
      scene_{path_, run_, metric, axes},
      result_(result),
      findings_(findings) {}

void Matcher::take(const AxisPoint& at, std::uint64_t line) {
  const Sample sample{at, metric_.magnitude(at), samples_++, line};
  ++result_.samples;
  if (!path_.has(0)) return;
  if (sample.number == 0) {
    counted_ = at;
    begin(sample);
  } else {
    const double step = metric_.in_tolerances(metric_.between(counted_, at));
    recorded_before_ = recorded_;
    if (step > 1) {
      recorded_ += step;
      counted_ = at;
    }
    advance(sample);
  }
  last_ = sample;
  keep_approach(sample);
  drop_behind();
}

void Matcher::keep_approach(const Sample& sample) {
  approach_.emplace_back(sample, recorded_);
  while (approach_.size() > Run::kApproachSamples || recorded_ - approach_.front().second > Run::kApproach)
    approach_.pop_front();
}

void Matcher::begin(const Sample& sample) {
  Hypothesis first;
  first.reach = free_.begin(sample, kWindow);
  if (!first.reach.empty()) {
    leave_uncovered(first_of(first.reach));
    measure(first, sample);
    hypotheses_.push_back(std::move(first));
    return;
  }
  Left left;
  left.history.cost = kFault;
  left.line = sample.line;
  left.begin = true;
  while (left.high.piece + 1 < kWindow && path_.has(left.high.piece + 1) &&
         (!path_[left.high.piece].piece.corner || path_[left.high.piece].piece.jump))
    ++left.high.piece;
  left.high.at = 1;
  leave_uncovered(left.high);
  left_.push_back(std::move(left));
  recover({}, sample);
}

void Matcher::advance(const Sample& sample) {
  std::vector<Hypothesis> lost;
  for (std::size_t i = 0; i < hypotheses_.size();) {
    Hypothesis& hypothesis = hypotheses_[i];
    free_.advance(hypothesis.reach, last_, sample, ahead_);
    if (ahead_.empty()) {
      lost.push_back(std::move(hypothesis));
      hypotheses_.erase(hypotheses_.begin() + static_cast<std::ptrdiff_t>(i));
      continue;
    }
    std::swap(hypothesis.reach, ahead_);
    // It may have stayed inside a move that is not judged, or have left the path behind that.
    if (in_free_move(hypothesis)) {
      const auto free = [&](const Reached& r) { return path_[r.piece].piece.free; };
      std::erase_if(ahead_, free);
      if (!ahead_.empty()) {
        Hypothesis& left = lost.emplace_back();
        left.history = hypothesis.history;
        left.reach = ahead_;
      }
    }
    measure(hypothesis, sample);
    ++i;
  }
  if (!following()) recover(lost, sample);
}

bool Matcher::in_free_move(const Hypothesis& hypothesis) const {
  return std::ranges::all_of(hypothesis.reach, [&](const Reached& r) { return path_[r.piece].piece.free; });
}

std::size_t Matcher::first_needed() const {
  std::size_t first = path_.end();
  const auto need = [&](std::size_t piece, const History& history) {
    first = std::min(first, piece);
    for (const auto& fault : history.faults) first = std::min(first, fault->left_low.piece);
  };
  for (const Hypothesis& hypothesis : hypotheses_) need(hypothesis.reach.front().piece, hypothesis.history);
  for (const Left& left : left_) need(left.low.piece, left.history);
  return first;
}

void Matcher::drop_behind() {
  if (path_.end() - path_.first() <= kBehind) return;
  const std::size_t first = first_needed();
  if (first > path_.first() + kBehind) path_.drop_before(first - kBehind);
}

void Matcher::measure(Hypothesis& hypothesis, const Sample& sample) const {
  hypothesis.nearest = nearest_of(hypothesis.reach, path_, metric_, sample.at);
  if (!hypothesis.nearest) return;
  const Distance& nearest = hypothesis.nearest->distance;
  const Distance& error = path_[hypothesis.nearest->place.piece].piece.error;
  Accepted& accepted = hypothesis.history.accepted;
  widen(accepted.linear, accepted.linear_line, nearest.linear, error.linear, sample.line);
  widen(accepted.rotary, accepted.rotary_line, nearest.rotary, error.rotary, sample.line);
}

void Matcher::leave_uncovered(const PathPlace& until) {
  for (std::size_t piece = path_.first(); piece < until.piece; ++piece) result_.covered -= path_.linear_length(piece);
  result_.covered -= until.at * path_.linear_length(until.piece);
}

PlaceOnPath Matcher::place(bool also_left) const {
  std::optional<NearestReached> nearest;
  PlaceOnPath place;
  if (!hypotheses_.empty()) {
    nearest = std::ranges::min_element(hypotheses_, {}, [](const Hypothesis& h) { return h.history.cost; })->nearest;
    place.kind = nearest ? SampleKind::followed : SampleKind::not_judged;
  } else if (also_left && !left_.empty()) {
    constexpr std::size_t kNear = 256;
    Reach behind;
    for (std::size_t i = left_.front().low.piece; behind.size() < kNear && i < path_.end(); ++i)
      behind.push_back({i, 0, 1});
    nearest = nearest_of(behind, path_, metric_, last_.at);
  }
  if (!nearest) return place;
  const PathPiece& piece = path_[nearest->place.piece].piece;
  place.exact = path_.point(nearest->place);
  place.distance = nearest->distance;
  place.line = piece.line;
  place.n = piece.n;
  return place;
}

MoveName Matcher::move() const {
  if (path_.end() == 0 || (hypotheses_.empty() && left_.empty())) return {};
  const std::size_t at = hypotheses_.empty() ? left_.front().low.piece : hypotheses_.front().reach.front().piece;
  const PathPiece& piece = path_[at].piece;
  return {piece.line, piece.n};
}

void Matcher::end() {
  if (samples_ > 0 && path_.has(0)) {
    const auto done = [&](const Hypothesis& h) { return free_.at_end(h.reach); };
    // The rest of the path, which is only known if anything is at its end; else it is the same for all.
    const double whole = std::ranges::any_of(hypotheses_, done) ? path_.length_to({path_.end() - 1, 1}) : 0;
    const History none;
    const History* best = &none;
    LostMatch rest;
    double least = std::numeric_limits<double>::infinity();
    for (const Hypothesis& h : hypotheses_) {
      const bool at_end = done(h);
      const double cost = h.history.cost + (at_end ? 0 : kFault + whole - path_.length_to(last_of(h.reach)));
      if (cost >= least) continue;
      least = cost;
      best = &h.history;
      rest = {};
      rest.end = !at_end;
      rest.from = last_.number;
      rest.line = last_.line;
      rest.left_low = first_of(h.reach);
      rest.left_high = last_of(h.reach);
    }
    for (const Left& left : left_) {
      const double cost = left.history.cost + recorded_ - left.recorded + whole - path_.length_to(left.high);
      if (cost >= least) continue;
      least = cost;
      best = &left.history;
      rest = {};
      rest.begin = left.begin;
      rest.end = true;
      rest.continued = left.continued;
      rest.from = left.sample;
      rest.line = left.line;
      rest.left_low = left.low;
      rest.left_high = left.high;
    }
    // No alignment has a cost that is a number: nothing is known to follow the path.
    if (!std::isfinite(least)) rest.end = true;
    rest.to = last_.number;
    report_all(*best);
    if (run_.empty()) run_.add(last_);
    if (rest.end) report(rest, scene_, result_, findings_);
    finish(*best);
  }
  while (path_.has(path_.end())) path_.drop_before(path_.end() - 1);
  result_.corners = path_.corners();
  result_.not_judged_moves = path_.free_moves();
  result_.length = path_.fetched_length();
  result_.covered = samples_ == 0 ? 0 : std::max(0.0, result_.covered + result_.length);
}

void Matcher::finish(const History& history) {
  const Accepted& accepted = history.accepted;
  result_.worst = {std::max(0.0, accepted.linear.lower), accepted.linear.upper};
  result_.worst_sample = accepted.linear_line;
  result_.worst_rotary = {std::max(0.0, accepted.rotary.lower), accepted.rotary.upper};
  result_.worst_rotary_sample = accepted.rotary_line;
}

}  // namespace toolcomp::certify
