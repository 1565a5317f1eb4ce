// SPDX-License-Identifier: Apache-2.0
#include "certify/view/program_page.h"

#include <algorithm>
#include <filesystem>

#include "certify/markup.h"
#include "certify/page.h"
#include "certify/view/view.h"
#include "spec/language/byte_source.h"

namespace toolcomp::certify {
namespace {

std::string head(const ProgramPageNames& names) {
  const std::string name = std::filesystem::path(names.program).filename().string();
  return "<header class=\"bench-head\"><h1>" + escape(name) + "</h1><p class=\"soft\">" +
         (names.setup.empty() ? "" : escape(std::filesystem::path(names.setup).filename().string()) + " · ") +
         "toolcomp " TOOLCOMP_VERSION "</p></header>\n";
}

PageOptions options_of(const ProgramPageNames& names) { return {.fills_window = true, .live = names.live}; }

std::string title_of(const ProgramPageNames& names) {
  return std::filesystem::path(names.program).filename().string() + " – toolcomp view";
}

// Lines about the one at fault, as far as the file can be read.
std::string lines_about(const spec::InputError& fault) {
  constexpr std::uint64_t kAbout = 4;
  constexpr std::size_t kMostBytes = 1 << 26;
  if (fault.line() == 0) return {};
  std::string text;
  try {
    text = spec::read_file(fault.file(), kMostBytes);
  } catch (const spec::InputError&) {
    return {};
  }
  std::string_view rest = text;
  std::string out = "<pre>";
  for (std::uint64_t line = 1; !rest.empty() && line <= fault.line() + kAbout; ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    if (line + kAbout >= fault.line())
      out += (line == fault.line() ? "<span class=\"hit\"><i>" : "<span><i>") + std::to_string(line) + "</i>" +
             escape(rest.substr(0, end)) + "</span>";
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return out + "</pre>\n";
}

}  // namespace

std::string program_page(const spec::Case& c, const ProgramView& view, const PathOptions& drawing,
                         const ProgramPageNames& names) {
  const ViewRun run = view_run(view.run->events);
  return page(title_of(names),
              head(names) +
                  certify::view("Program " + names.program, c, run, {drawing, {}, &view},
                                path_svg(run.events, c.setup.axes, drawing)) +
                  "<noscript>\n<p>Without JavaScript this page shows only the picture and the program.</p>\n" +
                  listing(c.program, 0) + "</noscript>\n",
              options_of(names));
}

std::string fault_page(const spec::InputError& fault, const ProgramPageNames& names) {
  return page(title_of(names),
              head(names) + R"(<main class="fault" role="alert"><p class="bad"><b>)" + escape(fault.what()) +
                  "</b></p>\n" + lines_about(fault) +
                  "<p class=\"soft\">The page returns when this error is corrected.</p></main>\n",
              options_of(names));
}

std::string waiting_page(const ProgramPageNames& names) {
  return page(title_of(names), head(names) + "<main class=\"fault\"><p>The page is being made.</p></main>\n",
              options_of(names));
}

}  // namespace toolcomp::certify
