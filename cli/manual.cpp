// SPDX-License-Identifier: Apache-2.0
#include "cli/manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <vector>

#include "cli/help.h"
#include "cli/manual_setup.h"
#include "cli/manual_texts.h"
#include "cli/roff.h"
#include "spec/language/file_writer.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

// "January 31, 2026", as mdoc has it.
std::string date_in_words(const std::string& date) {
  static constexpr std::array kMonths{"January", "February", "March",     "April",   "May",      "June",
                                      "July",    "August",   "September", "October", "November", "December"};
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  const auto number = [&date](std::size_t at, std::size_t size, auto& value) {
    return date.size() == 10 && std::from_chars(&date[at], &date[at] + size, value).ptr == &date[at] + size;
  };
  const bool read = number(0, 4, year) && number(5, 2, month) && number(8, 2, day);
  if (!read ||
      !std::chrono::year_month_day(std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)).ok())
    throw spec::InputError("--date", 0, 0, "takes YEAR-MONTH-DAY, found \"" + date + '"');
  return fmt::format("{} {}, {}", kMonths.at(month - 1), day, year);
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string argument_macro(const OptionText& option) {
  return "Ar " + roff::word(option.name()) + (option.repeated ? " ..." : "");
}

// "Fl -engine Ar fast|model"
std::string option_macro(const std::string& name, const std::string& value) {
  return "Fl " + roff::word(name.substr(1)) + (value.empty() ? "" : " Ar " + roff::word(value));
}

void add_synopsis(roff::Page& page, const VerbText& verb) {
  page.section("SYNOPSIS");
  page.line(".Nm toolcomp " + verb.name);
  for (const OptionText& option : verb.options) {
    const std::string macro = option.argument ? argument_macro(option) : option_macro(option.name(), option.value);
    if (option.required)
      page.line("." + macro);
    else if (option.argument)
      page.line(".Op " + macro);
  }
  page.line(".Op Ar option ...");
}

void add_options(roff::Page& page, const std::vector<OptionText>& options) {
  page.section("OPTIONS");
  page.line(".Bl -tag -width Ds");
  for (const OptionText& option : options) {
    std::string item = ".It ";
    if (option.argument) {
      item += argument_macro(option);
    } else {
      for (std::size_t i = 0; i < option.names.size(); ++i)
        item += (i == 0 ? "" : " , ") + option_macro(option.names[i], i + 1 == option.names.size() ? option.value : "");
    }
    page.line(item);
    page.text(option.text + '.');
  }
  page.line(".El");
}

void add_named(roff::Page& page, std::string_view title, const char* macro, const std::vector<NamedText>& list) {
  if (list.empty()) return;
  page.section(title);
  page.line(".Bl -tag -width Ds");
  for (const NamedText& entry : list) {
    page.line(fmt::format(".It {} {}", macro, roff::word(std::string(entry.name))));
    page.text(std::string(entry.text));
  }
  page.line(".El");
}

void add_status(roff::Page& page) {
  page.section("EXIT STATUS");
  page.line(".Bl -tag -width Ds");
  for (const StatusText& status : kStatusTexts) {
    page.line(".It " + std::to_string(status.status));
    page.text(std::string(status.text));
  }
  page.line(".El");
  page.text("Where several apply: 4 before 2 before 1 before 3.");
}

void add_examples(roff::Page& page, const std::vector<ExampleText>& examples) {
  if (examples.empty()) return;
  page.section("EXAMPLES");
  bool first = true;
  for (const ExampleText& example : examples) {
    if (!first) page.line(".Pp");
    first = false;
    page.text(std::string(example.text));
    page.line(".Bd -literal -offset indent");
    page.literal("$ " + std::string(example.command));
    page.line(".Ed");
  }
}

// References in the order of sections and names.
void add_see_also(roff::Page& page, std::vector<std::string> pages) {
  std::ranges::sort(pages);
  page.section("SEE ALSO");
  for (const std::string& name : pages) page.line(".Xr toolcomp" + name + " 1 ,");
  page.line(".Xr toolcomp-setup 5");
}

std::string verb_page(const VerbText& verb, const std::string& date) {
  const ManualText& manual = manual_text(verb.name);
  roff::Page page("TOOLCOMP-" + upper(verb.name), 1, date);
  page.section("NAME");
  page.line(".Nm toolcomp-" + verb.name);
  page.line(".Nd " + roff::running(roff::lowered(verb.about)));
  add_synopsis(page, verb);
  page.section("DESCRIPTION");
  page.paragraphs(manual.description);
  add_options(page, verb.options);
  add_named(page, "ENVIRONMENT", "Ev", environment_texts());
  add_named(page, "FILES", "Pa", manual.files);
  add_status(page);
  add_examples(page, manual.examples);
  std::vector<std::string> others{""};
  for (const std::string_view other : manual.see_also) others.push_back('-' + std::string(other));
  add_see_also(page, others);
  return page.take();
}

std::string program_page(const CommandLine& line, const std::string& date) {
  const ManualText& manual = manual_text("");
  roff::Page page("TOOLCOMP", 1, date);
  page.section("NAME");
  page.line(".Nm toolcomp");
  page.line(".Nd exact reference of CNC tool compensation, and judge of controls");
  page.section("SYNOPSIS");
  page.line(".Nm");
  page.line(".Ar verb");
  page.line(".Op Ar argument ...");
  page.line(".Op Ar option ...");
  page.section("DESCRIPTION");
  page.paragraphs(manual.description);
  page.line(".Pp");
  page.text("The verbs, each with a page of its own:");
  page.line(".Bl -tag -width Ds");
  std::vector<std::string> pages;
  for (const VerbText& verb : line.verbs()) {
    if (!verb.listed) continue;
    page.line(".It Cm " + verb.name);
    page.text(verb.about + '.');
    pages.push_back('-' + verb.name);
  }
  page.line(".El");
  add_options(page, line.options());
  add_named(page, "ENVIRONMENT", "Ev", environment_texts());
  add_named(page, "FILES", "Pa", manual.files);
  add_status(page);
  add_examples(page, manual.examples);
  add_see_also(page, pages);
  return page.take();
}

}  // namespace

void write_manual(const CommandLine& line, const std::string& date, const std::string& folder) {
  const std::string words = date_in_words(date);
  const std::filesystem::path place(folder);
  spec::write_file(place / "toolcomp.1", program_page(line, words));
  for (const VerbText& verb : line.verbs())
    if (verb.listed) spec::write_file(place / ("toolcomp-" + verb.name + ".1"), verb_page(verb, words));
  spec::write_file(place / "toolcomp-setup.5", setup_page(words));
}

}  // namespace toolcomp::cli
