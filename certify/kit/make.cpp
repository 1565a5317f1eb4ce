// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/make.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "certify/adapter_programs.h"
#include "certify/kit/alarm_form.h"
#include "certify/kit/choose.h"
#include "certify/kit/kit_json.h"
#include "certify/kit/marks.h"
#include "certify/kit/run_sheet.h"
#include "certify/sort_by.h"
#include "corpus/manifest.h"
#include "judge/oracle/number.h"
#include "judge/oracle/trial.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify::kit {
namespace {

// Numbers of programs: recorded ones from 8001, those that end in an alarm behind them.
constexpr unsigned kFirstStopped = 8501;
constexpr unsigned kFirstParameters = 8950;

// Parts of blocks under tool center point control, where travels are watched.
constexpr std::uint32_t kSamples = 8;

std::string setup_name(std::size_t group) { return fmt::format("setup-{}.toml", group); }

class Maker {
 public:
  Maker(const MakeOptions& options, Outcomes& outcomes, const Choice& choice, const Chooser& chooser)
      : options_(options), outcomes_(outcomes), choice_(choice), table_(chooser.offsets()) {
    offsets_.h = table_.h();
    offsets_.d = table_.d();
    offsets_.tools = chooser.tools().rows();
  }

  Kit make() {
    kit_.tool = "toolcomp " TOOLCOMP_VERSION;
    kit_.sections = options_.sections;
    kit_.tolerance = options_.tolerance;
    kit_.machine = options_.machine;
    kit_.machine.setup.h = table_.h();
    kit_.machine.setup.d = table_.d();
    if (is_klartext()) kit_.machine.setup.tools = offsets_.tools;
    add_groups();
    if (is_klartext())
      add_tools();
    else
      add_offsets();
    add_recorded();
    add_stopped();
    for (const std::size_t outcome : choice_.missing)
      kit_.missing.push_back({outcomes_.name(outcome), std::string(outcomes_.text(outcome)), choice_.why.at(outcome)});
    return std::move(kit_);
  }

 private:
  void add_groups() {
    for (std::size_t group = 0; group < choice_.groups.size(); ++group) {
      const Overlay& overlay = choice_.groups[group];
      kit_.groups.push_back({overlay, {}});
      kit_.files[setup_name(group)] = spec::write_setup_toml(program_setup(options_.machine, overlay, offsets_));
      if (overlay.empty()) continue;
      kit_.groups.back().program = file_name(kFirstParameters + static_cast<unsigned>(group));
      kit_.files[kit_.groups.back().program] =
          parameter_program(kFirstParameters + static_cast<unsigned>(group), overlay);
    }
  }

  // A byte is written as a whole, so bits are only typed in: what the machine has in the others is not known.
  static std::string parameter_program(unsigned number, const Overlay& overlay) {
    std::string text = fmt::format("%\nO{} (PARAMETERS)\n", number);
    std::string blocks;
    for (const auto& [id, value] : overlay)
      if (id.bit < 0)
        blocks += fmt::format("N{} R{}\n", id.number, with_point(value));
      else
        text += fmt::format("(BY HAND: {} BIT {} = {})\n", id.number, id.bit, spec::to_string(value));
    if (!blocks.empty()) text += "G10 L50\n" + blocks + "G11\n";
    return text + "M30\n%\n";
  }

  [[nodiscard]] bool is_klartext() const { return options_.machine.setup.control == spec::Control::heidenhain; }

  [[nodiscard]] std::string file_name(unsigned number) const {
    return kit::program_name(options_.machine.setup.control, number) + (is_klartext() ? ".h" : ".nc");
  }

  void add_tools() {
    kit_.files["tool.t"] = tool_file(offsets_.tools);
    std::string list = "number,L,R,R2,DL,DR,DR2\n";
    for (const spec::ToolRow& row : offsets_.tools)
      list += fmt::format("{},{},{},{},{},{},{}\n", row.number / 10, row.l ? spec::to_string(*row.l) : "",
                          spec::to_string(row.r), spec::to_string(row.r2), spec::to_string(row.dl),
                          spec::to_string(row.dr), spec::to_string(row.dr2));
    kit_.files["tools.csv"] = list;
  }

  void add_offsets() {
    kit_.offsets_program = file_name(kFirstProgram);
    std::string text = fmt::format("%\nO{} (OFFSETS)\nG90\n", kFirstProgram);
    std::string list = "table,number,geometry,wear\n";
    const auto add = [&](const std::map<std::uint32_t, spec::OffsetEntry>& entries, bool d) {
      for (const auto& [number, entry] : entries) {
        text += enter_offset(options_.machine.setup, number, entry, d);
        list += fmt::format("{},{},{},{}\n", table_.separate() ? (d ? "D" : "H") : "H and D", number,
                            spec::to_string(entry.geometry), spec::to_string(entry.wear));
      }
    };
    add(table_.h(), false);
    if (table_.separate()) add(table_.d(), true);
    kit_.files[kit_.offsets_program] = text + "M30\n%\n";
    kit_.files["offsets.csv"] = list;
  }

  // By parameters, then sections, so that a bundle is of one kind.
  [[nodiscard]] static std::vector<const Chosen*> in_order(const std::vector<Chosen>& chosen) {
    std::vector<const Chosen*> order;
    order.reserve(chosen.size());
    for (const Chosen& c : chosen) order.push_back(&c);
    sort_by(order, [](const Chosen* c) { return std::tuple(c->group, c->vector->section, c->vector->id); });
    return order;
  }

  // A case stands behind others if each does there what it does alone; else it begins a program of its own: some leave
  // traces that no end of a case takes away (the intermediate point of G28).
  void add_recorded() {
    std::vector<const Chosen*> bundle;
    unsigned number = kFirstProgram + 1;
    const auto close = [&] {
      if (!bundle.empty()) add_program(number++, ProgramKind::recorded, bundle);
      bundle.clear();
    };
    for (const Chosen* chosen : in_order(choice_.recorded)) {
      if (!bundle.empty() && (bundle.size() == options_.cases_a_program || bundle.back()->group != chosen->group))
        close();
      bundle.push_back(chosen);
      if (bundle.size() == 1 || independent(number, bundle)) continue;
      bundle.pop_back();
      close();
      bundle.push_back(chosen);
    }
    close();
    if (number > kFirstStopped) throw std::runtime_error("the kit has too many programs; ask for fewer sections");
  }

  [[nodiscard]] bool independent(unsigned number, const std::vector<const Chosen*>& bundle) const {
    const ProgramText program = text_of(number, ProgramKind::recorded, bundle);
    const judge::ModelRun run = judge::run_model(case_of(program, bundle, kSamples));
    return different_case(run, bundle, program) == nullptr;
  }

  [[nodiscard]] ProgramText text_of(unsigned number, ProgramKind kind, const std::vector<const Chosen*>& bundle) const {
    std::vector<CaseText> texts;
    texts.reserve(bundle.size());
    for (const Chosen* chosen : bundle) texts.push_back(chosen->run.text);
    const std::string title =
        kind == ProgramKind::recorded ? fmt::format("{} CASES", bundle.size()) : "MUST END IN AN ALARM";
    return write_program(options_.machine, number, title, kind, texts);
  }

  [[nodiscard]] spec::Case case_of(const ProgramText& program, const std::vector<const Chosen*>& bundle,
                                   std::uint32_t samples) const {
    spec::Case c;
    c.setup = program_setup(options_.machine, choice_.groups[bundle.front()->group], offsets_);
    c.program = program.text;
    c.samples = samples;
    return c;
  }

  // The first case that does not do in the program what it does alone.
  [[nodiscard]] const Chosen* different_case(const judge::ModelRun& run, const std::vector<const Chosen*>& bundle,
                                             const ProgramText& program) const {
    for (std::size_t i = 0; i < bundle.size(); ++i)
      if (CaseRunner::events_of(options_.machine, run, program.cases[i]) != bundle[i]->run.events) return bundle[i];
    return nullptr;
  }

  void add_stopped() {
    unsigned number = kFirstStopped;
    for (const Chosen* chosen : in_order(choice_.stopped)) add_program(number++, ProgramKind::stopped, {chosen});
    if (number > kFirstParameters) throw std::runtime_error("the kit has too many alarms; ask for fewer sections");
  }

  void add_program(unsigned number, ProgramKind kind, const std::vector<const Chosen*>& bundle) {
    const ProgramText program = text_of(number, kind, bundle);
    KitProgram entry{
        number, bundle.front()->group, file_name(number), setup_name(bundle.front()->group), {}, {}, program.marks, {},
        0};
    const judge::ModelRun run = checked(number, bundle, program);
    for (std::size_t i = 0; i < bundle.size(); ++i) {
      const Chosen& chosen = *bundle[i];
      KitCase c{chosen.vector->id, chosen.vector->section, chosen.same_machine, program.cases[i], {}};
      for (const std::size_t outcome : chosen.shows) c.shows.push_back(outcomes_.name(outcome));
      entry.cases.push_back(std::move(c));
    }
    if (kind == ProgramKind::stopped) {
      entry.alarm = bundle.front()->run.stop->number;
      // A Klartext program counts its lines from 0.
      const std::uint64_t block = bundle.front()->run.stop->block;
      entry.alarm_n = is_klartext() ? program.cases.front().first + block - 1 : 1000 + block + 1;
    } else {
      entry.expected = fmt::format("expected/{}.jsonl", kit::program_name(options_.machine.setup.control, number));
      kit_.files[entry.expected] = event_lines(run, options_.machine.setup.axes);
    }
    kit_.files[entry.file] = program.text;
    kit_.programs.push_back(std::move(entry));
  }

  // The whole program through both engines: they agree on it, and every case does in it what it does alone.
  judge::ModelRun checked(unsigned number, const std::vector<const Chosen*>& bundle, const ProgramText& program) const {
    const judge::Trial trial = judge::try_case(case_of(program, bundle, kSamples));
    const std::string name = file_name(number);
    if (trial.verdict.outcome == judge::Outcome::differs)
      throw std::runtime_error(name + ": the engines differ: " + judge::explain(*trial.verdict.difference));
    if (const Chosen* const different = different_case(trial.run, bundle, program))
      throw std::runtime_error(name + ": " + different->vector->id + " does not do here what it does alone");
    if (std::string why = outside_travels(options_.machine, trial.run.events); !why.empty())
      throw std::runtime_error(name + ": outside the travels: " + why);
    return judge::run_model(case_of(program, bundle, 0));
  }

  const MakeOptions& options_;
  Outcomes& outcomes_;
  const Choice& choice_;
  const OffsetTable& table_;
  spec::Setup offsets_;
  Kit kit_;
};

// Programs for this machine, as vectors: with tool center point control where it has kinematics, and without.
std::vector<corpus::Vector> generated_vectors(const MakeOptions& options) {
  std::vector<corpus::Vector> vectors;
  spec::Setup conventional = options.machine.setup;
  conventional.parameters.erase(spec::ParameterId{19680, -1});
  for (std::uint32_t i = 0; i < options.generated; ++i) {
    spec::Case c = machine_program(i % 2 == 0 ? options.machine.setup : conventional, program_seed(options.seed, i));
    c.setup.parameters = options.machine.setup.parameters;
    c.id = fmt::format("generated-{}-{}", options.seed, i + 1);
    if (options.sections.empty() || std::ranges::find(options.sections, c.section) != options.sections.end())
      vectors.push_back({{}, 0, {}, std::move(c)});
  }
  return vectors;
}

}  // namespace

Kit make(const MakeOptions& options) {
  expect_whole(options.machine);
  const corpus::Manifest manifest = corpus::read_manifest(options.corpus);
  const std::string_view control = options.machine.setup.control == spec::Control::fanuc ? "fanuc" : "heidenhain";
  std::vector<corpus::Vector> vectors =
      corpus::read_vectors(options.corpus, {.sections = options.sections, .share = {}});
  std::erase_if(vectors, [&](const corpus::Vector& v) { return v.c.setup.control != options.machine.setup.control; });
  if (options.machine.setup.control == spec::Control::fanuc)
    for (corpus::Vector& vector : generated_vectors(options)) vectors.push_back(std::move(vector));
  if (vectors.empty())
    throw spec::InputError("--section", 0, 0, fmt::format("no golden vector of these sections is for {}", control));
  Outcomes outcomes;
  const OutcomeSet wanted = outcomes.of_sections(options.sections, control);
  Chooser chooser(options.machine, outcomes, vectors, options.first_offset, judge::approximate(options.tolerance),
                  options.progress);
  if (options.why_not) chooser.leave_out(options.why_not);
  const Choice choice = chooser.choose(wanted);
  Kit kit = Maker(options, outcomes, choice, chooser).make();
  kit.corpus = manifest.version;
  kit.corpus_hash = manifest.hash;
  OutcomeSet recorded;
  OutcomeSet noted;
  for (const Chosen& chosen : choice.recorded) recorded = united(recorded, chosen.shows);
  for (const Chosen& chosen : choice.stopped) noted = united(noted, chosen.shows);
  kit.outcomes = wanted.size();
  kit.recorded = count_common(recorded, wanted);
  kit.noted = count_common(without(noted, recorded), wanted);
  kit.files[kAlarmForm] = write_alarm_form(kit);
  kit.files["run-sheet.html"] = write_run_sheet(kit);
  return kit;
}

}  // namespace toolcomp::certify::kit
