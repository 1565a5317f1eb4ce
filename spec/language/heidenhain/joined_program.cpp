// SPDX-License-Identifier: Apache-2.0
#include "spec/language/heidenhain/joined_program.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace toolcomp::spec::klartext {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string_view without_mark(std::string_view text) {
  return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

// Programs that stand behind the main one: their BEGIN PGM follows an END PGM.
void add_names(const std::vector<OutlineEntry>& entries, std::set<std::string>& names) {
  for (const OutlineEntry& entry : entries)
    if (entry.statement == Statement::begin_program) names.insert(program_key(entry.name.view()));
}

}  // namespace

bool has_path(std::string_view name) { return name.find_first_of("/\\:") != std::string_view::npos; }

std::string joined_rest(TextAt rest, std::string_view main, const CalledProgram& called) {
  Setup setup;  // lines that begin with / count too: whether they are skipped is not known here
  setup.control = Control::heidenhain;
  std::string text(rest.text);
  std::set<std::string> names{program_key(main)};
  std::vector<OutlineEntry> entries = outline(setup, text, {});
  add_names(entries, names);
  bool ended =
      std::ranges::any_of(entries, [](const OutlineEntry& entry) { return entry.statement == Statement::end_program; });
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].statement != Statement::call_program) continue;
    const Name name = entries[i].name;
    if (has_path(name.view()) || !names.insert(program_key(name.view())).second) continue;
    std::string before = !text.empty() && text.back() != '\n' ? "\n" : "";
    if (!ended) before.append("END PGM ").append(main.empty() ? "MAIN" : main).append(" MM\n");
    const auto lines = std::ranges::count(text, '\n') + std::ranges::count(before, '\n');
    const std::optional<std::string> found = called(name.view(), rest.line + static_cast<std::uint64_t>(lines));
    if (!found) continue;
    text += before;
    ended = true;
    const std::size_t begin = text.size();
    text += without_mark(*found);
    const std::vector<OutlineEntry> more = outline(setup, text, {begin, 1});
    add_names(more, names);
    entries.insert(entries.end(), more.begin(), more.end());
  }
  return text;
}

std::string joined_klartext(std::string_view main_text, const CalledProgram& called) {
  const std::string text(main_text);
  Setup setup;
  setup.control = Control::heidenhain;
  const std::vector<OutlineEntry> entries = outline(setup, std::string(without_mark(text)), {});
  const bool begins = !entries.empty() && entries.front().statement == Statement::begin_program;
  const std::string main(begins ? entries.front().name.view() : std::string_view());
  std::string joined = joined_rest({without_mark(text)}, main, called);
  return text.substr(0, text.size() - without_mark(text).size()) + joined;
}

}  // namespace toolcomp::spec::klartext
