// SPDX-License-Identifier: Apache-2.0
// Verdicts on whole lists of events, with the outcomes the specification permits near ties.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <queue>
#include <set>
#include <type_traits>

#include "judge/oracle/compare.h"
#include "judge/oracle/number.h"
#include "judge/oracle/pairing.h"
#include "judge/oracle/reading.h"
#include "judge/oracle/verdict.h"
#include "spec/language/naming_clause.h"

namespace toolcomp::judge {
namespace {

using exact::Rational;
using exact::Sign;
using spec::Clause;
using spec::EventKind;

// How far one run of the model agrees with the actual events.
struct Agreement {
  std::optional<Difference> difference;
  std::string expected;    // what differs there, and what the run has, also where whole events are named
  bool undecided = false;  // the run itself ends undecided, and everything before agrees
  Tally tally;
  std::vector<Deviation> deviations;  // of rotary positions
};

// Whether two events agree out of their places, without a trace in the tally.
template <class Number>
bool same(const Rules& rules, const spec::Setup& setup, const model::Event& expected,
          const spec::Event<Number>& actual) {
  Tally unused;
  const Scale scale = Conditions(setup).next({&expected, 1});
  return !compare(rules, expected, scale, actual, unused);
}

// A whole event that has no partner: expected[i], or else actual[k]. Clauses are those of the event the model has
// there, or had last.
template <class Number>
Difference unpaired(const std::vector<model::Event>& expected, std::span<const spec::Event<Number>> actual,
                    std::size_t i, std::size_t k, std::string kind) {
  Difference d;
  d.kind = std::move(kind);
  d.field = "event";
  d.expected = i < expected.size() ? describe(expected[i]) : "no more events";
  d.actual = k < actual.size() ? describe(actual[k]) : "no more events";
  d.line = i < expected.size() ? expected[i].line : actual[k].line;
  if (!expected.empty()) {
    d.clauses = expected[std::min(i, expected.size() - 1)].clauses;
    d.clause = spec::naming_clause(d.clauses);
  }
  return d;
}

// The kind of a difference at events i and k as a reader of both lists would put it: an event too few, too many, or
// swapped.
template <class Number>
Difference name_difference(const Rules& rules, const spec::Setup& setup, const std::vector<model::Event>& expected,
                           std::span<const spec::Event<Number>> actual, std::size_t i, std::size_t k,
                           Difference found) {
  const std::size_t left_expected = expected.size() - i;
  const std::size_t left_actual = actual.size() - k;
  const bool more_expected = left_expected > 1;
  const bool more_actual = left_actual > 1;
  if (more_expected && more_actual && same(rules, setup, expected[i], actual[k + 1]) &&
      same(rules, setup, expected[i + 1], actual[k]))
    return unpaired(expected, actual, i, k, "order");
  if (left_expected > left_actual && more_expected && same(rules, setup, expected[i + 1], actual[k]))
    return unpaired(expected, actual, i, k, "missing event");
  if (left_actual > left_expected && more_actual && same(rules, setup, expected[i], actual[k + 1]))
    return unpaired(expected, actual, i, k, "extra event");
  return found;
}

// What differs, and what is expected there: the field, the event, and the point where it leads. Runs that differ in the
// same field, and expect the same of it, may have another event there (a move, where an alarm is given).
std::string wanted_by(const Difference& d, const std::vector<model::Event>& expected, std::size_t i) {
  std::string text = fmt::format("{} {}: {}", d.kind, d.field, d.expected);
  if (i >= expected.size()) return text;
  text += ' ' + describe(expected[i]);
  for (std::size_t axis = 0; axis < spec::kMaxAxes; ++axis)
    if (expected[i].point.has(axis)) text += fmt::format(" {:.6f}", approximate(expected[i].point[axis]));
  return text;
}

// Both lists from their beginnings, pair by pair.
template <class Number>
class Agreeing {
 public:
  // `judged`: how many of the events expected; behind them nothing is.
  Agreeing(const Rules& rules, const spec::Setup& setup, const ProgramFacts& facts,
           const std::vector<model::Event>& expected, std::size_t judged, std::span<const spec::Event<Number>> actual)
      : rules_(rules),
        setup_(setup),
        expected_(expected),
        judged_(judged),
        actual_(actual),
        pairing_(std::make_unique<Pairing<Number>>(rules, setup, &facts)) {}

  Agreement run() {
    for (std::size_t i = 0; i < expected_.size() || (k_ < actual_.size() && !parted_); ++i) {
      if (i == judged_) return std::move(result_);
      const bool open = i < expected_.size() && expected_[i].kind == EventKind::undecided;
      if (open && !left_open(expected_[i])) {
        result_.undecided = true;
        return std::move(result_);
      }
      // What the specification leaves open an engine of ours says too; of a controller nothing is judged behind it, nor
      // the event itself unless it announces what such an event says.
      const bool last = open && !std::is_same_v<Number, double>;
      if (last) {
        if (expected_[i].out_of_scope) result_.tally.out_of_scope = expected_.size() - i - 1;
        if (!rules_.judges_undecided()) return std::move(result_);
      }
      if (i < expected_.size() && (parted_ || rules_.leaves_out(expected_[i])))
        seek(i);
      else
        compare(i);
      if (result_.difference) {
        result_.difference->event = i;
        break;
      }
      if (last) return std::move(result_);
    }
    result_.deviations = pairing_->deviations();
    return std::move(result_);
  }

 private:
  void compare(std::size_t i) {
    if (i >= expected_.size()) {
      result_.difference = unpaired(expected_, actual_, i, k_, "extra event");
    } else if (k_ >= actual_.size()) {
      result_.difference = unpaired(expected_, actual_, i, k_, "missing event");
    } else {
      result_.difference = pairing_->next(std::span(expected_).subspan(i), actual_[k_], result_.tally);
      if (result_.difference) {
        result_.expected = wanted_by(*result_.difference, expected_, i);
        result_.difference = name_difference(rules_, setup_, expected_, actual_, i, k_, *result_.difference);
      }
    }
    if (result_.difference && result_.expected.empty()) result_.expected = wanted_by(*result_.difference, expected_, i);
    ++k_;
  }

  // An event that is left out, or that comes behind such a one in which both have parted. Where the other side has it
  // (only behind a parting it need not be the next), both are together.
  void seek(std::size_t i) {
    const bool left_out = rules_.leaves_out(expected_[i]);
    const std::size_t end = std::min(actual_.size(), k_ + (parted_ ? policy::kMostSought : 1));
    for (std::size_t k = k_; k < end; ++k) {
      if (actual_[k].kind != expected_[i].kind || actual_[k].line != expected_[i].line) continue;
      auto tried = std::make_unique<Pairing<Number>>(*pairing_);
      Tally tally = result_.tally;
      if (tried->next(std::span(expected_).subspan(i), actual_[k], tally)) continue;
      pairing_ = std::move(tried);
      if (left_out)
        leave_out(rules_, expected_[i], result_.tally);
      else
        result_.tally = std::move(tally);
      k_ = k + 1;
      if (expected_[i].kind == EventKind::move || expected_[i].kind == EventKind::alarm) parted_ = false;
      return;
    }
    pairing_->pass(std::span(expected_).subspan(i));
    leave_out(rules_, expected_[i], result_.tally);
    parted_ = true;
  }

  const Rules& rules_;
  const spec::Setup& setup_;
  const std::vector<model::Event>& expected_;
  std::size_t judged_;
  std::span<const spec::Event<Number>> actual_;
  std::unique_ptr<Pairing<Number>> pairing_;
  std::size_t k_ = 0;    // of the next of the other side
  bool parted_ = false;  // in an event that was left out
  Agreement result_;
};

template <class Number>
Agreement agreement(const Rules& rules, const spec::Setup& setup, const ProgramFacts& facts,
                    const std::vector<model::Event>& expected, std::size_t judged,
                    std::span<const spec::Event<Number>> actual) {
  return Agreeing<Number>(rules, setup, facts, expected, judged, actual).run();
}

// The shortest linear movement of the moves next to a decision's line, for the band of a controller.
double shortest_move(const std::vector<model::Event>& events, const spec::Axes& axes, std::uint64_t line) {
  double shortest = 0;
  const model::Event* before = nullptr;
  for (const model::Event& event : events) {
    if (event.kind != EventKind::move) continue;
    if (before != nullptr && event.line + policy::kNeighbourhood >= line &&
        event.line <= line + policy::kNeighbourhood) {
      double square = 0;
      for (std::size_t i = 0; i < axes.size(); ++i)
        if (event.programmed.has(i) && before->programmed.has(i))
          square += std::pow(approximate(event.programmed[i] - before->programmed[i]), 2);
      const double length = std::sqrt(square);
      if (length > 0 && (shortest == 0 || length < shortest)) shortest = length;
    }
    before = &event;
  }
  return shortest;
}

// The model's permitted runs of one case against one list of actual events.
template <class Number>
class Judge {
 public:
  Judge(const spec::Case& c, std::span<const spec::Event<Number>> actual, const JudgeOptions& options)
      : case_(c), facts_(ProgramFacts::of(c)), rules_(c.setup, c.section, options) {
    if (facts_.units()) rules_.units(*facts_.units());
    const auto judged = [this](const spec::Event<Number>& event) { return is_judged(event); };
    std::copy_if(actual.begin(), actual.end(), std::back_inserter(kept_), judged);
    actual_ = kept_;
  }

  Verdict verdict(const ModelRun& run) {
    Verdict v;
    v.decisions = run.recorder.decision_count();
    v.near_ties = near_ties(run, {}).size();
    v.beyond = run.beyond;
    const Agreement first = compared(run);
    if (first.undecided) return undecided(v, first, why(run));
    if (!first.difference) return agrees(v, first);
    return search(v, run, first);
  }

 private:
  // A controller that knows no samples gives none.
  template <class Any>
  [[nodiscard]] bool is_judged(const spec::Event<Any>& event) const {
    return event.kind != EventKind::sample || rules_.judges("t");
  }
  [[nodiscard]] Agreement compared(const ModelRun& run) const {
    // An engine of ours says what it does not have; what a controller does there is not known.
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    const std::size_t certain = run.beyond && !std::is_same_v<Number, double> ? run.beyond->events : kAll;
    if (rules_.judges("t")) return agreement(rules_, case_.setup, facts_, run.events, certain, actual_);
    std::vector<model::Event> expected;
    std::size_t judged = kAll;
    for (std::size_t i = 0; i < run.events.size(); ++i) {
      if (i == certain) judged = expected.size();
      if (is_judged(run.events[i])) expected.push_back(run.events[i]);
    }
    return agreement(rules_, case_.setup, facts_, expected, judged, actual_);
  }

  static std::string why(const ModelRun& run) {
    const model::Event& open = run.events.back();
    return fmt::format("the model could not decide line {} ({})", open.line, open.number.view());
  }

  // Which decision of a run, whatever others come and go before it.
  struct Place {
    Clause clause{};
    std::uint64_t line = 0;
    std::size_t before = 0;  // decisions of this clause and line
    friend auto operator<=>(const Place&, const Place&) = default;
  };

  // A near tie of a run, and the outcome taken.
  struct Tie {
    std::size_t index = 0;
    Place place;
    Sign taken{};
  };

  // A run that differs, and the forced outcomes it came from. The one that agrees longest is followed first.
  struct Node {
    Forced forced;
    std::vector<Place> places;  // of the decisions forced, in their order
    std::size_t event = 0;      // of the first difference
    bool explains = true;       // moves the difference on, or expects something else there
    std::vector<Tie> ties;      // to be tried: asked before that event was given; those closest to it first
    // With the runs it came from: how far they agree, what they expect where they differ, the near ties they asked.
    std::size_t farthest = 0;
    std::set<std::pair<std::size_t, std::string>> expected;
    std::set<Place> asked;
    std::set<Place> brought;  // of them those that its own forced outcome brought up
  };
  struct Later {
    bool operator()(const Node& a, const Node& b) const {
      if (a.event != b.event) return a.event < b.event;
      return a.forced.size() > b.forced.size();
    }
  };

  // Indices of the decisions inside their band.
  std::vector<std::size_t> near_ties(const ModelRun& run, std::span<const Deviation> deviations) const {
    std::vector<std::size_t> result;
    const auto& decisions = run.recorder.decisions();
    PositionErrors positions(case_.setup);
    positions.deviate(deviations);
    for (const model::Event& event : run.events) positions.follow(event);
    for (std::size_t i = 0; i < decisions.size(); ++i) {
      const double band = rules_.rounds()
                              ? policy::controller_band(rules_.resolution(), rules_.angle_resolution(),
                                                        shortest_move(run.events, case_.setup.axes, decisions[i].line))
                              : policy::kDoubleBand;
      if (rules_.is_near_tie(decisions[i], band, positions)) result.push_back(i);
    }
    return result;
  }

  // Decisions a run had taken when it gave the event of the difference: what was asked later has no part in it.
  [[nodiscard]] std::size_t asked_before(const ModelRun& run, std::size_t event) const {
    std::size_t judged = 0;
    for (std::size_t i = 0; i < run.asked.size(); ++i) {
      if (!is_judged(run.events[i])) continue;
      if (judged++ == event) return run.asked[i];
    }
    return run.recorder.decisions().size();
  }

  Node node(const ModelRun& run, Forced forced, const Agreement& at) const {
    Node n;
    n.forced = std::move(forced);
    n.event = n.farthest = at.difference->event;
    n.expected.emplace(n.event, at.expected);
    const auto& all = run.recorder.decisions();
    const std::size_t end = asked_before(run, n.event);
    for (const auto& [index, outcome] : n.forced) n.places.push_back(place(run, index));
    for (const std::size_t i : near_ties(run, at.deviations)) {
      if (i >= end) break;
      const Place p = place(run, i);
      n.asked.insert(p);
      if (!n.forced.contains(i)) n.ties.push_back({i, p, all[i].outcome});
    }
    const auto distance = [&](const Tie& tie) {
      const std::uint64_t line = all[tie.index].line;
      return std::pair(line > at.difference->line ? line - at.difference->line : at.difference->line - line, tie.index);
    };
    std::ranges::sort(n.ties, {}, distance);
    return n;
  }

  static bool same(const model::Decision& a, const Place& b) { return a.clause == b.clause && a.line == b.line; }
  static Place place(const ModelRun& run, std::size_t index) {
    const auto& all = run.recorder.decisions();
    Place p{all[index].clause, all[index].line, 0};
    for (std::size_t i = 0; i < index; ++i) p.before += same(all[i], p) ? 1 : 0;
    return p;
  }
  static std::optional<std::size_t> find(const ModelRun& run, Place p) {
    const auto& all = run.recorder.decisions();
    for (std::size_t i = 0; i < all.size(); ++i)
      if (same(all[i], p) && p.before-- == 0) return i;
    return std::nullopt;
  }

  // The outcomes forced in `parent` and one more. Those behind the new one are looked for where they are made then: it
  // may bring decisions before them, or take some away.
  std::optional<Forced> forced_too(const Node& parent, std::size_t index, Sign outcome) const {
    Forced forced;
    forced[index] = outcome;
    std::size_t i = 0;
    for (const auto& [decision, taken] : parent.forced) {
      const Place& p = parent.places[i++];
      if (decision < index) {
        forced[decision] = taken;
        continue;
      }
      const std::optional<ModelRun> run = permitted(forced);
      if (!run) return std::nullopt;
      if (const auto found = find(*run, p)) forced[*found] = taken;
    }
    return forced;
  }

  // Leaves in a fork the near ties that are worth trying. All of them, where it moves the first difference on, so a
  // chain of decisions that each explain one more event is found, whatever its length; and where it expects another
  // event there than all the runs it came from. Else two decisions may show only together: those that it brought up are
  // tried, what its clause asks behind it in this line, and two that one forced outcome brought up (beside a pole, not
  // in it, its branch and its side are asked). What only changes the event back and forth explains nothing.
  static void follow(Node& child, const Node& parent, const Tie& flipped) {
    const bool on = child.event > parent.farthest;
    const bool another = child.event == parent.farthest && !std::ranges::includes(parent.expected, child.expected);
    child.explains = on || another;
    std::ranges::set_difference(child.asked, parent.asked, std::inserter(child.brought, child.brought.end()));
    if (!child.explains)
      std::erase_if(child.ties, [&](const Tie& tie) {
        const bool together = parent.explains && tie.index > flipped.index && tie.place.line == flipped.place.line &&
                              (tie.place.clause == flipped.place.clause ||
                               (parent.brought.contains(tie.place) && parent.brought.contains(flipped.place)));
        return parent.asked.contains(tie.place) && !together;
      });
    child.farthest = std::max(child.event, parent.farthest);
    child.expected.insert(parent.expected.begin(), parent.expected.end());
    child.asked.insert(parent.asked.begin(), parent.asked.end());
  }

  Verdict search(Verdict v, const ModelRun& run, const Agreement& first) {
    std::priority_queue<Node, std::vector<Node>, Later> open;
    std::set<Forced> seen;
    std::size_t followed = 0;
    std::size_t events = 0;
    open.push(node(run, {}, first));
    while (!open.empty()) {
      const Node parent = open.top();
      open.pop();
      if (parent.explains && followed++ == policy::kMaxForks)
        return undecided(v, first, fmt::format("more than {} combinations of near ties", policy::kMaxForks));
      for (const Tie& tie : parent.ties)
        for (const Sign outcome : {Sign::negative, Sign::zero, Sign::positive}) {
          if (events > policy::kMaxForkedEvents)
            return undecided(
                v, first,
                fmt::format("more than {} events with other outcomes of near ties", policy::kMaxForkedEvents));
          if (outcome == tie.taken) continue;
          std::optional<Forced> forced = forced_too(parent, tie.index, outcome);
          if (!forced || !seen.insert(*forced).second) continue;
          const std::optional<ModelRun> fork = permitted(*forced);
          if (!fork) continue;
          events += fork->events.size();
          const Agreement a = compared(*fork);
          if (a.undecided) continue;
          if (!a.difference) {
            v.ties = forced->size();
            return agrees(v, a);
          }
          Node child = node(*fork, *std::move(forced), a);
          follow(child, parent, tie);
          if (!child.ties.empty()) open.push(std::move(child));
        }
    }
    v.outcome = Outcome::differs;
    v.difference = first.difference;
    take(v, first.tally);
    return v;
  }

  // The forced run, if it yields finite vectors: the model throws where it would divide by zero or find no direction.
  std::optional<ModelRun> permitted(const Forced& forced) const {
    try {
      return run_model(case_, forced);
    } catch (const std::exception&) {
      return std::nullopt;
    }
  }

  static Verdict agrees(Verdict v, const Agreement& a) {
    take(v, a.tally);
    v.outcome = v.values > 0 ? Outcome::agrees : Outcome::nothing_judged;
    return v;
  }
  static Verdict undecided(Verdict v, const Agreement& a, std::string why) {
    take(v, a.tally);
    v.outcome = Outcome::undecided;
    v.difference = a.difference;
    v.undecided = std::move(why);
    return v;
  }

  const spec::Case& case_;
  ProgramFacts facts_;
  Rules rules_;
  std::vector<spec::Event<Number>> kept_;
  std::span<const spec::Event<Number>> actual_;
};

}  // namespace

double margin(const model::Decision& decision) {
  const double scale = std::fabs(approximate(decision.scale));
  const exact::DoubleEnclosure q = decision.quantity.double_enclosure();
  const double least = q.lower > 0 ? q.lower : q.upper < 0 ? -q.upper : 0;
  if (least == 0) return 0;
  return scale > 0 ? least / scale : 1;
}

Verdict judge(const spec::Case& c, const ModelRun& run, std::span<const fast::Event> events,
              const JudgeOptions& options) {
  return Judge<double>(c, events, options).verdict(run);
}

Verdict judge(const spec::Case& c, std::span<const fast::Event> events, const JudgeOptions& options) {
  return judge(c, run_model(c), events, options);
}

Verdict judge(const spec::Case& c, const ModelRun& run, std::span<const spec::TextEvent> events,
              const JudgeOptions& options) {
  const Rules rules(c.setup, c.section, options);
  Reading reading(c.setup.axes, rules);
  std::vector<spec::Event<Rational>> actual;
  actual.reserve(events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    actual.push_back(reading.event(events[i]));
    if (!reading.bad()) continue;
    Verdict v;
    v.outcome = Outcome::differs;
    v.difference = reading.bad();
    v.difference->line = events[i].line;
    v.difference->event = i;
    return v;
  }
  return Judge<Rational>(c, actual, options).verdict(run);
}

}  // namespace toolcomp::judge
