// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "certify/kit/case_run.h"
#include "certify/kit/kit_json.h"
#include "certify/kit/offsets.h"
#include "certify/kit/recording.h"
#include "certify/sort_by.h"
#include "certify/trace/recording.h"
#include "certify/trace/samples.h"
#include "judge/oracle/number.h"
#include "spec/language/byte_source.h"
#include "spec/language/decimal_order.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify::kit {
namespace {

namespace fs = std::filesystem;

// All files, by name within a folder.
std::vector<fs::path> files_of(const std::vector<fs::path>& recordings) {
  std::vector<fs::path> files;
  for (const fs::path& path : recordings) {
    if (!fs::exists(path)) throw spec::InputError(path.string(), 0, 0, "cannot be read: No such file or directory");
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    std::vector<fs::path> inside;
    for (const auto& entry : fs::directory_iterator(path))
      if (entry.path().extension() == ".csv") inside.push_back(entry.path());
    std::ranges::sort(inside);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

class Judge {
 public:
  explicit Judge(const JudgeKitOptions& options) : options_(options) {
    verdict_.kit = read_kit(options.folder);
    const spec::Decimal tolerance = options.tolerance.value_or(verdict_.kit.tolerance);
    const std::string most = with_point(verdict_.kit.tolerance);
    if (tolerance.negative || tolerance.is_zero()) throw spec::InputError("--tolerance", 0, 0, "must be positive");
    if (spec::compare(tolerance, verdict_.kit.tolerance) == std::strong_ordering::greater)
      throw spec::InputError("--tolerance", 0, 0, "must be at most the tolerance of the kit, " + most);
    verdict_.tolerance = judge::approximate(tolerance);
  }

  KitVerdict judged() {
    for (const fs::path& file : files_of(options_.recordings)) take(file);
    for (const KitProgram& program : verdict_.kit.programs)
      if (program.alarm.empty() && !recorded(program.number))
        verdict_.programs.push_back({program.number, ProgramVerdict::missing, {}, "not recorded", {}, {}});
    sort_by(verdict_.programs, &JudgedProgram::number);
    alarms();
    verdict_.shown = shown();
    return std::move(verdict_);
  }

 private:
  [[nodiscard]] bool recorded(unsigned number) const {
    return std::ranges::find(verdict_.programs, number, &JudgedProgram::number) != verdict_.programs.end();
  }

  [[nodiscard]] const KitProgram* program_of(unsigned number) const {
    const auto found = std::ranges::find(verdict_.kit.programs, number, &KitProgram::number);
    return found == verdict_.kit.programs.end() || !found->alarm.empty() ? nullptr : &*found;
  }

  void take(const fs::path& file) {
    spec::expect_plain_file(file.string());
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw spec::InputError(file.string(), 0, 0, "cannot be read");
    const Machine& machine = verdict_.kit.machine;
    certify::Recording reader(stream, file.string(), machine.setup.axes, machine.setup.units);
    const RecordedRun recording = rest_of(reader);
    if (!recording.has_time) {
      take_by_name(file, recording);
      return;
    }
    const std::vector<Rest> rests =
        find_rests(recording, mark_place(machine, options_.machine_coordinates, verdict_.tolerance));
    for (const Found& found : find_programs(rests)) {
      const unsigned number = kFirstProgram + found.number;
      const KitProgram* const program = program_of(number);
      if (program == nullptr)
        verdict_.strangers.push_back(fmt::format("{}:{}: {}", file.string(),
                                                 recording.samples[rests[found.first_rest].first].line,
                                                 program_name(machine.setup.control, number)));
      else if (!found.end_rest)
        verdict_.programs.push_back(
            {number, ProgramVerdict::missing, file.string(), "the end of its recording is missing", {}, {}});
      else
        judge(*program, file, SampleRange(recording, rests[found.first_rest].first, rests[*found.end_rest].last + 1));
    }
  }

  // Without time there are no rests: the whole file is the program that it is named after.
  void take_by_name(const fs::path& file, const RecordedRun& recording) {
    for (const KitProgram& program : verdict_.kit.programs)
      if (program.alarm.empty() && file.stem() == program_name(verdict_.kit.machine.setup.control, program.number) &&
          !recording.samples.empty()) {
        judge(program, file, SampleRange(recording, 0, recording.samples.size()));
        return;
      }
    throw spec::InputError(file.string(), 1, 1,
                           "no time column, so programs cannot be found by their rests; name the file after its "
                           "program, as in O8001.csv");
  }

  void judge(const KitProgram& program, const fs::path& file, SampleRange samples) {
    spec::Case c;
    const fs::path setup = options_.folder / program.setup;
    c.setup = spec::read_setup_toml(spec::read_file(setup.string()), setup.string());
    c.dialect = spec::dialect_of(c.setup.control);
    c.program = spec::read_file((options_.folder / program.file).string());
    const fs::path expected = options_.folder / program.expected;
    if (event_lines(judge::run_model(c), c.setup.axes) != spec::read_file(expected.string()))
      throw spec::InputError(expected.string(), 0, 0,
                             "is not what this version of toolcomp expects; make the kit again");
    c.program = between_rests(c.program, program.marks);
    JudgedProgram judged{program.number, ProgramVerdict::conforms, file.string(), {}, {}, {}};
    TraceOptions how;
    how.tolerance = verdict_.tolerance;
    how.judge_rapids = !options_.rapids_by_axis;
    how.pictures = false;
    // Klartext programs count from the preset.
    if (options_.machine_coordinates && c.setup.control == spec::Control::fanuc) how.frame = PathFrame::machine;
    judged.trace = judge_trace(c, samples, how);
    const int status = certify::exit_status(judged.trace);
    if (status == 1) judged.verdict = ProgramVerdict::differs;
    if (status == 3) judged.verdict = ProgramVerdict::undecided;
    judged.why = judged.trace.undecided;
    for (std::size_t i = 0; i < program.cases.size(); ++i)
      if (std::ranges::any_of(judged.trace.findings, [&](const TraceFinding& finding) {
            return finding.line >= program.cases[i].lines.first && finding.line <= program.cases[i].lines.end;
          }))
        judged.cases_off.push_back(i);
    verdict_.programs.push_back(std::move(judged));
  }

  void alarms() {
    const fs::path form = options_.alarms.empty() ? options_.folder / kAlarmForm : options_.alarms;
    const std::vector<NotedAlarm> noted = read_alarm_form(spec::read_file(form.string()), form.string(), verdict_.kit);
    for (const KitProgram& program : verdict_.kit.programs) {
      if (program.alarm.empty()) continue;
      JudgedAlarm judged{program.number, AlarmVerdict::not_noted, {}};
      if (const auto entry = std::ranges::find(noted, program.number, &NotedAlarm::number); entry != noted.end()) {
        judged.verdict = judge_alarm(program, *entry);
        judged.noted = entry->alarm + (entry->block.empty() ? "" : " N" + entry->block);
      }
      verdict_.alarms.push_back(std::move(judged));
    }
  }

  // A finding that belongs to no case, and findings left out of a long list, spoil a whole program.
  [[nodiscard]] std::size_t shown() const {
    std::set<std::string> outcomes;
    for (const JudgedProgram& judged : verdict_.programs) {
      if (judged.verdict != ProgramVerdict::conforms) continue;
      for (const KitCase& c : program_of(judged.number)->cases) outcomes.insert(c.shows.begin(), c.shows.end());
    }
    for (const JudgedAlarm& judged : verdict_.alarms) {
      if (judged.verdict != AlarmVerdict::as_expected) continue;
      const auto program = std::ranges::find(verdict_.kit.programs, judged.number, &KitProgram::number);
      for (const KitCase& c : program->cases) outcomes.insert(c.shows.begin(), c.shows.end());
    }
    return outcomes.size();
  }

  const JudgeKitOptions& options_;
  KitVerdict verdict_;
};

}  // namespace

KitVerdict judge_kit(const JudgeKitOptions& options) { return Judge(options).judged(); }

int exit_status(const KitVerdict& verdict) {
  const auto any = [&verdict](ProgramVerdict program) {
    return std::ranges::any_of(verdict.programs, [program](const JudgedProgram& p) { return p.verdict == program; });
  };
  const auto any_alarm = [&verdict](AlarmVerdict alarm) {
    return std::ranges::any_of(verdict.alarms, [alarm](const JudgedAlarm& a) { return a.verdict == alarm; });
  };
  if (any(ProgramVerdict::differs) || any_alarm(AlarmVerdict::other_alarm) || any_alarm(AlarmVerdict::none_came))
    return 1;
  const bool open =
      any(ProgramVerdict::missing) || any(ProgramVerdict::undecided) || any_alarm(AlarmVerdict::not_noted);
  return open ? 3 : 0;
}

std::string_view name(ProgramVerdict verdict) {
  switch (verdict) {
    case ProgramVerdict::conforms:
      return "conforms";
    case ProgramVerdict::differs:
      return "differs";
    case ProgramVerdict::undecided:
      return "undecided";
    case ProgramVerdict::missing:
      break;
  }
  return "missing";
}

std::string_view name(AlarmVerdict verdict) {
  switch (verdict) {
    case AlarmVerdict::as_expected:
      return "as expected";
    case AlarmVerdict::other_alarm:
      return "another alarm";
    case AlarmVerdict::none_came:
      return "none came";
    case AlarmVerdict::not_noted:
      break;
  }
  return "not noted";
}

}  // namespace toolcomp::certify::kit
