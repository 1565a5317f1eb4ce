// SPDX-License-Identifier: Apache-2.0
// What the page asks of the WebAssembly module: toolcomp_try() runs a program with its setup and gives JSON lines
// (README.md lists them). Nothing is read or written besides.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/input/program.h"
#include "certify/path_svg.h"
#include "certify/view/program_page.h"
#include "certify/view/program_run.h"
#include "cli/notes.h"
#include "cli/word_at_fault.h"
#include "fast/basis/print.h"
#include "fuzz/gen/program_text.h"
#include "judge/oracle/control.h"
#include "judge/oracle/number.h"
#include "model/basis/print.h"
#include "spec/coverage/report.h"
#include "spec/language/event_json.h"
#include "spec/language/json_text.h"
#include "spec/language/naming_clause.h"

namespace toolcomp::playground {
namespace {

using Json = nlohmann::ordered_json;

// The names of the two texts in messages.
const std::string kProgram = "program";
const std::string kSetup = "setup.toml";

// Beyond it a browser would hold too much of exact numbers, or of events at all.
constexpr std::size_t kMostExactBlocks = 20'000;
constexpr std::size_t kMostFastBlocks = 500'000;
constexpr std::uint32_t kMostSamples = 1'000;
constexpr int kMostDigits = 100;

struct Options {
  bool exact = true;  // both engines, the lines are those of the exact model; else the fast engine alone
  bool page = false;
  std::uint32_t samples = 0;
  int digits = 15;
  std::string name = "program";  // of the program, on the page
};

Options options_of(std::string_view text) {
  const Json json = Json::parse(text);
  Options options;
  options.exact = json.value("engine", "model") != "fast";
  options.page = json.value("page", false);
  options.samples = std::min(json.value("samples", options.samples), kMostSamples);
  options.digits = std::clamp(json.value("digits", options.digits), 0, kMostDigits);
  options.name = json.value("name", options.name);
  return options;
}

class Lines {
 public:
  explicit Lines(std::string& out) : out_(out) {}
  void add(const Json& json) {
    out_ += json.dump(-1, ' ', false, Json::error_handler_t::replace);
    out_ += '\n';
  }
  void add(const std::vector<cli::Note>& notes) {
    for (const cli::Note& note : notes) add({{"kind", "note"}, {"line", note.line}, {"text", note.text}});
  }
  void add(const fast::Event& event, const spec::Axes& axes) {
    spec::append_event_json(out_, event, axes, [](std::string& out, double value) { fast::append_number(out, value); });
    out_ += '\n';
  }
  void add(const model::Event& event, const spec::Axes& axes, int digits) {
    spec::append_event_json(out_, event, axes, [digits](std::string& out, const exact::Real& value) {
      model::append_number(out, value, digits);
    });
    out_ += '\n';
  }

 private:
  std::string& out_;
};

// The fast engine, with notes. The notes of the page are of it, too.
class FastRun final : public fast::EventSink {
 public:
  FastRun(const spec::Case& c, Lines& lines, bool with_events)
      : c_(c), lines_(lines), with_events_(with_events), notes_(c.setup) {}

  void on(const fast::Event& event) override {
    notes_.on(event, [](double value) { return value; });
    tell();
    if (with_events_) lines_.add(event, c_.setup.axes);
  }

  void run(std::size_t most_blocks) {
    judge::with_control(c_.setup, [&]<class Control>(Control) {
      auto engine = Control::fast(c_.setup, *this, c_.samples);
      auto reader = Control::reader(spec::text_source(c_.program), c_.setup, kProgram);
      const auto block = std::make_unique<typename Control::Block>();
      for (std::size_t blocks = 0; !engine.stopped() && reader.next(*block); ++blocks) {
        if (blocks == most_blocks)
          throw spec::InputError(kProgram, block->line, 0,
                                 fmt::format("runs more than {} blocks: no more are run here", most_blocks));
        notes_.read(*block);
        tell();
        engine.block(*block);
      }
      engine.end();
    });
    lines_.add(notes_.summary());
  }

 private:
  void tell() {
    if (notes_.wait()) lines_.add(notes_.take());
  }

  const spec::Case& c_;
  Lines& lines_;
  bool with_events_;
  cli::Notes notes_;
};

// What an alarm, a warning, or an event that is not judged says, where, and by which clause.
Json said(const model::Event& event, const certify::ProgramRun::Block& block, const std::vector<std::string>& text,
          const spec::Setup& setup) {
  Json json = {{"kind", "said"}, {"what", name(event.kind)}, {"line", event.line}};
  std::string more;
  if (event.kind == spec::EventKind::alarm && block.line == event.line) {
    json["line"] = block.fault_line;
    const bool known = block.fault_line > 0 && block.fault_line <= text.size();
    auto at = cli::at_fault(event.alarm, known ? text[block.fault_line - 1] : std::string(), block.fault_column, setup);
    json["column"] = at.column;
    more = std::move(at.more);
  }
  if (!event.number.view().empty()) json["number"] = event.number.view();
  json["text"] = event.message + more;
  if (event.kind == spec::EventKind::alarm && event.alarm == spec::AlarmCause::interference &&
      event.value.sign() == exact::Sign::positive)
    json["more"] = fmt::format("the paths cross by {:.6g}", judge::approximate(event.value));
  if (const std::optional<spec::Clause> clause = spec::naming_clause(event.clauses)) {
    json["clause"] = spec::info(*clause).id;
    json["clause_text"] = spec::show_clause(spec::info(*clause).id, spec::ReportFormat::text);
  }
  return json;
}

void run_exactly(const spec::Case& c, const Options& options, Lines& lines) {
  std::size_t blocks = 0;
  const certify::ProgramRun run = certify::run_program(c, kProgram, [&blocks] {
    if (blocks++ == kMostExactBlocks)
      throw spec::InputError(kProgram, 0, 0,
                             fmt::format("runs more than {} blocks: no more are run here", kMostExactBlocks));
  });
  const std::vector<std::string> text = fuzz::lines(c.program);
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    const model::Event& event = run.events[i];
    lines.add(event, c.setup.axes, options.digits);
    if (spec::ends_run(event.kind) || event.kind == spec::EventKind::warning ||
        event.kind == spec::EventKind::undecided)
      lines.add(
          said(event, run.blocks.empty() ? certify::ProgramRun::Block{} : run.blocks[run.block_of[i]], text, c.setup));
  }
  if (!options.page) return;
  const certify::ProgramView view{&run, {}, options.digits};
  lines.add({{"kind", "page"},
             {"html", certify::program_page(c, view, certify::path_options(c), {options.name, kSetup, {}})}});
}

void run(const std::string& program, const std::string& setup, const Options& options, Lines& lines) {
  const std::size_t first = setup.find_first_not_of(" \t\r\n");
  spec::Case c;
  c.setup = certify::input::read_setup_text(setup, kSetup, first != std::string::npos && setup[first] == '{');
  c.dialect = spec::dialect_of(c.setup.control);
  c.program = program;
  c.samples = options.samples;
  FastRun(c, lines, !options.exact).run(options.exact ? kMostExactBlocks : kMostFastBlocks);
  if (options.exact) run_exactly(c, options, lines);
}

}  // namespace

std::string lines_of(const std::string& program, const std::string& setup, std::string_view options) {
  std::string out;
  Lines lines(out);
  try {
    run(program, setup, options_of(options), lines);
  } catch (const spec::InputError& error) {
    Json fault = {{"kind", "fault"}, {"in", error.file() == kSetup ? "setup" : "program"}};
    if (error.line() != 0) fault["line"] = error.line();
    if (error.column() != 0) fault["column"] = error.column();
    fault["text"] = error.message();
    lines.add(fault);
  } catch (const std::exception& error) {
    lines.add({{"kind", "fault"}, {"in", "toolcomp"}, {"text", std::string("internal error: ") + error.what()}});
  }
  return out;
}

}  // namespace toolcomp::playground

// What it gives ends in 0 and lives until it is called again.
extern "C" const char* toolcomp_try(const char* program, std::size_t program_size, const char* setup,
                                    std::size_t setup_size, const char* options, std::size_t options_size) {
  static std::string lines;
  lines = toolcomp::playground::lines_of({program, program_size}, {setup, setup_size}, {options, options_size});
  return lines.c_str();
}
