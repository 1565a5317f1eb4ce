// SPDX-License-Identifier: Apache-2.0
#include "corpus/diff.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

#include "corpus/vector.h"
#include "judge/oracle/trial.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"
#include "spec/language/naming_clause.h"

namespace toolcomp::corpus {
namespace {

const spec::ClauseList* clauses_of(const spec::Case& c, std::size_t event) {
  return event < c.expect.size() ? &c.expect[event].clauses : nullptr;
}

std::string telling_clause(const spec::Case& before, const spec::Case& after, std::size_t event) {
  const spec::ClauseList* then = clauses_of(before, event);
  const spec::ClauseList* now = clauses_of(after, event);
  if (now == nullptr || now->empty()) now = then;
  if (now == nullptr || now->empty()) return {};
  std::optional<spec::Clause> fresh;
  if (then != nullptr)
    for (const spec::Clause clause : *now)
      if (!then->contains(clause)) fresh = clause;
  return std::string(spec::info(fresh.value_or(*spec::naming_clause(*now))).id);
}

Change compare(const spec::Case& before, const spec::Case& after) {
  Change change{ChangeKind::described, before.id, {}, {}, {}};
  for (std::size_t i = 0; i < std::max(before.expect.size(), after.expect.size()); ++i) {
    const bool both = i < before.expect.size() && i < after.expect.size();
    const bool named = both && before.expect[i].alarm != spec::AlarmCause::none;
    // Without its clauses, which describe it.
    const auto text = [&](const spec::Case& c) {
      if (i >= c.expect.size()) return std::string("nothing");
      spec::TextEvent event = c.expect[i];
      event.clauses = {};
      if (!named) event.alarm = spec::AlarmCause::none;
      return event_text(event, c.setup.axes);
    };
    if (text(before) == text(after)) continue;
    change.kind = ChangeKind::changed;
    change.clause = telling_clause(before, after, i);
    change.before = text(before);
    change.after = text(after);
    break;
  }
  return change;
}

}  // namespace

std::vector<Change> diff(std::span<const spec::Case> before, std::span<const spec::Case> after) {
  std::map<std::string_view, const spec::Case*> now;
  for (const spec::Case& c : after) now.emplace(c.id, &c);
  std::vector<Change> changes;
  std::map<std::string_view, const spec::Case*> then;
  for (const spec::Case& c : before) {
    then.emplace(c.id, &c);
    const auto found = now.find(c.id);
    if (found == now.end())
      changes.push_back({ChangeKind::removed, c.id, {}, {}, {}});
    else if (spec::write_case_line(c) != spec::write_case_line(*found->second))
      changes.push_back(compare(c, *found->second));
  }
  for (const spec::Case& c : after)
    if (!then.contains(c.id)) changes.push_back({ChangeKind::added, c.id, {}, {}, {}});
  return changes;
}

void ask_again(std::vector<Change>& changes, std::span<const spec::Case> before,
               const std::function<void(std::uint64_t)>& progress) {
  std::map<std::string_view, const spec::Case*> then;
  for (const spec::Case& c : before) then.emplace(c.id, &c);
  std::uint64_t asked = 0;
  for (Change& change : changes) {
    if (change.kind != ChangeKind::removed) continue;
    spec::Case now = *then.at(change.id);
    try {
      // Judged, as a vector is when it is made: a number that was decided to be rational has its fraction.
      now.expect = expected_events(judge::try_case(now).run);
      change = compare(*then.at(change.id), now);
    } catch (const spec::InputError& error) {
      change.after = std::string("refused: ") + error.what();
    } catch (const exact::Undecided& undecided) {
      change.after = std::string("not decided: ") + undecided.what();
    }
    change.kind = ChangeKind::removed;
    if (progress) progress(++asked);
  }
}

std::map<std::string, std::size_t> by_clause(std::span<const Change> changes) {
  std::map<std::string, std::size_t> counts;
  for (const Change& change : changes)
    if (!change.after.empty()) ++counts[change.clause];
  return counts;
}

Version raised(Version before, std::span<const Change> changes) {
  const auto any = [changes](ChangeKind kind) {
    return std::ranges::any_of(changes, [kind](const Change& change) { return change.kind == kind; });
  };
  if (any(ChangeKind::removed) || any(ChangeKind::changed)) return {before.major + 1, 0, 0};
  if (any(ChangeKind::added)) return {before.major, before.minor + 1, 0};
  if (any(ChangeKind::described)) return {before.major, before.minor, before.patch + 1};
  return before;
}

std::string to_string(const Change& change) {
  std::string text;
  switch (change.kind) {
    case ChangeKind::removed:
      text = "removed " + change.id;
      break;
    case ChangeKind::added:
      return "added " + change.id;
    case ChangeKind::described:
      return "described differently " + change.id;
    case ChangeKind::changed:
      text = "changed " + change.id;
      break;
  }
  if (change.after.empty()) return text;
  if (!change.clause.empty()) text += " (" + change.clause + ')';
  return text + "\n  before " + change.before + "\n  after  " + change.after;
}

}  // namespace toolcomp::corpus
