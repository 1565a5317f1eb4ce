// SPDX-License-Identifier: Apache-2.0
// Runs both engines in step over a program of any length: one pass, block by block.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "judge/oracle/compare.h"
#include "judge/oracle/control.h"
#include "judge/oracle/pairing.h"
#include "judge/oracle/verdict.h"
#include "model/basis/clause_counts.h"
#include "spec/language/naming_clause.h"

namespace toolcomp::judge::stream {

using exact::Sign;
using spec::EventKind;

// Number of blocks between two new recorders, which bounds the number of kept decisions.
inline constexpr std::uint64_t kBlocksInEpoch = 256;
// The largest number of moves by which one engine may be behind the other, plus the moves needed for the next movement
// (both look-aheads are shorter).
inline constexpr std::size_t kMaxLag = 64;
inline constexpr std::size_t kWindow = 8;
// Number of events held back for the next movement. With more samples than this, the samples of one block fill the
// window.
inline constexpr std::size_t kMostHeld = 20'000;

// A decision of a streamed run: epochs have their own recorders, so indices count from the start of one.
struct Place {
  std::uint64_t epoch = 0;
  std::size_t index = 0;
  friend auto operator<=>(const Place&, const Place&) = default;
};
using Choices = std::map<Place, Sign>;

// Waiting events, consecutive in memory.
template <class Event>
class Waiting {
 public:
  [[nodiscard]] bool empty() const { return first_ == events_.size(); }
  [[nodiscard]] std::size_t size() const { return events_.size() - first_; }
  [[nodiscard]] std::span<const Event> all() const { return std::span(events_).subspan(first_); }
  [[nodiscard]] const Event& front() const { return events_[first_]; }
  [[nodiscard]] const Event& operator[](std::size_t i) const { return events_[first_ + i]; }

  void push_back(const Event& event) {
    // At least half of them have been removed.
    if (first_ >= kGone && first_ >= size()) {
      events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(first_));
      first_ = 0;
    }
    events_.push_back(event);
  }
  void pop_front() { ++first_; }

 private:
  static constexpr std::size_t kGone = 16;
  std::vector<Event> events_;
  std::size_t first_ = 0;
};

struct Expected final : spec::EventSink<model::Real> {
  explicit Expected(const spec::Setup& setup) : positions(setup) {}
  void on(const model::Event& event) override {
    positions.follow(event);
    events.push_back(event);
  }
  Waiting<model::Event> events;
  PositionErrors positions;
};

template <class Number>
struct Actual final : spec::EventSink<Number> {
  void on(const spec::Event<Number>& event) override { events.push_back(event); }
  Waiting<spec::Event<Number>> events;
};

// One pass. Decisions of the current and the previous epoch are kept. `Fast`: the fast engine, or what a controller has
// given; `Number`: double, or exact::Rational of a controller.
template <class Control, class Fast = typename Control::Fast, class Number = double>
class Pass {
 public:
  // `fast` makes the other side from the events of the model and the place for its own events. `agreed` is called with
  // every event that agreed.
  template <class MakeFast>
  Pass(Rules rules, const spec::Setup& setup, std::uint32_t samples, const Choices& choices, const MakeFast& fast,
       std::function<void(const model::Event&)> agreed = {})
      : rules_(std::move(rules)),
        pairing_(rules_, setup, &facts_),
        choices_(choices),
        per_move_(std::max<std::size_t>(samples, 1)),
        expected_(setup),
        model_(Control::model(setup, recorder_, expected_, samples)),
        fast_(fast(expected_, actual_)),
        agreed_(std::move(agreed)) {
    begin_epoch();
  }
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;

  // Whether further blocks change nothing.
  [[nodiscard]] bool over() const { return done() || (model_.stopped() && fast_.stopped()); }

  void block(const typename Control::Block& block) {
    if (blocks_ != 0 && blocks_ % kBlocksInEpoch == 0) next_epoch(block.line);
    facts_.read(block);
    if (!verdict_.beyond) verdict_.beyond = beyond_of(block, compared_);
    if (facts_.units()) rules_.units(*facts_.units());
    model_.block(block);
    fast_.block(block);
    ++blocks_;
    compare_pairs(std::min(kWindow * per_move_, kMostHeld));
  }
  // Ends the pass and returns the verdict.
  Verdict end() {
    if (!done()) {
      model_.end();
      fast_.end();
      compare_pairs(0);
      leftovers();
    }
    if (previous_) count(*previous_);
    count(recorder_);
    take(verdict_, tally_);
    if (verdict_.difference)
      verdict_.outcome = Outcome::differs;
    else if (undecided_)
      verdict_.outcome = Outcome::undecided, verdict_.undecided = "the model could not decide this program";
    else
      verdict_.outcome = tally_.values > 0 ? Outcome::agrees : Outcome::nothing_judged;
    return verdict_;
  }

  // The near ties of the kept epochs, with the outcomes that were taken, the latest first.
  [[nodiscard]] std::vector<std::pair<Place, Sign>> near_ties() const {
    std::vector<std::pair<Place, Sign>> result;
    collect(recorder_, epoch_, result);
    if (previous_) collect(*previous_, epoch_ - 1, result);
    return result;
  }
  [[nodiscard]] std::size_t events() const { return compared_; }
  // How often each clause was reached. To be called after the end.
  [[nodiscard]] const std::vector<model::ClauseCount>& clauses() const { return clauses_; }

 private:
  [[nodiscard]] bool done() const { return verdict_.difference || undecided_; }

  // An epoch ends before the block of this line. Decisions of the epoch that ended may be about lines held from the
  // epoch before it, so the positions of those lines are kept.
  void next_epoch(std::uint64_t line) {
    // Now all events of the epoch before have been given, and with them the positions on which its decisions rest.
    if (previous_) count(*previous_);
    previous_ = std::move(recorder_);
    recorder_ = model::Recorder(true);
    ++epoch_;
    expected_.positions.forget_before(starts_.first);
    starts_ = {starts_.second, line};
    begin_epoch();
  }

  void begin_epoch() {
    for (auto it = choices_.lower_bound({epoch_, 0}); it != choices_.end() && it->first.epoch == epoch_; ++it)
      recorder_.force(it->first.index, it->second);
  }

  void count(const model::Recorder& recorder) {
    model::add(clauses_, recorder.counts());
    verdict_.decisions += recorder.decision_count();
    for (const model::Decision& d : recorder.decisions())
      if (rules_.is_near_tie(d, policy::kDoubleBand, expected_.positions)) ++verdict_.near_ties;
  }

  void collect(const model::Recorder& recorder, std::uint64_t epoch,
               std::vector<std::pair<Place, Sign>>& result) const {
    const auto& decisions = recorder.decisions();
    for (std::size_t i = decisions.size(); i-- > 0;)
      if (!choices_.contains({epoch, i}) && rules_.is_near_tie(decisions[i], policy::kDoubleBand, expected_.positions))
        result.emplace_back(Place{epoch, i}, decisions[i].outcome);
  }

  // Compares while both sides have an event and the model's next `window` events are known.
  void compare_pairs(std::size_t window) {
    while (!done() && !expected_.events.empty() && !actual_.events.empty() && expected_.events.size() > window) {
      // It is not known what a controller does if a case is left open.
      const bool known = std::is_same_v<Number, double> && left_open(expected_.events.front());
      if (expected_.events.front().kind == EventKind::undecided && !known) {
        undecided_ = true;
        return;
      }
      // If an event that is left out differs, the run is judged with all events in memory.
      const bool left_out = rules_.leaves_out(expected_.events.front());
      Tally unused;
      verdict_.difference = pairing_.next(look_ahead(), actual_.events.front(), left_out ? unused : tally_);
      if (left_out) leave_out(rules_, expected_.events.front(), tally_);
      if (verdict_.difference) {
        verdict_.difference->event = compared_;
        return;
      }
      ++compared_;
      if (agreed_) agreed_(expected_.events.front());
      expected_.events.pop_front();
      actual_.events.pop_front();
    }
    if (done()) return;
    if (expected_.events.size() > actual_.events.size() + kMaxLag * per_move_ ||
        actual_.events.size() > expected_.events.size() + kMaxLag * per_move_)
      leftovers();
  }

  // The event to compare and the moves after it. Samples in between give no information about the next movement.
  std::span<const model::Event> look_ahead() {
    const std::span<const model::Event> events = expected_.events.all();
    const auto next = events.first(std::min(kWindow, events.size()));
    const auto is_sample = [](const model::Event& event) { return event.kind == EventKind::sample; };
    if (std::none_of(next.begin() + 1, next.end(), is_sample)) return next;
    window_.assign(1, events.front());
    for (std::size_t i = 1; i < events.size() && window_.size() < kWindow; ++i)
      if (!is_sample(events[i])) window_.push_back(events[i]);
    return window_;
  }

  void leftovers() {
    if (done() || (expected_.events.empty() && actual_.events.empty())) return;
    const bool extra = expected_.events.size() < actual_.events.size();
    const auto unsettled = [](const model::Event& e) { return e.kind == EventKind::undecided && !left_open(e); };
    if (!extra && unsettled(expected_.events[actual_.events.size()])) {
      undecided_ = true;
      return;
    }
    Difference d;
    d.event = compared_;
    d.kind = extra ? "extra event" : "missing event";
    d.field = "event";
    if (extra) {
      const spec::Event<Number>& event = actual_.events[expected_.events.size()];
      d.line = event.line;
      d.expected = "no more events";
      d.actual = describe(event);
    } else {
      const model::Event& event = expected_.events[actual_.events.size()];
      d.line = event.line;
      d.clauses = event.clauses;
      d.clause = spec::naming_clause(event.clauses);
      d.expected = describe(event);
      d.actual = "no more events";
    }
    verdict_.difference = d;
  }

  Rules rules_;
  ProgramFacts facts_;
  Pairing<Number> pairing_;
  const Choices& choices_;
  std::uint64_t blocks_ = 0;
  std::size_t per_move_;  // events of a move with its samples
  model::Recorder recorder_{true};
  std::optional<model::Recorder> previous_;
  std::uint64_t epoch_ = 0;
  std::pair<std::uint64_t, std::uint64_t> starts_;  // first lines of the epoch before and of this one
  Expected expected_;
  Actual<Number> actual_;
  typename Control::Model model_;
  Fast fast_;
  std::function<void(const model::Event&)> agreed_;
  std::vector<model::Event> window_;
  Tally tally_;
  std::vector<model::ClauseCount> clauses_{spec::kClauseCount};  // of all recorders so far
  std::size_t compared_ = 0;
  bool undecided_ = false;
  Verdict verdict_;
};

}  // namespace toolcomp::judge::stream
