// SPDX-License-Identifier: Apache-2.0
#include "cli/manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <vector>

#include "cli/help.h"
#include "host/file_writer.h"

namespace toolcomp::cli {
namespace {

// A line of text in which nothing is taken for a request, and hyphens stay those that are typed.
std::string roff(std::string_view text) {
  std::string out = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  return out + '\n';
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// A tag in bold with its text below it.
std::string item(const std::string& tag, const std::string& text) { return ".TP\n.B " + roff(tag) + roff(text + '.'); }

// Arguments and options; the common ones only where they are asked for.
std::string items(const CLI::App& app, bool common) {
  std::string out;
  for (const CLI::Option* argument : arguments_of(app)) out += item(form_of(*argument), text_of(*argument));
  for (const CLI::Option* option : options_of(app))
    if (common || option->get_group() != kCommonOptions) out += item(form_of(*option), text_of(*option));
  return out;
}

// What stands below the options of --help: "Title:" begins a section, the lines in it stay as they are.
std::string sections(const std::string& footer) {
  std::string out;
  for (const std::string& line : CLI::detail::split(footer, '\n')) {
    if (line.empty()) continue;
    if (line.front() != ' ')
      out += (out.empty() ? "" : ".fi\n") + (".SH " + upper(line.substr(0, line.find(':')))) + "\n.nf\n";
    else
      out += roff(line);
  }
  return out.empty() ? out : out + ".fi\n";
}

std::string page(const CLI::App& app, const std::string& name, const std::string& date) {
  const bool program = app.get_parent() == nullptr;
  const std::string title = CLI::detail::find_and_replace(name, " ", "-");
  std::string out = ".\\\" Made by the build from the definitions of the command.\n";
  out += fmt::format(".TH {} 1 {} \"toolcomp {}\"\n", upper(title), date, TOOLCOMP_VERSION);
  out += ".SH NAME\n" + roff(title + " - " + summary_of(app)) + ".SH SYNOPSIS\n.B " + roff(usage_of(app, name));
  out += ".SH DESCRIPTION\n";
  const std::vector<std::string> texts = paragraphs_of(app);
  for (const std::string& text : texts) out += (&text == &texts.front() ? "" : ".PP\n") + roff(text);
  const std::vector<const CLI::App*> verbs = listed_verbs(app);
  if (!verbs.empty()) out += ".SH VERBS\n";
  for (const CLI::App* verb : verbs)
    if (program)
      out += item(verb->get_name(), summary_of(*verb));
    else
      out += ".SS " + roff(usage_of(*verb, verb->get_name())) + roff(summary_of(*verb) + '.') + items(*verb, false);
  out += ".SH OPTIONS\n" + items(app, true) + sections(app.get_footer());
  out += ".SH SEE ALSO\n";
  if (!program) return out + ".BR toolcomp (1)\n";
  for (const CLI::App* verb : verbs)
    out += ".BR toolcomp\\-" + verb->get_name() + (verb == verbs.back() ? " (1)\n" : " (1),\n");
  return out;
}

}  // namespace

void write_manual(const CLI::App& program, const std::string& date, const std::string& folder) {
  const std::filesystem::path place(folder);
  host::write_file(place / "toolcomp.1", page(program, "toolcomp", date));
  for (const CLI::App* verb : listed_verbs(program))
    host::write_file(place / ("toolcomp-" + verb->get_name() + ".1"),
                     page(*verb, "toolcomp " + verb->get_name(), date));
}

}  // namespace toolcomp::cli
