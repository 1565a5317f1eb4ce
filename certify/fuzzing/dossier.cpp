// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/dossier.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <sstream>
#include <string_view>
#include <tuple>

#include "certify/convert.h"
#include "certify/path_svg.h"
#include "certify/program_text.h"
#include "certify/report.h"
#include "certify/sort_by.h"
#include "fast/basis/print.h"
#include "fuzz/campaign/diary.h"
#include "host/file_writer.h"
#include "judge/oracle/verdict.h"
#include "model/basis/print.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/event_json.h"

namespace toolcomp::certify::fuzzing {
namespace {

namespace fs = std::filesystem;
constexpr int kDigits = 15;

std::string exact(const exact::Real& value) {
  std::string text;
  try {
    model::append_number(text, value, kDigits);
  } catch (const exact::Undecided&) {
    return "not known to " + std::to_string(kDigits) + " decimals";
  }
  if (!value.is_rational()) return text + "…";
  constexpr std::size_t kShort = 60;
  const std::string fraction = value.rational().str();
  return fraction.size() <= kShort && fraction.find('/') != std::string::npos ? text + " = " + fraction : text;
}

std::string_view sign(exact::Sign outcome) {
  return outcome == exact::Sign::positive ? "> 0" : outcome == exact::Sign::negative ? "< 0" : "= 0";
}

std::string words_on(const model::Decision& d) {
  std::string text =
      fmt::format("  {} (line {}): {} {}", spec::info(d.clause).id, d.line, exact(d.quantity), sign(d.outcome));
  if (d.scale.sign() == exact::Sign::positive)
    text += fmt::format("\n    margin {} of the scale {}", exact(d.quantity / d.scale), exact(d.scale));
  return text + "\n";
}

// The decisions at the first divergence: those by its clause, else those of its block, the nearest to a tie first.
std::string margins(const Finding& finding, const judge::ModelRun& run) {
  std::vector<const model::Decision*> at;
  const auto choose = [&](auto wanted) {
    if (!at.empty()) return;
    for (const model::Decision& d : run.recorder.decisions())
      if (wanted(d)) at.push_back(&d);
  };
  const auto by_clause = [&](const model::Decision& d) { return spec::info(d.clause).id == finding.key.clause; };
  choose([&](const model::Decision& d) { return by_clause(d) && d.line == finding.difference.line; });
  choose(by_clause);
  choose([&](const model::Decision& d) { return d.line == finding.difference.line; });
  if (at.empty()) return "no sign of a number was decided there\n";
  sort_by(at, [](const model::Decision* d) { return judge::margin(*d); });
  constexpr std::size_t kMost = 3;
  std::string text = at.size() > kMost ? fmt::format("the nearest {} of {} decisions there:\n", kMost, at.size())
                                       : "decisions there:\n";
  for (std::size_t i = 0; i < std::min(kMost, at.size()); ++i) text += words_on(*at[i]);
  return text;
}

template <class Number, class Append>
std::string lines(const std::vector<spec::Event<Number>>& events, const spec::Axes& axes, Append append) {
  std::string out;
  for (const spec::Event<Number>& event : events) {
    spec::append_event_json(out, event, axes, append);
    out += '\n';
  }
  return out;
}

std::string exact_events(const judge::ModelRun& run, const spec::Axes& axes) {
  return lines(run.events, axes, [](std::string& out, const exact::Real& value) {
    try {
      model::append_number(out, value, kDigits);
    } catch (const exact::Undecided&) {
      out += "null";
    }
  });
}

// Lines of finding.txt that are read again.
constexpr std::string_view kSection = "section   ";
constexpr std::string_view kShape = "shape     ";
constexpr std::string_view kCore = "core      ";
constexpr std::string_view kVoices = "voices    ";
constexpr std::string_view kNotKnown = "not known";
constexpr std::string_view kProgram = "The program:";

std::string story(const Dossier& dossier, const std::string& margin) {
  const Finding& f = dossier.finding;
  std::string text = accusation(f) + how_it_comes(f) + "\n\n";
  text += fmt::format("{}{}\nclause    {}\nkind      {}\n{}{}\n{}{}\nstage     {}{}\n", kSection, f.key.section,
                      f.key.clause.empty() ? "none" : f.key.clause, f.key.kind, kShape,
                      dossier.shape.empty() ? kNotKnown : dossier.shape, kCore,
                      dossier.core.empty() ? kNotKnown : dossier.core, name(dossier.stage),
                      dossier.why.empty() ? "" : ": " + dossier.why);
  if (!f.alone.empty()) text += fmt::format("{}{}\n", kVoices, f.alone);
  text += fmt::format("found by  {}, seed {}, execution {}, {:.1f} s after its worker began\n",
                      f.target.empty() ? "toolcomp fuzz" : f.target, f.seed, f.executions, f.seconds);
  if (!f.controller.empty()) text += "asked     " + f.controller + "\n";
  if (f.runs > 0) text += fmt::format("shrunk    in {} executions\n", f.runs);
  text += "repeat    toolcomp replay finding.json\n          toolcomp explain case.json\n\n";
  return text + "The decision, exactly: " + margin + "\n" + std::string(kProgram) + "\n" + f.smallest.program;
}

std::tuple<std::size_t, std::size_t, std::string, std::uint64_t> size_of(const Finding& finding) {
  std::string all = spec::write_case_line(finding.smallest);
  return {count_blocks(finding.smallest.program), all.size(), std::move(all), finding.executions};
}

bool stays(const fs::path& file, const Finding& other) {
  try {
    return !is_smaller(other, read_finding(spec::read_file(file.string()), file.string()));
  } catch (const std::exception&) {
    return false;  // half of one, of a process that was killed
  }
}

// `part` becomes `folder`. One that is there is exchanged at once: others read it meanwhile, and a kill leaves one of
// both.
void put_in_place(const fs::path& part, const fs::path& folder) {
  if (fs::exists(folder)) {
    if (::renameat2(AT_FDCWD, part.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0) {
      fs::remove_all(part);
      return;
    }
    fs::remove_all(folder);  // a file system that cannot exchange
  }
  fs::rename(part, folder);
}

// The input of a reader: bytes that are no case.
bool write_reader(const Dossier& dossier, const fs::path& folder, const fs::path& part) {
  const Finding& f = dossier.finding;
  const fs::path input = folder / "input";
  const bool fresh = !fs::exists(input);
  if (!fresh) {
    const std::string kept = spec::read_file(input.string());
    if (std::pair(kept.size(), kept) <= std::pair(f.smallest.program.size(), f.smallest.program)) return false;
  }
  host::write_file(part / "input", f.smallest.program);
  host::write_file(part / "finding.txt",
                   fmt::format("{} at an input of {}{}{}\n\nfound by  {}\nrepeat    build/fuzz/{} input\n", f.key.kind,
                               f.target, f.key.clause.empty() ? "" : ", ", f.key.clause, f.target, f.target));
  put_in_place(part, folder);
  return fresh;
}

}  // namespace

std::string_view name(Stage stage) {
  switch (stage) {
    case Stage::seen:
      return "seen";
    case Stage::gone:
      return "not reproduced";
    case Stage::reproduced:
      return "reproduced";
    case Stage::shrunk:
      break;
  }
  return "shrunk";
}

std::string Dossier::name() const {
  const FailureKey& key = finding.key;
  const std::string place = key.clause.empty() ? key.section.empty() ? finding.target : key.section : key.clause;
  std::string name;
  for (const char c : key.kind + "--" + place) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_';
    name += plain ? c : '-';
  }
  std::string all = key.section + '|' + key.kind + '|' + key.clause + '|' + shape;
  if (!finding.controller.empty()) all += '|' + finding.controller;
  return name + "--" + fuzz::digest(all).substr(0, 8);
}

std::vector<fs::path> dossiers_in(const fs::path& folder) {
  std::vector<fs::path> dossiers;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (fs::exists(entry.path() / "finding.txt") && !entry.path().filename().string().starts_with('.'))
        dossiers.push_back(entry.path());
  std::ranges::sort(dossiers);
  return dossiers;
}

Story read_story(const fs::path& dossier) {
  Story story;
  std::istringstream text(spec::read_file((dossier / "finding.txt").string()));
  std::getline(text, story.what);
  for (std::string line; std::getline(text, line) && line != kProgram;) {
    if (line.starts_with(kSection)) story.section = line.substr(kSection.size());
    if (line.starts_with(kShape)) story.shape = line.substr(kShape.size());
    if (line.starts_with(kVoices)) story.voices = line.substr(kVoices.size());
    if (line.starts_with(kCore)) story.core = line.substr(kCore.size());
  }
  story.program.assign(std::istreambuf_iterator<char>(text), {});
  if (story.shape == kNotKnown) story.shape.clear();
  if (story.core == kNotKnown) story.core.clear();
  return story;
}

bool is_smaller(const Finding& a, const Finding& b) { return size_of(a) < size_of(b); }

bool write_dossier(const Dossier& dossier, const fs::path& folder) {
  const Finding& f = dossier.finding;
  const fs::path part = folder.parent_path() / fmt::format(".{}.{}.part", folder.filename().string(), ::getpid());
  fs::remove_all(part);
  if (f.key.section.empty()) return write_reader(dossier, folder, part);
  const bool fresh = !fs::exists(folder / "finding.json");
  if (!fresh && stays(folder / "finding.json", f)) return false;
  const spec::Axes& axes = f.smallest.setup.axes;
  host::write_file(part / "case.json", spec::write_case(f.smallest));
  std::string margin = "not examined\n";
  if (dossier.stage != Stage::seen) {
    const judge::ModelRun run = judge::run_model(f.smallest);
    if (dossier.why.empty() && !run.events.empty()) {
      PathOptions options = path_options(f.smallest);
      options.other = f.actual_events;
      options.marked = f.difference.event;
      host::write_file(part / "picture.svg", path_svg(in_doubles(run.events), axes, options));
    }
    margin = margins(f, run);
    host::write_file(part / "expected.jsonl", exact_events(run, axes));
  }
  host::write_file(part / "actual.jsonl", lines(f.actual_events, axes, [](std::string& out, double value) {
                     fast::append_number(out, value);
                   }));
  host::write_file(part / "finding.txt", story(dossier, margin));
  host::write_file(part / "finding.json", write_finding(f));
  put_in_place(part, folder);
  return fresh;
}

}  // namespace toolcomp::certify::fuzzing
