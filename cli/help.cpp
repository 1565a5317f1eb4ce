// SPDX-License-Identifier: Apache-2.0
#include "cli/help.h"

#include <algorithm>
#include <array>

namespace toolcomp::cli {
namespace {

constexpr std::size_t kNarrowest = 40;
constexpr std::size_t kWidest = 100;
constexpr std::size_t kIndent = 2;
constexpr std::size_t kTexts = 28;  // where texts begin

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// The words of a text in lines of so many columns; the first line goes on at `column`.
void wrap(std::string& out, std::string_view text, std::size_t column, std::size_t indent, std::size_t columns) {
  bool first = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(text.size(), end + 1));
    const std::size_t size = characters(word);
    if (!first && column + 1 + size > columns) {
      out.append(1, '\n').append(indent, ' ');
      column = indent;
      first = true;
    }
    if (!first) out += ' ';
    out += word;
    column += size + (first ? 0 : 1);
    first = false;
  }
  out += '\n';
}

void entry(std::string& out, std::string_view name, std::string_view text, std::size_t columns) {
  // Little room: texts below names.
  const std::size_t texts = columns < 2 * kTexts ? 2 * kIndent : kTexts;
  out.append(kIndent, ' ').append(name);
  std::size_t column = kIndent + characters(name);
  if (text.empty()) {
    out += '\n';
    return;
  }
  if (column + 1 > texts - 1) {
    out += '\n';
    column = 0;
  }
  out.append(texts - column, ' ');
  wrap(out, text, texts, texts, columns);
}

std::size_t sensible(std::size_t columns) { return std::clamp(columns, kNarrowest, kWidest); }

template <class Wanted>
void entries(std::string& out, std::string_view title, const std::vector<OptionText>& options, std::size_t columns,
             Wanted wanted) {
  bool any = false;
  for (const OptionText& option : options) {
    if (!wanted(option)) continue;
    if (!any) out.append("\n").append(title).append(":\n");
    any = true;
    entry(out, usage(option), option.text, columns);
  }
}

}  // namespace

std::string usage(const OptionText& option) {
  if (option.argument) return option.name() + (option.repeated ? "…" : "");
  std::string text;
  for (const std::string& name : option.names) text += (text.empty() ? "" : ", ") + name;
  return option.value.empty() ? text : text + ' ' + option.value;
}

std::string usage(const VerbText& verb) {
  std::string text = "toolcomp " + verb.name;
  for (const OptionText& option : verb.options) {
    const std::string shown = option.argument ? usage(option) : option.name() + ' ' + option.value;
    if (option.required)
      text += ' ' + shown;
    else if (option.argument)
      text += " [" + shown + ']';
  }
  return text + " [OPTION…]";
}

std::string first_steps() {
  return "usage: toolcomp VERB [ARGUMENT…]\n"
         "\n"
         "  toolcomp config example > setup.toml      a setup to begin with\n"
         "  toolcomp run PART.nc --setup setup.toml   what the control makes of a program, exactly\n"
         "  toolcomp explain PART.nc                  why, block by block\n"
         "  toolcomp certify --controller COMMAND     judge a control\n"
         "\n"
         "`toolcomp --help` lists the verbs, `toolcomp VERB --help` says what each takes.\n";
}

std::string help(const std::vector<VerbText>& verbs, const std::vector<OptionText>& options, std::size_t columns) {
  columns = sensible(columns);
  std::string out;
  wrap(out,
       "An exact reference of CNC tool compensation, a fast engine certified against it, and the harness that "
       "certifies.",
       0, 0, columns);
  out += "\nUsage: toolcomp VERB [ARGUMENT…] [OPTION…]\n\nVerbs:\n";
  for (const VerbText& verb : verbs)
    if (verb.listed) entry(out, verb.name, verb.about, columns);
  entries(out, "Options", options, columns, [](const OptionText&) { return true; });
  out += "\nExit status:\n";
  for (const StatusText& status : kStatusTexts) entry(out, std::to_string(status.status), status.text, columns);
  return out + "\n`toolcomp VERB --help` says what a verb takes; `man toolcomp-VERB` has examples.\n";
}

std::string help(const VerbText& verb, std::size_t columns) {
  columns = sensible(columns);
  std::string out;
  wrap(out, verb.about + '.', 0, 0, columns);
  out += "\nUsage: ";
  wrap(out, usage(verb), 7, 9, columns);
  entries(out, "Arguments", verb.options, columns, [](const OptionText& o) { return o.argument; });
  entries(out, "Options", verb.options, columns, [](const OptionText& o) { return !o.argument && !o.common; });
  entries(out, "Common options", verb.options, columns, [](const OptionText& o) { return o.common; });
  return out;
}

}  // namespace toolcomp::cli
