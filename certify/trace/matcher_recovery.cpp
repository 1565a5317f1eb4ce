// SPDX-License-Identifier: Apache-2.0
// How a match that was lost is found again.
#include "certify/trace/matcher.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "certify/sort_by.h"

namespace toolcomp::certify {
namespace {

bool joins(const Reach& group, const Reached& next) {
  return !group.empty() && group.back().piece + 1 == next.piece && group.back().high >= 1 && next.low <= 0;
}

// Calls `each(group)` for what hangs together.
template <class Each>
void for_each_group(const Reach& reach, Each each) {
  Reach group;
  for (const Reached& next : reach) {
    if (!group.empty() && !joins(group, next)) {
      each(group);
      group.clear();
    }
    group.push_back(next);
  }
  if (!group.empty()) each(group);
}

bool overlap(const Reach& a, const Reach& b) {
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() && j != b.end()) {
    if (i->piece == j->piece && i->low <= j->high && j->low <= i->high) return true;
    (std::pair(i->piece, i->high) < std::pair(j->piece, j->high) ? i : j)++;
  }
  return false;
}

}  // namespace

void Matcher::recover(const std::vector<Hypothesis>& lost, const Sample& sample) {
  if (run_.empty() && !lost.empty())
    for (const auto& [before, recorded] : approach_) run_.add(before);
  if (run_.full()) decide_oldest();
  run_.add(sample);
  std::vector<Hypothesis> candidates;
  if (!lost.empty()) {
    const std::size_t before = left_.size();
    for (const Hypothesis& hypothesis : lost) leave(hypothesis, sample.line);
    path_.has(first_needed() + kWindow);
    // While the recording stood where it was matched last, path may have been left out.
    for (Hypothesis& hypothesis : come_back(last_, std::min(before, left_.size()), recorded_before_)) {
      free_.advance(hypothesis.reach, last_, sample, ahead_);
      if (ahead_.empty()) continue;
      hypothesis.reach = ahead_;
      measure(hypothesis, sample);
      candidates.push_back(std::move(hypothesis));
    }
  }
  if (!left_.empty()) path_.has(first_needed() + kWindow);
  for (Hypothesis& hypothesis : come_back(sample, 0, recorded_)) {
    measure(hypothesis, sample);
    candidates.push_back(std::move(hypothesis));
  }
  const std::size_t off = left_.size();
  leave_free_moves(sample);
  for (Hypothesis& hypothesis : come_back(sample, off, recorded_)) {
    measure(hypothesis, sample);
    candidates.push_back(std::move(hypothesis));
  }
  left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(off), left_.end());
  keep(std::move(candidates));
  prune();
  if (hypotheses_.empty()) move_on(sample);
  settle();
}

void Matcher::move_on(const Sample& sample) {
  const auto cost = [&](const Left& left) { return left.history.cost + recorded_ - left.recorded; };
  Left left = *std::ranges::min_element(left_, {}, cost);
  if (!path_.has(first_needed() + kWindow)) return;
  const PathPlace quarter{left.high.piece + kWindow / 4, 0};
  const double length = path_.length_to(quarter) - path_.length_to(left.high);
  if (recorded_ - left.recorded < (left.continued ? 1 : 2) * length) return;
  report_all(left.history);
  LostMatch fault;
  fault.begin = left.begin;
  fault.cut = true;
  fault.continued = left.continued;
  fault.from = left.sample;
  fault.to = sample.number + 1;
  fault.line = left.line;
  fault.left_low = left.low;
  fault.left_high = left.high;
  fault.back_low = quarter;
  fault.back_high = {path_.end() - 1, 1};
  report(fault, scene_, result_, findings_);
  run_.clear();
  run_.add(sample);
  left.history.faults.clear();
  left.history.cost = kFault;
  left.sample = sample.number;
  left.line = sample.line;
  left.begin = false;
  left.low = left.high = quarter;
  left.recorded = recorded_;
  left.continued = true;
  left_ = {left};
}

// Those inside a move that is not judged, as if they had left the path where they came closest to its end.
void Matcher::leave_free_moves(const Sample& sample) {
  for (Hypothesis& hypothesis : hypotheses_) {
    if (!in_free_move(hypothesis)) continue;
    const PathPlace end{hypothesis.reach.back().piece, 1};
    const double distance = metric_.in_tolerances(metric_.between(path_.point(end), sample.at));
    if (hypothesis.free_piece != end.piece || distance < hypothesis.closest) {
      hypothesis.free_piece = end.piece;
      hypothesis.closest = distance;
      hypothesis.closest_after = recorded_;
      hypothesis.closest_sample = sample.number;
    }
    Left left{hypothesis.history, hypothesis.closest_sample, sample.line, false, end, end, hypothesis.closest_after};
    left.history.cost += kFault;
    left_.push_back(std::move(left));
  }
  if (!left_.empty()) path_.has(first_needed() + kWindow);
}

void Matcher::leave(const Hypothesis& lost, std::uint64_t noticed) {
  for_each_group(lost.reach, [&](const Reach& group) {
    Left left{lost.history, last_.number, noticed, false, first_of(group), last_of(group), recorded_before_};
    left.history.cost += kFault;
    // What another one costs where this one stands.
    const auto cost = [&](const Left& other, const PathPlace& at) {
      return other.history.cost + recorded_before_ - other.recorded +
             std::max(0.0, path_.length_to(at) - path_.length_to(other.high));
    };
    const bool dominated = std::ranges::any_of(
        left_, [&](const Left& other) { return other.low <= left.low && cost(other, left.high) <= left.history.cost; });
    if (!dominated) left_.push_back(std::move(left));
  });
}

std::vector<Matcher::Hypothesis> Matcher::come_back(const Sample& sample, std::size_t first_left,
                                                    double recorded) const {
  std::vector<Hypothesis> back;
  if (first_left >= left_.size()) return back;
  PathPlace from = left_[first_left].low;
  for (std::size_t i = first_left; i < left_.size(); ++i) from = std::min(from, left_[i].low);
  // Farther ahead they would be too dear.
  double reach = path_.length_to(from);
  const double most = most_cost();
  for (std::size_t i = first_left; i < left_.size(); ++i) {
    const Left& left = left_[i];
    const double most_left_out = most - (left.history.cost + recorded - left.recorded);
    reach = std::max(reach, path_.length_to(left.high) + most_left_out);
  }
  Reach near;
  path_.near(from.piece, path_.first_beyond(reach), sample.at, [&](std::size_t piece, const Part& part) {
    const double low = piece == from.piece ? std::max(part.low, from.at) : part.low;
    if (low <= part.high) near.push_back({piece, low, part.high});
  });
  for_each_group(near, [&](const Reach& group) { back.push_back(come_back_to(group, sample, first_left, recorded)); });
  std::erase_if(back, [](const Hypothesis& hypothesis) { return hypothesis.reach.empty(); });
  return back;
}

Matcher::Hypothesis Matcher::come_back_to(const Reach& group, const Sample& sample, std::size_t first_left,
                                          double recorded) const {
  const Left* cheapest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = first_left; i < left_.size(); ++i) {
    const Left& left = left_[i];
    if (left.low > last_of(group)) continue;
    const PathPlace at = std::max(first_of(group), left.low);
    const double cost =
        left.history.cost + recorded - left.recorded + std::max(0.0, path_.length_to(at) - path_.length_to(left.high));
    if (cost >= least) continue;
    least = cost;
    cheapest = &left;
  }
  Hypothesis back;
  if (cheapest == nullptr) return back;
  for (const Reached& reached : group) {
    if (reached.piece < cheapest->low.piece) continue;
    Reached behind = reached;
    if (behind.piece == cheapest->low.piece) behind.low = std::max(behind.low, cheapest->low.at);
    if (behind.low <= behind.high) back.reach.push_back(behind);
  }
  if (back.reach.empty()) return back;
  back.history = cheapest->history;
  back.history.cost = least;
  LostMatch fault;
  fault.begin = cheapest->begin;
  fault.continued = cheapest->continued;
  fault.from = cheapest->sample;
  fault.to = sample.number;
  fault.line = cheapest->line;
  fault.left_low = cheapest->low;
  fault.left_high = cheapest->high;
  fault.back_low = first_of(back.reach);
  fault.back_high = last_of(back.reach);
  fault.cost = least - cheapest->history.cost + kFault;
  back.history.faults.push_back(std::make_shared<const LostMatch>(fault));
  return back;
}

bool Matcher::is_dominated(const std::vector<Hypothesis>& by, const Hypothesis& hypothesis) const {
  const PathPlace begin = first_of(hypothesis.reach);
  return std::ranges::any_of(by, [&](const Hypothesis& other) {
    if (other.history.cost > hypothesis.history.cost) return false;
    if (overlap(other.reach, hypothesis.reach)) return true;
    const PathPlace end = last_of(other.reach);
    return end <= begin &&
           other.history.cost + kFault + path_.length_to(begin) - path_.length_to(end) <= hypothesis.history.cost;
  });
}

void Matcher::keep(std::vector<Hypothesis> candidates) {
  for (Hypothesis& candidate : candidates) hypotheses_.push_back(std::move(candidate));
  sort_by(hypotheses_, [](const Hypothesis& h) { return h.history.cost; });
  std::vector<Hypothesis> kept;
  for (Hypothesis& hypothesis : hypotheses_)
    if (kept.size() < kHypotheses && !is_dominated(kept, hypothesis)) kept.push_back(std::move(hypothesis));
  hypotheses_ = std::move(kept);
}

// Of those worth following: twice the cheapest that is on a judged piece, and a constant.
double Matcher::most_cost() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Hypothesis& hypothesis : hypotheses_)
    if (!in_free_move(hypothesis)) least = std::min(least, hypothesis.history.cost);
  return 2 * least + kFault;
}

void Matcher::prune() {
  const auto cost = [&](const Left& left) { return left.history.cost + recorded_ - left.recorded; };
  const double most = most_cost();
  std::erase_if(hypotheses_, [&](const Hypothesis& h) { return h.history.cost > most; });
  std::erase_if(left_, [&](const Left& left) { return cost(left) > most; });
  if (left_.size() > kHypotheses) {
    sort_by(left_, cost);
    left_.resize(kHypotheses);
  }
}

void Matcher::settle() {
  if (path_.end() - first_needed() > kWindow + kBehind) take_cheapest();
  report_common();
  if (!following()) return;
  History& history = hypotheses_.front().history;
  report_all(history);
  history.faults.clear();
  history.cost = 0;
  run_.clear();
}

void Matcher::take_cheapest() {
  if (hypotheses_.empty()) return;
  hypotheses_.resize(1);
  left_.clear();
}

std::vector<Matcher::History*> Matcher::histories() {
  std::vector<History*> all;
  all.reserve(hypotheses_.size() + left_.size());
  for (Hypothesis& hypothesis : hypotheses_) all.push_back(&hypothesis.history);
  for (Left& left : left_) all.push_back(&left.history);
  return all;
}

// Nothing that is followed has other faults first than the cheapest.
void Matcher::decide_oldest() {
  const auto cost = [&](const Left& left) { return left.history.cost + recorded_ - left.recorded; };
  const History* cheapest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Hypothesis& h : hypotheses_)
    if (h.history.cost < least) cheapest = &h.history, least = h.history.cost;
  for (const Left& left : left_)
    if (cost(left) < least) cheapest = &left.history, least = cost(left);
  if (cheapest == nullptr || cheapest->faults.empty()) return;
  const auto fault = cheapest->faults.front();
  const auto other = [&](const auto& h) { return h.history.faults.empty() || h.history.faults.front() != fault; };
  std::erase_if(hypotheses_, other);
  std::erase_if(left_, other);
  report_common();
}

// Faults that all that is followed has in common.
void Matcher::report_common() {
  const std::vector<History*> all = histories();
  bool any = false;
  while (!all.empty() && !all.front()->faults.empty()) {
    const auto fault = all.front()->faults.front();
    const auto has_it = [&](const History* h) { return !h->faults.empty() && h->faults.front() == fault; };
    if (!std::ranges::all_of(all, has_it)) break;
    report(*fault, scene_, result_, findings_);
    any = true;
    for (History* history : all) {
      history->faults.erase(history->faults.begin());
      history->cost -= fault->cost;
    }
  }
  if (!any) return;
  std::uint64_t needed = last_.number;
  for (const History* history : all)
    if (!history->faults.empty()) needed = std::min(needed, history->faults.front()->from);
  for (const Left& left : left_) needed = std::min(needed, left.sample);
  run_.drop_before(needed);
}

void Matcher::report_all(const History& history) {
  for (const auto& fault : history.faults) report(*fault, scene_, result_, findings_);
}

}  // namespace toolcomp::certify
