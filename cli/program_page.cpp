// SPDX-License-Identifier: Apache-2.0
#include "cli/program_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "certify/path_svg.h"
#include "certify/view/program_page.h"
#include "spec/language/byte_source.h"

namespace toolcomp::cli {
namespace {

// The files that are called, by the first line of each in the text.
std::vector<std::pair<std::uint64_t, std::string>> called_files(const Program& program, const spec::Case& c) {
  std::vector<std::pair<std::uint64_t, std::string>> files;
  if (program.is_case()) return files;
  std::string last = program.path();
  const auto lines = static_cast<std::uint64_t>(std::ranges::count(c.program, '\n')) + 1;
  for (std::uint64_t line = 1; line <= lines; ++line) {
    std::string file = program.place(line).file;
    if (file == last) continue;
    last = file;
    files.emplace_back(line, std::move(file));
  }
  return files;
}

// Beyond it a picture shows nothing more, and takes minutes and gigabytes.
constexpr std::size_t kMostOfAPage = 200'000;

std::vector<ProgramAlarm> alarms_of(const Program& program, const certify::ProgramRun& run) {
  std::vector<ProgramAlarm> alarms;
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    const model::Event& event = run.events[i];
    if (!spec::ends_run(event.kind) || run.blocks.empty()) continue;
    const certify::ProgramRun::Block& block = run.blocks[run.block_of[i]];
    const bool known = block.line == event.line;
    alarms.push_back({known ? program.place(block.fault_line, block.fault_column) : program.place(event.line),
                      event.kind == spec::EventKind::alarm ? std::string(event.number.view()) : std::string(),
                      event.message});
  }
  return alarms;
}

}  // namespace

std::string setup_of(const ViewOptions& options) {
  if (!options.setup.empty()) return options.setup;
  return (std::filesystem::path(options.program).parent_path() / "setup.toml").string();
}

void report_alarms(const ProgramPage& page) {
  for (const ProgramAlarm& alarm : page.alarms)
    report_alarm(alarm.place.file, alarm.place.line, alarm.place.column, alarm.number, alarm.message);
}

ProgramPage program_page(const ViewOptions& options, const std::string& live, bool with_fast,
                         const std::function<void()>& on_block) {
  const Program program(options.program, options.setup, options.samples);
  const spec::Case c = program.as_case();
  certify::ProgramRun run;
  std::size_t blocks = 0;
  const auto too_long = [&options](const char* what) {
    throw spec::InputError(spec::display_name(options.program), 0, 0,
                           fmt::format("{} more than {} {}; toolcomp makes no page of a longer program",
                                       *what == 'l' ? "has" : "runs", kMostOfAPage, what));
  };
  if (static_cast<std::size_t>(std::ranges::count(c.program, '\n')) > kMostOfAPage) too_long("lines");
  const auto each_block = [&] {
    if (++blocks > kMostOfAPage) too_long("blocks");
    on_block();
  };
  try {
    run = certify::run_program(c, spec::display_name(options.program), each_block);
  } catch (const spec::InputError& error) {
    throw program.placed(error);
  }
  ProgramPage page;
  const auto called = called_files(program, c);
  certify::ProgramView view{&run, {}, options.digits};
  for (const auto& [line, file] : called) {
    page.called_files.push_back(file);
    view.files.emplace_back(line, std::filesystem::path(file).filename().string());
  }
  certify::PathOptions drawing = certify::path_options(c);
  if (with_fast) {
    drawing.other = run.fast;
    drawing.other_name = "fast engine";
  }
  const certify::ProgramPageNames names{spec::display_name(options.program),
                                        program.is_case() ? std::string() : setup_of(options), live};
  page.html = certify::program_page(c, view, drawing, names);
  page.undecided = run.undecided;
  page.alarms = alarms_of(program, run);
  return page;
}

}  // namespace toolcomp::cli
