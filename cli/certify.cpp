// SPDX-License-Identifier: Apache-2.0
// toolcomp certify: a controller or a recorded trace against the exact model, and a report.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "certify/adapter.h"
#include "certify/adapter_programs.h"
#include "certify/badge.h"
#include "certify/certification.h"
#include "certify/report.h"
#include "certify/running_report.h"
#include "certify/trace/trace.h"
#include "cli/adapter_names.h"
#include "cli/certify_adapter.h"
#include "cli/evidence.h"
#include "cli/manners.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "cli/verbs.h"
#include "corpus/golden.h"
#include "host/date.h"
#include "host/file_writer.h"
#include "host/process.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"
#include "spec/language/known.h"
#include "spec/language/printable.h"
#include "spec/language/split.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void usage(const std::string& message) { throw spec::InputError("toolcomp certify", 0, 0, message); }

// A case, a file of cases (one JSON line each), or a program.
std::vector<spec::Case> read_inputs(const CertifyOptions& options) {
  std::vector<spec::Case> cases;
  for (const std::string& path : options.inputs) {
    if (fs::path(path).extension() == ".jsonl") {
      std::vector<spec::Case> read = corpus::read_cases(path);
      if (read.empty()) throw spec::InputError(path, 1, 1, "contains no case");
      for (spec::Case& c : read) {
        expect_readable(c, path + ": " + c.id);
        if (options.samples) c.samples = *options.samples;
        cases.push_back(std::move(c));
      }
    } else {
      const bool json = fs::path(path).extension() == ".json";
      const Program program(path, json ? std::string() : options.setup, options.samples);
      cases.push_back(program.as_case());
      expect_readable(cases.back(), program.is_case() ? path + ": program" : path);
    }
  }
  return cases;
}

double number_of(const std::string& text, const std::string& option, const std::string& what) {
  std::size_t used = 0;
  double number = 0;
  try {
    number = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || used < text.size()) usage(option + " takes " + what);
  return number;
}

Tolerances tolerances_of(const CertifyOptions& options) {
  const auto positive = [](const std::string& text, const std::string& option,
                           const std::string& what) -> std::optional<double> {
    if (text.empty()) return std::nullopt;
    const double value = number_of(text, option, what);
    if (!(value > 0) || !std::isfinite(value)) usage(option + " must be a positive number");
    return value;
  };
  return {positive(options.tolerance, "--tolerance", "a length"),
          positive(options.rotary_tolerance, "--rotary-tolerance", "degrees")};
}

// Why less was judged than a reader might think.
void say_how_the_path_ends(const certify::TraceResult& result, const std::string& program) {
  const std::string name = spec::printable(spec::display_name(program));
  if (!result.undecided.empty()) std::cerr << name << ": " << spec::printable(result.undecided) << '\n';
  for (const spec::Event<double>& event : result.events)
    if (event.kind == spec::EventKind::alarm)
      std::cerr << name << ':' << event.line << ": the path ends in " << event.number.view() << '\n';
  if (result.undecided.empty() && result.corners == 0) std::cerr << name << ": no move to judge\n";
  if (result.corners > 0 && result.samples == 0) std::cerr << "the trace contains no sample\n";
}

// The formal specification of this command.
constexpr std::string_view kSpecification = "spec";
constexpr std::string_view kFastEngine = "fast";  // in this process

// A program that speaks the protocol, as a shell is told.
std::string command_of(const std::string& controller) {
  if (controller == kFastEngine) return {};
  if (controller != kSpecification) return controller;
  return host::shell_quoted(fs::read_symlink("/proc/self/exe").string()) + " serve --engine spec";
}

bool is_ours(const std::string& controller) { return controller == kSpecification || controller == kFastEngine; }

spec::KnownSet known_of(const CertifyOptions& options) {
  if (!options.known) return {};
  std::vector<std::string> names;
  for (const std::string_view name : spec::split(*options.known, ',')) names.emplace_back(name);
  try {
    return spec::KnownSet::of(names);
  } catch (const std::invalid_argument& error) {
    usage(std::string("--known: ") + error.what());
  }
}

// A recording is held against the path whole: one place leads to the next.
void refuse_known(const CertifyOptions& options) {
  if (options.known) usage("--known is only for controllers that answer; a recording is judged as a whole");
}

std::optional<certify::Adapter> adapter_named(const CertifyOptions& options) {
  if (is_ours(options.controller)) return std::nullopt;
  if (!certify::is_adapter_name(options.controller)) return std::nullopt;
  return certify::find_adapter(options.controller, certify::adapter_folders(options.adapters));
}

// Programs for the machines an adapter names, of the sections asked for.
std::vector<certify::CaseInput> machine_cases(const certify::Adapter& adapter, const CertifyOptions& options) {
  std::vector<certify::CaseInput> inputs;
  if (adapter.setups.empty()) return inputs;
  for (certify::MachineProgram& program :
       certify::machine_programs(adapter.setups, options.cases.value_or(1000), options.seed))
    if (options.sections.empty() || std::ranges::find(options.sections, program.c.section) != options.sections.end())
      inputs.push_back({std::move(program.c), certify::Origin::generated});
  return inputs;
}

// Before anything is asked: a badge of an earlier run says nothing of this one, and a file that cannot be written is
// bad usage.
void begin_badge(const CertifyOptions& options) {
  if (options.badge.empty()) return;
  if (fs::is_directory(options.badge)) throw spec::InputError("--badge", 0, 0, options.badge + " is a folder");
  if (const fs::path folder = fs::path(options.badge).parent_path(); !folder.empty())
    expect_folder(folder.string(), "--badge");
  write_badge(options, certify::unfinished_badge());
}

certify::Occasion occasion_of(const CertifyOptions& options) {
  return {host::date_of_now(), options.operated, options.serial, options.arguments};
}

int certify_trace(const CertifyOptions& options) {
  if (options.inputs.size() != 1) usage("--trace judges one program; name one");
  if (options.tolerance.empty()) usage("--trace needs --tolerance");
  certify::TraceReport report;
  report.c = read_inputs(options).front();
  report.file = options.trace;
  report.occasion = occasion_of(options);
  const Tolerances tolerances = tolerances_of(options);
  report.options.tolerance = *tolerances.linear;
  report.options.rotary_tolerance = tolerances.rotary;
  if (options.frame == "machine") report.options.frame = certify::PathFrame::machine;
  spec::expect_plain_file(options.trace);
  std::ifstream csv(options.trace);
  if (!csv) throw spec::InputError(options.trace, 0, 0, "cannot be read");
  begin_badge(options);
  report.result = certify::judge_trace(report.c, csv, options.trace, report.options);
  certify::write_report(report, options.report);
  write_badge(options, certify::badge_json(report));
  fmt::print("{} samples, {} off the path, {} of {} corners missed, worst accepted {:.6g}\n", report.result.samples,
             report.result.off, report.result.corners_missed, report.result.corners, report.result.worst.upper);
  if (report.result.cause) fmt::print("one mistake explains everything found: {}\n", *report.result.cause);
  for (const certify::TraceFinding& finding : report.result.findings)
    fmt::print("{}:{}: {} of line {} by {}\n", spec::printable(options.trace), finding.sample, finding.kind,
               finding.line, certify::extent(finding));
  say_how_the_path_ends(report.result, options.inputs.front());
  return certify::exit_status(report.result);
}

std::string shown(const std::string& section) { return section.empty() ? "programs" : section; }

void print(const certify::SectionResult& s) {
  const std::uint64_t not_applicable = s.count(certify::Result::not_applicable);
  const std::uint64_t by_design = certify::sum_of(s.known_differences);
  if (not_applicable == s.total()) {
    fmt::print("{:<34} not applicable{}\n", shown(s.section),
               by_design > 0 ? fmt::format(", {} cases known to differ", by_design) : "");
    return;
  }
  fmt::print(
      "{:<34} {:>6} cases, {:>6} agree, {:>4} differ, {:>4} undecided, {:>8} values, {} ties, worst {:.3g} ulp "
      "{:.3g} µm, {} values not judged, {} events out of scope, {} cases with fewer than three events",
      shown(s.section), s.total(), s.count(certify::Result::agrees), s.count(certify::Result::differs),
      s.count(certify::Result::undecided), s.values, s.ties, s.worst_ulp, s.worst_um, s.wide, s.out_of_scope,
      s.few_events);
  if (const std::uint64_t part = s.count(certify::Result::partly_judged); part > 0) fmt::print(", {} in part", part);
  if (s.left_out > 0) fmt::print(", {} of {} events left out", s.left_out, s.left_out + s.events);
  if (not_applicable > 0) fmt::print(", {} not applicable", not_applicable);
  if (by_design > 0) fmt::print(", {} of these known to differ", by_design);
  if (const std::uint64_t not_run = s.count(certify::Result::not_run); not_run > 0) fmt::print(", {} not run", not_run);
  fmt::print("\n");
}

// A group of findings, by the one that stands for it.
void print(const certify::SharedCause& group, const certify::Finding& finding, const fs::path& file) {
  const bool explained = !group.words.starts_with("not explained");
  const std::string known = certify::how_known(finding);
  fmt::print("\n{} {} {} ({} cases, first {}{})\n{}  {}{}, in {} finding{}\n  {}\n{}  toolcomp replay {}\n",
             painted(Paint::bad, "FINDING", Stream::out), finding.key.kind, finding.key.clause, group.cases,
             spec::printable(finding.first_case), certify::how_it_comes(finding),
             known.empty() ? "" : fmt::format("  known as {}\n", known), explained ? "likely cause: " : "",
             spec::printable(group.words), group.findings.size(), group.findings.size() == 1 ? "" : "s",
             spec::printable(certify::explanation(finding), 2000), spec::printable_lines(finding.smallest.program),
             file.string());
}

void print(const certify::Certificate& certificate, const std::vector<fs::path>& findings, const std::string& report,
           double seconds) {
  for (const certify::SectionResult& section : certificate.sections) print(section);
  for (const certify::Unsettled& unsettled : certificate.unsettled)
    std::cerr << spec::printable(unsettled.id) << ": " << certify::name(unsettled.result)
              << (unsettled.why.empty() ? "" : ", " + spec::printable(unsettled.why)) << '\n';
  for (const certify::SharedCause& group : certificate.causes)
    print(group, certificate.findings[group.findings.front()], findings[group.findings.front()]);
  if (!findings.empty())
    fmt::print("\n{} findings; {} (--settle)\n", findings.size(), certify::words_on_settling(certificate));
  if (!certificate.self_check.empty()) std::cerr << "self-check failed: " << certificate.self_check << '\n';
  if (!certificate.without_effect.empty())
    fmt::print("codes that were read and have no effect on what is judged: {}\n",
               fmt::join(certificate.without_effect, " "));
  if (!certificate.chatter.empty())
    std::cerr << "the controller writes lines on its standard output that are not answers: "
              << spec::printable(certificate.chatter) << '\n';
  for (const certify::SectionResult& section : certificate.sections)
    if (certify::too_many_wide(section.values, section.wide))
      fmt::print("{}: {}\n", shown(section.section), certify::words_on_wide(section.values, section.wide));
  if (const std::uint64_t not_run = certify::cases_not_run(certificate); not_run > 0)
    fmt::print("{} cases not run{}\n", not_run, certificate.interrupted.empty() ? "" : ": " + certificate.interrupted);
  fmt::print("{}\n", certify::words_on_known(certificate));
  if (const std::string left_out = certify::words_on_left_out(certificate); !left_out.empty())
    std::cerr << painted(Paint::doubtful, left_out, Stream::err) << '\n';
  const int status = certify::exit_status(certificate);
  const Paint paint = status == kAgrees ? Paint::good : status == kDiffers ? Paint::bad : Paint::doubtful;
  fmt::print("{}; seed {}; {:.0f} s; {}\n", painted(paint, certify::verdict(certificate), Stream::out),
             certificate.identity.seed, seconds, (fs::path(report) / "index.html").string());
}

// Lengths in micrometres; an angle or a component of a unit vector counts as what it moves at the end of one metre.
void print_widths(const certify::Certificate& certificate) {
  fmt::print("{:<32} {:>8} {:>10} {:>10} {:>10} {:>9} {:>9}\n", "widths granted, µm", "values", "median", "99 %",
             "largest", "> 1 nm", "> 1 µm");
  constexpr double median = 0.5;
  constexpr double most = 0.99;
  for (const certify::SectionResult& section : certificate.sections) {
    const judge::Widths& widths = section.widths;
    fmt::print("{:<32} {:>8} {:>10.2g} {:>10.2g} {:>10.2g} {:>7.3f} % {:>7.3f} %\n", shown(section.section),
               widths.count(), widths.quantile(median), widths.quantile(most), widths.largest(),
               100 * widths.share_above_nm(), 100 * widths.share_above_um());
  }
}

}  // namespace

int certify(const CertifyOptions& options) {
  if (options.controller.empty() == options.trace.empty()) usage("name a --controller or a --trace");
  const auto adapter = adapter_named(options);
  if (!adapter && !is_ours(options.controller)) expect_no_slip(options.controller, options.adapters);
  if (options.packages) {
    if (options.controller == kSpecification) fmt::print("coq\nocaml-nox\nocaml-findlib\n");
    if (adapter)
      for (const std::string& package : adapter->packages) fmt::print("{}\n", package);
    return 0;
  }
  expect_folder(options.report, "--report");
  if (!options.trace.empty()) {
    refuse_known(options);
    refuse_evidence(options, "a trace has no answers to keep; the recording itself is the evidence");
    return certify_trace(options);
  }
  if (options.controller == kFastEngine)
    refuse_evidence(options, "the fast engine in this process gives no answers to keep");
  Evidence evidence(options);

  certify::CertificationOptions certification;
  certification.controller = command_of(options.controller);
  if (adapter) {
    certify::expect_programs(*adapter);
    if (adapter->kind == certify::AdapterKind::trace) {
      refuse_known(options);
      refuse_evidence(options, "a recorded controller has no answers to keep; its recordings are in the report");
      begin_badge(options);
      return certify_adapter(options, *adapter, read_inputs(options), tolerances_of(options), occasion_of(options));
    }
    certification.controller = adapter->shell_command();
  }
  certification.sections = options.sections;
  certification.seed = options.seed;
  certification.accepted_resolution = options.accept_resolution;
  certification.known = known_of(options);
  certification.settling.budget =
      options.settle == "0" ? std::chrono::seconds(0) : duration_of(options.settle, "--settle");
  certification.timeout = std::chrono::milliseconds(std::llround(options.timeout * 1000));
  for (spec::Case& c : read_inputs(options)) certification.cases.push_back({std::move(c), certify::Origin::own});
  if (adapter && options.inputs.empty())
    for (certify::CaseInput& input : machine_cases(*adapter, options)) certification.cases.push_back(std::move(input));
  // Cases named are judged alone, unless the corpus or generated cases are asked for too.
  const bool alone = !options.inputs.empty();
  certification.generated = options.cases.value_or(alone ? 0 : certification.generated);
  fs::path golden;
  if (!alone || !options.corpus.empty()) {
    const fs::path folder = options.corpus.empty() ? corpus::default_folder() : fs::path(options.corpus);
    for (spec::Case& c : corpus::read_golden(folder, options.sections)) {
      c.has_expect = false;  // the model says it again
      c.expect = {};
      certification.cases.push_back({std::move(c), certify::Origin::golden});
    }
    const corpus::Manifest manifest = corpus::read_manifest(folder);
    certification.corpus = manifest.version;
    certification.corpus_hash = manifest.hash;
    golden = folder;
  }
  detail("controller: " + certification.controller);
  detail(fmt::format("{} cases read, {} generated in each section, seed {}", certification.cases.size(),
                     certification.generated, certification.seed));
  if (!golden.empty()) detail(fmt::format("corpus {} of {}", certification.corpus, golden.string()));
  evidence.begin(certification, adapter ? adapter->name : "", golden);
  begin_badge(options);
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  certify::RunningReport running(options.report, certification.controller);
  if (!running.earlier().empty()) note(options.report + ": " + running.earlier());
  const Stop stop(options.time_limit.empty() ? std::nullopt
                                             : std::optional(duration_of(options.time_limit, "--time-limit")));
  certification.stop = [&stop] { return stop.why(); };
  certification.found = [&running](const certify::Finding& finding) { running.found(finding); };
  const Progress progress("cases");
  certification.progress = [&running, elapsed](std::uint64_t done, std::uint64_t all) {
    running.progress(done, all);
    Progress::line(fmt::format("{} of {} cases, {:.0f} s", done, all, elapsed()));
  };
  certification.choosing = [elapsed](const std::string& section, std::uint64_t looked_at) {
    Progress::line(fmt::format("{}: cases chosen out of {}, {:.0f} s", section, looked_at, elapsed()));
  };
  std::size_t begun = 0;
  certification.settling.told = [&](const certify::SettlingGroup& group) {
    const std::string line = fmt::format("group {} of {}: {}", group.number, group.groups, group.cause.words);
    if (can_redraw())
      Progress::line(fmt::format("{:.0f} s, settling {}", elapsed(), line));
    else if (group.number > begun)
      note(fmt::format("settling, at most {} for all groups: {}", options.settle, line));
    begun = group.number;
  };
  certify::Certificate certificate = certify::certify(certification);
  certificate.occasion = occasion_of(options);
  if (adapter)
    for (const auto& [id, cases] : certify::known_differences(certificate))
      if (const auto* known = adapter->known_difference(id)) certificate.known_reasons[id] = known->reason;
  const std::vector<fs::path> findings = certify::write_report(certificate, options.report);
  write_badge(options, certify::badge_json(certificate));
  print(certificate, findings, options.report, elapsed());
  evidence.finish(certificate, findings);
  if (options.widths) print_widths(certificate);
  return certify::exit_status(certificate);
}

}  // namespace toolcomp::cli
