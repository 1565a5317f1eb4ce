// SPDX-License-Identifier: Apache-2.0
#include "corpus/diff.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "corpus/vector.h"
#include "spec/language/case_format.h"
#include "spec/language/naming_clause.h"

namespace toolcomp::corpus {
namespace {

std::string clause_of(const spec::Case& c, std::size_t event) {
  if (event >= c.expect.size() || c.expect[event].clauses.empty()) return {};
  return std::string(spec::info(*spec::naming_clause(c.expect[event].clauses)).id);
}

Change compare(const spec::Case& before, const spec::Case& after) {
  Change change{ChangeKind::described, before.id, {}, {}, {}};
  for (std::size_t i = 0; i < std::max(before.expect.size(), after.expect.size()); ++i) {
    // Without its clauses, which describe it.
    const auto text = [i](const spec::Case& c) {
      if (i >= c.expect.size()) return std::string("nothing");
      spec::TextEvent event = c.expect[i];
      event.clauses = {};
      return event_text(event, c.setup.axes);
    };
    if (text(before) == text(after)) continue;
    change.kind = ChangeKind::changed;
    change.clause = clause_of(before, i);
    if (change.clause.empty()) change.clause = clause_of(after, i);
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
  switch (change.kind) {
    case ChangeKind::removed:
      return "removed " + change.id;
    case ChangeKind::added:
      return "added " + change.id;
    case ChangeKind::described:
      return "described otherwise " + change.id;
    case ChangeKind::changed:
      break;
  }
  std::string text = "changed " + change.id;
  if (!change.clause.empty()) text += " (" + change.clause + ')';
  return text + "\n  before " + change.before + "\n  after  " + change.after;
}

}  // namespace toolcomp::corpus
