// SPDX-License-Identifier: Apache-2.0
#include "certify/adapter_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "certify/adapter_batch.h"
#include "certify/adapter_programs.h"
#include "certify/report.h"
#include "host/process.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify {
namespace {

namespace fs = std::filesystem;

const spec::Event<double>* alarm_of(const std::vector<spec::Event<double>>& events) {
  const auto found = std::ranges::find(events, spec::EventKind::alarm, &spec::Event<double>::kind);
  return found == events.end() ? nullptr : &*found;
}

std::string words_of(const spec::Event<double>& alarm) {
  return fmt::format("{} in line {}", alarm.number.view(), alarm.line);
}

class Judge {
 public:
  Judge(const Adapter& adapter, double tolerance, std::optional<double> rotary_tolerance) : adapter_(adapter) {
    options_.tolerance = tolerance;
    options_.rotary_tolerance = rotary_tolerance;
  }

  void judge(AdapterRun& run) const {
    if (const auto why = first_line(run.folder / "not_applicable.txt")) {
      run.outcome = RunOutcome::not_applicable;
      run.why = *why;
      return;
    }
    const std::vector<KnownPlace> places = read_known_places(run.folder / "known.txt", adapter_);
    if (const auto words = first_line(run.folder / "alarm.txt")) return judge_alarm(run, *words, places);
    const fs::path trace = run.folder / "trace.csv";
    std::ifstream csv(trace, std::ios::binary);
    if (!csv) {
      run.why = first_line(run.folder / "failed.txt").value_or("the adapter wrote nothing");
      return;
    }
    run.result = judge_trace(run.c, csv, trace.string(), options_);
    judge_findings(run, places);
  }

  // A known difference that its own program does not show is one no longer.
  static void expect_difference(AdapterRun& run) {
    const bool shown = std::ranges::find(run.known, run.expected) != run.known.end();
    const bool decided = run.outcome == RunOutcome::conforms || run.outcome == RunOutcome::both_refuse ||
                         run.outcome == RunOutcome::known;
    if (run.expected.empty() || shown || !decided) return;
    run.outcome = RunOutcome::differs;
    run.why = "the known difference \"" + run.expected + "\" did not show";
  }

 private:
  // The model is asked for its events alone: a trace without samples.
  void judge_alarm(AdapterRun& run, const std::string& words, const std::vector<KnownPlace>& places) const {
    std::string header;
    for (std::size_t i = 0; i < run.c.setup.axes.size(); ++i)
      header += fmt::format("{}{}", i == 0 ? "" : ",", run.c.setup.axes.letter(i));
    std::istringstream empty(header + "\n");
    run.result = judge_trace(run.c, empty, "alarm.txt", options_);
    if (!run.result.undecided.empty()) {
      run.outcome = RunOutcome::undecided;
      run.why = run.result.undecided;
    } else if (const auto* alarm = alarm_of(run.result.events)) {
      run.outcome = RunOutcome::both_refuse;
      run.why = words_of(*alarm) + "; " + words;
    } else if (!places.empty()) {
      run.outcome = RunOutcome::known;
      for (const KnownPlace& place : places) run.known.push_back(place.id);
      run.why = words;
    } else {
      run.outcome = RunOutcome::differs;
      run.why = "refused: " + words;
    }
  }

  void judge_findings(AdapterRun& run, const std::vector<KnownPlace>& places) const {
    const auto place_at = [&](std::uint64_t line) {
      const auto place =
          std::ranges::find_if(places, [&](const KnownPlace& p) { return p.first <= line && line <= p.last; });
      return place == places.end() ? std::string() : place->id;
    };
    if (const auto* alarm = alarm_of(run.result.events)) return judge_running_on(run, *alarm, place_at(alarm->line));
    const int status = exit_status(run.result);
    if (status == 3) {
      run.outcome = RunOutcome::undecided;
      run.why = run.result.undecided.empty() ? "nothing was judged" : run.result.undecided;
      return;
    }
    run.outcome = status == 0 ? RunOutcome::conforms : RunOutcome::known;
    for (const TraceFinding& finding : run.result.findings) {
      const std::string id = place_at(finding.line);
      if (id.empty()) {
        run.outcome = RunOutcome::differs;
        run.why = fmt::format("{} of line {} by {}", finding.kind, finding.line, extent(finding));
        return;
      }
      if (std::ranges::find(run.known, id) == run.known.end()) run.known.push_back(id);
    }
    if (run.result.findings_total > run.result.findings.size()) {
      run.outcome = RunOutcome::differs;
      run.why = fmt::format("{} findings", run.result.findings_total);
    }
  }

  // The controller ran where the model gives an alarm: what it recorded behind that belongs to no path.
  void judge_running_on(AdapterRun& run, const spec::Event<double>& alarm, const std::string& place) const {
    const KnownDifference* known =
        place.empty() ? adapter_.without_alarm(alarm.number.view()) : adapter_.known_difference(place);
    run.why = "ran on where the model gives " + words_of(alarm);
    run.outcome = known == nullptr ? RunOutcome::differs : RunOutcome::known;
    if (known != nullptr) run.known.push_back(known->id);
  }

  const Adapter& adapter_;
  TraceOptions options_;
};

// Of all programs they would fill the memory.
void drop_pictures(TraceResult& result) {
  result.deviations = {};
  result.course = {};
  result.events = {};
}

double seconds_since(host::Clock::time_point begin) {
  return std::chrono::duration<double>(host::Clock::now() - begin).count();
}

spec::Setup read_setup(const fs::path& file) {
  return spec::read_setup_toml(spec::read_file(file.string()), file.string());
}

// The programs of the known differences: each must show itself.
std::vector<AdapterRun> known_runs(const Adapter& adapter) {
  std::vector<AdapterRun> runs;
  for (const KnownDifference& known : adapter.known) {
    AdapterRun& run = runs.emplace_back();
    run.c.id = known.id;
    run.c.program = known.program;
    run.c.setup = read_setup(known.setup);
    run.expected = known.id;
  }
  return runs;
}

// Given programs, then generated ones, in folders of their own.
std::vector<AdapterRun> write_batch(const AdapterCertificationOptions& certification, const fs::path& batch) {
  std::vector<AdapterRun> runs;
  for (const spec::Case& c : certification.cases) runs.emplace_back().c = c;
  if (certification.show_known)
    for (AdapterRun& run : known_runs(certification.adapter)) runs.push_back(std::move(run));
  for (MachineProgram& program :
       machine_programs(certification.adapter.setups, certification.generated, certification.seed)) {
    AdapterRun& run = runs.emplace_back();
    run.c = std::move(program.c);
    run.machine = std::move(program.machine);
  }
  if (runs.empty()) throw spec::InputError("certify", 0, 0, "no program to run");
  std::error_code none;
  fs::remove_all(batch, none);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    AdapterRun& run = runs[i];
    run.folder = batch_folder(batch, i);
    write_program(run.folder, run.c);
    for (const auto& [parameter, value] : certification.altered)
      if (const auto found = run.c.setup.parameters.find(parameter); found != run.c.setup.parameters.end())
        found->second = value;
  }
  return runs;
}

// Of a batch that was cut: programs without an answer, and the one of the newest recording, which may be cut itself.
void leave_out_unfinished(std::vector<AdapterRun>& runs) {
  fs::file_time_type newest = fs::file_time_type::min();
  std::vector<fs::file_time_type> written;  // of each, the latest of its answers
  std::error_code none;
  for (const AdapterRun& run : runs) {
    fs::file_time_type last = fs::file_time_type::min();
    for (const char* file : {"trace.csv", "alarm.txt", "not_applicable.txt", "failed.txt"})
      if (const fs::path answer = run.folder / file; fs::exists(answer, none))
        last = std::max(last, fs::last_write_time(answer, none));
    newest = std::max(newest, last);
    written.push_back(last);
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (written[i] != newest && written[i] != fs::file_time_type::min()) continue;
    runs[i].outcome = RunOutcome::not_run;
    runs[i].why = written[i] == fs::file_time_type::min() ? "not run" : "its recording may be incomplete";
  }
}

}  // namespace

std::string_view name(RunOutcome outcome) {
  static constexpr std::array<std::string_view, kRunOutcomes> kNames{
      "conforms", "both refuse", "known difference", "differs", "not applicable", "undecided", "failed", "not run"};
  return kNames.at(static_cast<std::size_t>(outcome));
}

AdapterCertificate certify_adapter(const AdapterCertificationOptions& certification) {
  AdapterCertificate certificate;
  certificate.tolerance = certification.tolerance.value_or(certification.adapter.tolerance);
  const fs::path batch = fs::path(certification.report) / "runs";
  certificate.runs = write_batch(certification, batch);
  const host::Clock::time_point start = host::Clock::now();
  certificate.errors = run_adapter(certification.adapter, "", batch, certificate.runs.size(), certification.timeout,
                                   certification.progress, certification.stop);
  certificate.seconds_run = seconds_since(start);
  const auto stopped = [&certification] { return certification.stop ? certification.stop() : std::string(); };
  const bool cut = !stopped().empty() && !certificate.errors.empty();
  if (cut) {
    certificate.errors.clear();
    certificate.interrupted = stopped();
    leave_out_unfinished(certificate.runs);
  }
  const host::Clock::time_point judged = host::Clock::now();
  const Judge judge(certification.adapter, certificate.tolerance, certification.rotary_tolerance);
  for (std::size_t i = 0; i < certificate.runs.size(); ++i) {
    AdapterRun& run = certificate.runs[i];
    if (run.outcome == RunOutcome::not_run) continue;
    if (!cut && certificate.interrupted.empty()) certificate.interrupted = stopped();
    if (!cut && !certificate.interrupted.empty()) {
      run.outcome = RunOutcome::not_run;
      run.why = "recorded, not judged";
      continue;
    }
    judge.judge(run);
    Judge::expect_difference(run);
    if (run.outcome != RunOutcome::differs) drop_pictures(run.result);
    std::error_code none;
    if (run.outcome == RunOutcome::conforms) fs::remove_all(run.folder, none);
    if (certification.progress && (i + 1) % 20 == 0)
      certification.progress(fmt::format("judged {} of {}", i + 1, certificate.runs.size()));
  }
  certificate.seconds_judged = seconds_since(judged);
  return certificate;
}

int exit_status(const AdapterCertificate& certificate) {
  const auto any = [&](RunOutcome outcome) {
    return std::ranges::any_of(certificate.runs, [&](const AdapterRun& run) { return run.outcome == outcome; });
  };
  if (any(RunOutcome::differs)) return 1;
  const bool judged = any(RunOutcome::conforms) || any(RunOutcome::both_refuse) || any(RunOutcome::known);
  const bool left_out = !certificate.errors.empty() || !certificate.interrupted.empty() || any(RunOutcome::failed) ||
                        any(RunOutcome::undecided);
  return left_out || !judged ? 3 : 0;
}

}  // namespace toolcomp::certify
