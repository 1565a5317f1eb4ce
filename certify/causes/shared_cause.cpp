// SPDX-License-Identifier: Apache-2.0
#include "certify/causes/shared_cause.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "certify/causes/mistakes.h"
#include "certify/convert.h"
#include "certify/event_fields.h"
#include "certify/event_values.h"
#include "certify/evidence.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/policy.h"

namespace toolcomp::certify {
namespace {

// A finding with its pairs of numbers, where its events can be paired.
struct Seen {
  const Finding& finding;
  std::optional<std::vector<ValuePair>> pairs;
  double resolution = 0;  // announced
  bool fault = false;     // there are no events that came
  Events expected;        // without a fault

  [[nodiscard]] bool same(double a, double b) const {
    return std::fabs(a - b) <= resolution + judge::policy::kSameForCause * std::max({1.0, std::fabs(a), std::fabs(b)});
  }
};

// A mistake, and whether it explains a finding.
struct Hypothesis {
  std::string words;
  std::function<bool(const Seen&)> explains;
};
using Hypotheses = std::vector<Hypothesis>;

bool is_position(std::string_view field) {
  return field == "programmed" || field == "point" || field == "axes" || field == "machine";
}

// Which numbers a mistake is in.
struct ValuePart {
  std::string words;
  std::function<bool(const EventValue&)> has;
};

// Every pair of the part is the number of `made`, every other is as expected.
bool follows(const Seen& seen, const ValuePart& part, const std::function<double(double)>& made) {
  return seen.pairs && std::ranges::all_of(*seen.pairs, [&](const ValuePair& pair) {
           return seen.same(pair.actual, part.has(pair.expected) ? made(pair.expected.number) : pair.expected.number);
         });
}

std::string factor_words(double factor) {
  constexpr double kInch = 25.4;
  constexpr double kDegree = std::numbers::pi / 180;
  const auto same = [factor](double other) {
    return std::fabs(factor - other) <= judge::policy::kSameForCause * std::fabs(other);
  };
  if (same(-1)) return "has the opposite sign";
  if (same(kInch)) return "is in millimetres instead of inches (× 25.4)";
  if (same(1 / kInch)) return "is in inches instead of millimetres (÷ 25.4)";
  if (same(kDegree)) return "is in radians instead of degrees";
  if (same(1 / kDegree)) return "is in degrees instead of radians";
  if (factor == 0) return "is always 0";
  return fmt::format("is scaled by {:.6g}", factor);
}

// The parts that may be wrong where this number is, the widest first.
std::vector<ValuePart> parts_of(const EventValue& wrong) {
  const std::string field(wrong.field);
  const char letter = wrong.letter;
  std::vector<ValuePart> parts{{"every number", [](const EventValue&) { return true; }}};
  if (is_position(field)) {
    const bool linear = spec::is_linear_axis(letter);
    parts.push_back({"every position", [](const EventValue& v) { return is_position(v.field); }});
    parts.push_back({linear ? "every linear axis" : "every rotary axis", [linear](const EventValue& v) {
                       return is_position(v.field) && spec::is_linear_axis(v.letter) == linear;
                     }});
    parts.push_back({fmt::format("{} of every position", letter),
                     [letter](const EventValue& v) { return is_position(v.field) && v.letter == letter; }});
  }
  parts.push_back({field, [field](const EventValue& v) { return v.field == field; }});
  if (letter != 0)
    parts.push_back({fmt::format("{}.{}", field, letter),
                     [field, letter](const EventValue& v) { return v.field == field && v.letter == letter; }});
  return parts;
}

void add_constants_and_factors(const Seen& seen, Hypotheses& out) {
  if (!seen.pairs) return;
  const auto wrong = [&seen](const ValuePair& pair) { return !seen.same(pair.actual, pair.expected.number); };
  const auto first = std::ranges::find_if(*seen.pairs, wrong);
  if (first == seen.pairs->end()) return;
  for (const ValuePart& part : parts_of(first->expected)) {
    const double by = first->actual - first->expected.number;
    out.push_back({fmt::format("{} is off by {:.6g}", part.words, by),
                   [=](const Seen& s) { return follows(s, part, [by](double x) { return x + by; }); }});
    if (first->expected.number == 0) continue;
    const double factor = first->actual / first->expected.number;
    out.push_back({part.words + " " + factor_words(factor),
                   [=](const Seen& s) { return follows(s, part, [factor](double x) { return x * factor; }); }});
  }
}

// The numbers of the part lie on the grid of 1/scale, no farther off than the rounding brings them, and all others are
// as expected. A number that is on the edge of its cell but for the last bit may go either way.
bool is_rounded(const Seen& seen, const ValuePart& part, judge::Rounding how, double scale) {
  return seen.pairs && std::ranges::all_of(*seen.pairs, [&](const ValuePair& pair) {
           const double exact = pair.expected.number;
           if (!part.has(pair.expected)) return seen.same(pair.actual, exact);
           const double off = pair.actual - exact;
           const double granted = judge::rounded_off(how, 1 / scale, exact, off);
           return seen.same(pair.actual, std::round(pair.actual * scale) / scale) &&
                  (std::fabs(off) <= granted || seen.same(std::fabs(off), granted));
         });
}

// Numbers on a grid: what a control shows, not what it has.
void add_grids(const Seen& seen, Hypotheses& out) {
  constexpr int kFinest = 8;
  struct Rounding {
    const char* words;
    judge::Rounding how;
  };
  static constexpr std::array<Rounding, 3> kRoundings{{{"to nearest", judge::Rounding::nearest},
                                                       {"down", judge::Rounding::down},
                                                       {"toward zero", judge::Rounding::toward_zero}}};
  if (!seen.pairs) return;
  static const std::array kParts{ValuePart{"numbers", [](const EventValue&) { return true; }},
                                 ValuePart{"positions", [](const EventValue& v) { return is_position(v.field); }}};
  double scale = 1;
  for (int digits = 1; digits <= kFinest; ++digits) {
    scale *= 10;
    for (const ValuePart& part : kParts)
      for (const Rounding& rounding : kRoundings)
        out.push_back({fmt::format("{} look rounded to {} decimals, {}", part.words, digits, rounding.words),
                       [=](const Seen& s) { return s.resolution == 0 && is_rounded(s, part, rounding.how, scale); }});
  }
}

// The number of `field` and `letter` expected for an event, if there is one.
std::optional<double> expected_at(const Seen& seen, std::size_t event, std::string_view field, char letter) {
  for (const ValuePair& pair : *seen.pairs)
    if (pair.expected.event == event && pair.expected.field == field && pair.expected.letter == letter)
      return pair.expected.number;
  return std::nullopt;
}

void add_exchanges(const Seen& seen, Hypotheses& out) {
  const std::string& letters = seen.finding.smallest.setup.axes.letters();
  for (std::size_t i = 0; i < letters.size(); ++i)
    for (std::size_t k = i + 1; k < letters.size(); ++k) {
      const char a = std::min(letters[i], letters[k]);
      const char b = std::max(letters[i], letters[k]);
      const auto exchanged = [=](const Seen& s) {
        return s.pairs && std::ranges::all_of(*s.pairs, [&](const ValuePair& pair) {
                 const EventValue& e = pair.expected;
                 const char other = e.letter == a ? b : e.letter == b ? a : e.letter;
                 const auto number = is_position(e.field) ? expected_at(s, e.event, e.field, other) : e.number;
                 return s.same(pair.actual, number.value_or(e.number));
               });
      };
      out.push_back({fmt::format("{} and {} are exchanged", a, b), exchanged});
    }
}

void add_late(Hypotheses& out) {
  out.push_back({"positions come one block late", [](const Seen& s) {
                   return s.pairs && std::ranges::all_of(*s.pairs, [&](const ValuePair& pair) {
                            const EventValue& e = pair.expected;
                            if (!is_position(e.field) || e.event == 0) return true;
                            const auto before = expected_at(s, e.event - 1, e.field, e.letter);
                            return s.same(pair.actual, before.value_or(e.number));
                          });
                 }});
}

// Whether these events are what came.
bool came(const Seen& seen, const Events& events, const spec::Axes& axes) {
  if (seen.fault) return false;
  const auto pairs = pairs_of(events, axes, seen.finding.actual_events, seen.finding.smallest.setup.axes);
  return pairs && std::ranges::all_of(
                      *pairs, [&](const ValuePair& pair) { return seen.same(pair.actual, pair.expected.number); });
}

// Whether what the model says of the case is what came.
bool came(const Seen& seen, const spec::Case& c) {
  if (seen.fault) return false;
  try {
    return came(seen, in_doubles(judge::run_model(c).events), c.setup.axes);
  } catch (const std::exception&) {
    return false;
  }
}

// Whether it is the events expected, once they are changed.
bool came_changed(const Seen& seen, const std::function<void(Events&)>& change) {
  Events events = seen.expected;
  change(events);
  return came(seen, events, seen.finding.smallest.setup.axes);
}

void add_left_out(Hypotheses& out) {
  using Event = spec::Event<double>;
  const auto add = [&out](const std::string& words, bool (*left)(const Event&)) {
    out.push_back({words, [left](const Seen& s) {
                     return came_changed(s, [left](Events& events) { std::erase_if(events, left); });
                   }});
  };
  add("all events are missing", [](const Event&) { return true; });
  add("alarms are missing", [](const Event& e) { return e.kind == spec::EventKind::alarm; });
  add("events other than moves are missing", [](const Event& e) { return e.kind != spec::EventKind::move; });
  add("samples are missing", [](const Event& e) { return e.kind == spec::EventKind::sample; });
  add("warnings are missing", [](const Event& e) { return e.kind == spec::EventKind::warning; });
  add("corner moves are missing", [](const Event& e) { return e.cause == spec::Cause::corner; });
  add("start-up moves are missing", [](const Event& e) { return e.cause == spec::Cause::start_up; });
  add("cancel moves are missing", [](const Event& e) { return e.cause == spec::Cause::cancel; });
}

// The last event twice or not at all, and events in another order.
void add_orders(Hypotheses& out) {
  const auto add = [&out](const char* words, void (*change)(Events&)) {
    out.push_back({words, [change](const Seen& s) { return came_changed(s, change); }});
  };
  add("the last event is missing", [](Events& events) {
    if (!events.empty()) events.pop_back();
  });
  add("the last event comes twice", [](Events& events) {
    if (!events.empty()) events.push_back(events.back());
  });
  add("events come in reverse order", [](Events& events) { std::ranges::reverse(events); });
  add("lines are counted from 0", [](Events& events) {
    for (auto& event : events) --event.line;
  });
  add("lines are one too high", [](Events& events) {
    for (auto& event : events) ++event.line;
  });
  add("if the run ends in an alarm, the moves before it are missing", [](Events& events) {
    if (!events.empty() && events.back().kind == spec::EventKind::alarm)
      std::erase_if(events, [](const auto& event) { return event.kind != spec::EventKind::alarm; });
  });
}

void add_mistakes(Hypotheses& out) {
  for (const Mistake& mistake : kMistakes)
    out.push_back({mistake.words, [&mistake](const Seen& s) { return came(s, mistake.made_in(s.finding.smallest)); }});
}

bool is_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

// What is not in numbers: faults by how they show, words by what stands in place of what.
std::vector<std::string> words_of(const Finding& f) {
  const std::string& kind = f.key.kind;
  const judge::Difference& d = f.difference;
  if (kind.starts_with("law ")) return {};
  if (is_fault(f.key)) {
    // How long it was waited for is no matter.
    if (d.actual.starts_with("no answer within")) return {kind};
    const std::string text = d.actual.substr(0, d.actual.find('"'));
    return {kind + ": " + text.substr(0, text.find_last_not_of(" :,") + 1)};
  }
  if (kind == "missing field" || kind == kNeverSent) return {kind + ": " + d.field.substr(0, d.field.find('.'))};
  if (d.field.empty() || d.field == "event" || is_number(d.actual) || is_number(d.expected)) return {};
  return {fmt::format("{} is {} instead of {}", d.field, d.actual, d.expected),
          fmt::format("{} is always {}", d.field, d.actual)};
}

// Any one: what is left of them is tried with each left out in turn.
void add_one_less(Hypotheses& out) {
  out.push_back(
      {"one event of each answer is missing", [](const Seen& s) {
         if (s.fault || s.finding.actual_events.size() + 1 != s.expected.size()) return false;
         for (std::size_t i = 0; i < s.expected.size(); ++i)
           if (came_changed(s, [i](Events& events) { events.erase(events.begin() + static_cast<std::ptrdiff_t>(i)); }))
             return true;
         return false;
       }});
}

// What came is what the case before asks for.
void add_stale(Hypotheses& out) {
  out.push_back({"the answer belongs to the previous case",
                 [](const Seen& s) { return !s.finding.before.empty() && came(s, s.finding.before.back()); }});
}

Hypotheses hypotheses(const std::vector<Seen>& all) {
  Hypotheses out;
  for (const Seen& seen : all) {
    add_constants_and_factors(seen, out);
    add_exchanges(seen, out);
    add_grids(seen, out);
  }
  add_late(out);
  add_left_out(out);
  add_orders(out);
  add_mistakes(out);
  add_stale(out);
  add_one_less(out);
  for (const Seen& seen : all)
    if (!seen.pairs)
      for (const std::string& words : words_of(seen.finding))
        out.push_back(
            {words, [words](const Seen& s) { return !s.pairs && std::ranges::count(words_of(s.finding), words) > 0; }});
  std::set<std::string> known;
  std::erase_if(out, [&known](const Hypothesis& h) { return !known.insert(h.words).second; });
  return out;
}

// What no mistake explains, by what differs.
void add_by_field(const std::vector<Finding>& findings, std::vector<SharedCause>& causes) {
  std::set<std::size_t> explained;
  for (const SharedCause& cause : causes) explained.insert(cause.findings.begin(), cause.findings.end());
  std::map<std::string, std::vector<std::size_t>> left;
  for (std::size_t i = 0; i < findings.size(); ++i)
    if (!explained.contains(i)) {
      const Finding& f = findings[i];
      const std::string field = f.difference.field.substr(0, f.difference.field.find_first_of(".["));
      left["not explained: " + f.key.kind + (field.empty() || field == f.key.kind ? "" : " of " + field)].push_back(i);
    }
  for (auto& [words, indices] : left) causes.push_back({words, std::move(indices)});
}

// Pairs only where a number is what differs.
Seen seen_in(const Finding& f) {
  Seen seen{f, std::nullopt, f.subject.resolution.numbers().mm, is_fault(f.key) || f.key.kind == kNeverSent, {}};
  if (seen.fault) return seen;
  seen.expected = in_doubles(judge::run_model(f.smallest).events);
  if (f.key.kind == "missing field") return seen;
  seen.pairs = pairs_of(seen.expected, f.actual_events, f.smallest.setup.axes);
  const auto differs = [&](const ValuePair& pair) { return !seen.same(pair.actual, pair.expected.number); };
  if (seen.pairs && std::ranges::none_of(*seen.pairs, differs)) seen.pairs.reset();
  return seen;
}

}  // namespace

std::vector<SharedCause> shared_causes(const std::vector<Finding>& findings) {
  std::vector<Seen> all;
  all.reserve(findings.size());
  for (const Finding& f : findings) all.push_back(seen_in(f));
  std::vector<SharedCause> causes;
  for (const Hypothesis& h : hypotheses(all)) {
    SharedCause cause{h.words, {}};
    for (std::size_t i = 0; i < all.size(); ++i)
      if (h.explains(all[i])) cause.findings.push_back(i);
    if (!cause.findings.empty()) causes.push_back(std::move(cause));
  }
  // The one that explains most first, then what is left for the others.
  std::vector<SharedCause> chosen;
  while (!causes.empty()) {
    const auto most = std::ranges::max_element(causes, {}, [](const SharedCause& c) { return c.findings.size(); });
    chosen.push_back(*most);
    for (SharedCause& cause : causes)
      std::erase_if(cause.findings, [&](std::size_t i) { return std::ranges::count(chosen.back().findings, i) > 0; });
    std::erase_if(causes, [](const SharedCause& c) { return c.findings.empty(); });
  }
  add_by_field(findings, chosen);
  return chosen;
}

}  // namespace toolcomp::certify
