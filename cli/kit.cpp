// SPDX-License-Identifier: Apache-2.0
// toolcomp kit: programs, offsets and run sheet for a control without a pipe; its recordings judged.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

#include "certify/adapter.h"
#include "certify/adapter_batch.h"
#include "certify/kit/judge.h"
#include "certify/kit/kit_json.h"
#include "certify/kit/make.h"
#include "certify/report.h"
#include "cli/adapter_names.h"
#include "cli/manners.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/verbs.h"
#include "corpus/golden.h"
#include "host/file_writer.h"
#include "spec/language/decimal.h"
#include "spec/language/input_error.h"
#include "spec/language/suggestion.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;
namespace kit = certify::kit;

[[noreturn]] void usage(const std::string& message) { throw spec::InputError("toolcomp kit", 0, 0, message); }

kit::Machine read_machine(const KitOptions& options) {
  kit::Machine machine;
  machine.setup = read_setup(options.setup);
  detail("setup " + options.setup);
  for (const std::string& travel : options.travels) kit::add_travel(machine, travel);
  return machine;
}

// All files or none: what stands in the folder beside them would be taken for the kit's.
void write_all(const kit::Kit& made, const fs::path& folder) {
  std::vector<host::FileText> files{{folder / kit::kKitFile, kit::write_kit(made)}};
  for (const auto& [name, text] : made.files) files.emplace_back(folder / name, text);
  host::write_files(files);
}

std::optional<spec::Decimal> tolerance_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto value = spec::parse_decimal(text);
  if (!value || value->negative || value->is_zero()) usage("--tolerance takes a positive length");
  return value;
}

kit::WhyNot asking(const KitOptions& options) {
  const auto adapter = certify::find_adapter(options.controller, certify::adapter_folders(options.adapters));
  if (!adapter)
    usage("--controller must name an adapter (docs/adapters.md); there is no adapter " + options.controller +
          spec::did_you_mean(options.controller, adapter_names(options.adapters)));
  certify::expect_programs(*adapter);
  return [adapter = *adapter](const std::vector<spec::Case>& cases) { return certify::why_not(adapter, cases); };
}

}  // namespace

int kit_make(const KitOptions& options) {
  expect_folder(options.out, "--out");
  if (fs::exists(options.out) && !fs::is_empty(options.out))
    throw spec::InputError("--out", 0, 0, options.out + " is not empty");
  kit::MakeOptions how;
  how.machine = read_machine(options);
  how.sections = options.sections;
  how.corpus = options.corpus.empty() ? corpus::default_folder() : fs::path(options.corpus);
  how.generated = options.cases;
  how.seed = options.seed;
  how.first_offset = options.first_offset;
  how.tolerance = tolerance_of(options.tolerance).value_or(how.tolerance);
  detail(fmt::format("corpus {}; {} more programs generated, seed {}", how.corpus.string(), how.generated, how.seed));
  if (!options.controller.empty()) how.why_not = asking(options);
  kit::Kit made;
  {
    const Progress progress("vectors");
    how.progress = [](const std::string& what) { Progress::line(what); };
    made = kit::make(how);
  }
  write_all(made, options.out);
  const auto stopped = std::ranges::count_if(made.programs, [](const auto& p) { return !p.alarm.empty(); });
  std::size_t cases = 0;
  for (const kit::KitProgram& program : made.programs) cases += program.cases.size();
  fmt::print("{} programs, {} of them end in an alarm; {} cases; {} settings of parameters\n", made.programs.size(),
             stopped, cases, made.groups.size());
  fmt::print("{} of {} clause outcomes: {} by recordings, {} by alarms\n", made.recorded + made.noted, made.outcomes,
             made.recorded, made.noted);
  fmt::print("{}\n", (fs::path(options.out) / "run-sheet.html").string());
  return kAgrees;
}

int kit_judge(const KitOptions& options) {
  expect_folder(options.report, "--report");
  kit::JudgeKitOptions how;
  how.folder = options.folder;
  for (const std::string& recording : options.recordings) how.recordings.emplace_back(recording);
  how.alarms = options.alarms;
  how.tolerance = tolerance_of(options.tolerance);
  how.machine_coordinates = options.machine_coordinates;
  how.rapids_by_axis = options.rapids_by_axis;
  detail(fmt::format("kit {}, {} recordings", options.folder, options.recordings.size()));
  const kit::KitVerdict verdict = kit::judge_kit(how);
  kit::write_certificate(verdict, options.report);
  const auto program_name = [&verdict](unsigned number) {
    return kit::program_name(verdict.kit.machine.setup.control, number);
  };
  for (const kit::JudgedProgram& judged : verdict.programs) {
    fmt::print("{}: {}{}{}\n", program_name(judged.number), kit::name(judged.verdict), judged.why.empty() ? "" : ", ",
               judged.why);
    for (const certify::TraceFinding& finding : judged.trace.findings)
      fmt::print("  {}:{}: {} of line {} by {}\n", judged.file, finding.sample, finding.kind, finding.line,
                 certify::extent(finding));
    if (judged.trace.cause) fmt::print("  one mistake explains everything found: {}\n", *judged.trace.cause);
  }
  for (const kit::JudgedAlarm& judged : verdict.alarms)
    fmt::print("{}: alarm {}{}{}\n", program_name(judged.number), kit::name(judged.verdict),
               judged.noted.empty() ? "" : ", ", judged.noted);
  for (const std::string& stranger : verdict.strangers) note(stranger + " is not a program of this kit");
  fmt::print("{} of {} clause outcomes of the kit shown; {}\n", verdict.shown, verdict.kit.recorded + verdict.kit.noted,
             (fs::path(options.report) / "index.html").string());
  return kit::exit_status(verdict);
}

}  // namespace toolcomp::cli
