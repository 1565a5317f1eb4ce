// toolcomp explain: block by block, the clauses applied, each decision with its exact value and the double nearest to
// it.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "cli/explanation.h"
#include "cli/program.h"
#include "cli/verbs.h"
#include "fast/basis/print.h"
#include "fuzz/gen/program_text.h"
#include "fuzz/oracle/control.h"
#include "model/basis/print.h"
#include "spec/language/event_format.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

template <class Number>
struct Collector final : spec::EventSink<Number> {
  std::vector<spec::Event<Number>> events;
  void on(const spec::Event<Number>& event) override { events.push_back(event); }
};

std::string_view outcome_text(const spec::ClauseInfo& clause, exact::Sign outcome) {
  switch (outcome) {
    case exact::Sign::positive:
      return clause.positive;
    case exact::Sign::negative:
      return clause.negative;
    case exact::Sign::zero:
      return clause.tie;
  }
  return {};
}

std::string_view comparison(exact::Sign outcome) {
  switch (outcome) {
    case exact::Sign::positive:
      return "> 0";
    case exact::Sign::negative:
      return "< 0";
    case exact::Sign::zero:
      return "= 0";
  }
  return {};
}

std::string exact_text(const exact::Real& value, int digits) {
  std::string text;
  model::append_number(text, value, digits);
  if (value.is_rational() && text.size() > 1) {
    const std::string fraction = value.rational().str();
    if (fraction.size() <= 40 && fraction.find('/') != std::string::npos) text += " = " + fraction;
    return text;
  }
  return text;
}

void print_clause(const spec::ClauseInfo& clause) {
  fmt::print("  clause   {}  [{}]\n      {}\n", clause.id,
             clause.kind == spec::ClauseKind::open ? "open: our definition" : clause.provenance, clause.text);
  if (!clause.formula.empty()) fmt::print("      {}\n", clause.formula);
}

void print_decision(const model::Decision& decision, int digits) {
  const spec::ClauseInfo& clause = spec::info(decision.clause);
  fmt::print("  decision {}\n      {}\n", clause.id, clause.text);
  if (!clause.formula.empty()) fmt::print("      {}\n", clause.formula);
  fmt::print("      exact   {} {}\n", exact_text(decision.quantity, digits), comparison(decision.outcome));
  const exact::DoubleEnclosure enclosure = decision.quantity.double_enclosure();
  fmt::print("      double  {:.17g}\n", enclosure.lower / 2 + enclosure.upper / 2);
  if (decision.scale.sign() == exact::Sign::positive)
    fmt::print("      margin  {} of the scale {}\n", exact_text(decision.quantity / decision.scale, digits),
               exact_text(decision.scale, digits));
  const std::string_view meaning = outcome_text(clause, decision.outcome);
  if (!meaning.empty()) fmt::print("      so      {}\n", meaning);
}

// Keeps what is read.
class Kept final : public spec::ByteSource {
 public:
  Kept(std::unique_ptr<spec::ByteSource> source, std::string& text) : source_(std::move(source)), text_(text) {}
  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t n = source_->read(buffer, size);
    text_.append(buffer, n);
    return n;
  }

 private:
  std::unique_ptr<spec::ByteSource> source_;
  std::string& text_;
};

// Everything explained about one program, printed in the order of its blocks.
class Explanation {
 public:
  Explanation(const Program& program, const ExplainOptions& options)
      : options_(options), setup_(program.setup()), axes_(setup_.axes) {
    model::Recorder recorder(true);
    Collector<exact::Real> exact_events;
    Collector<double> fast_events;
    fuzz::with_control(setup_,
                       [&]<class Control>(Control) { run<Control>(program, recorder, exact_events, fast_events); });
    for (const model::Decision& decision : recorder.decisions()) lines_[decision.line].decisions.push_back(decision);
    exact_ = std::move(exact_events.events);
    for (std::size_t i = 0; i < exact_.size(); ++i) lines_[exact_[i].line].exact.push_back(i);
    for (auto& event : fast_events.events) lines_[event.line].fast.push_back(std::move(event));
    numbered_ = std::ranges::any_of(blocks_, [&](const Source& source) { return source.n == options_.block; });
  }

  int print() const {
    bool found = false;
    for (const Source& source : blocks_) {
      if (!wanted(source)) continue;
      found = true;
      print_block(source);
    }
    if (!found && options_.block)
      throw spec::InputError(
          options_.program, 0, 0,
          fmt::format("no block has the sequence number {0} or stands on line {0}", *options_.block));
    return kAgrees;
  }

 private:
  struct Source {
    std::uint64_t line = 0;
    std::optional<std::uint64_t> n;
    std::string text;
  };

  template <class Control>
  void run(const Program& program, model::Recorder& recorder, Collector<exact::Real>& exact_events,
           Collector<double>& fast_events) {
    auto model = Control::model(setup_, recorder, exact_events, program.samples());
    auto fast = Control::fast(setup_, fast_events, program.samples());
    const fuzz::StreamedProgram text = program.text();
    std::string read;
    auto reader = Control::reader(std::make_unique<Kept>(text.open(), read), setup_, text.name, text.called_program);
    typename Control::Block block;
    try {
      while (!model.stopped() && reader.next(block)) {
        add(block);
        model.block(block);
        fast.block(block);
      }
    } catch (const spec::InputError& error) {
      throw program.placed(error);
    }
    model.end();
    fast.end();
    add_text(options_.program == "-" ? read : program.as_case().program);
  }

  void add(const spec::Block& block) {
    blocks_.push_back({block.line, block.n, block.alarm ? std::string() : to_string(block)});
  }
  // What is read again has its events at its line.
  void add(const spec::klartext::Block& block) {
    if (read_.insert(block.line).second) blocks_.push_back({block.line, block.n, {}});
  }

  // Blocks that have no text yet: their lines as written, with those that ~ joins to them.
  void add_text(std::string_view read) {
    const std::vector<std::string> lines = fuzz::lines(read);
    for (Source& block : blocks_)
      for (std::size_t i = block.line - 1; i < lines.size() && (block.text.empty() || block.text.ends_with('~')); ++i) {
        std::string_view line = lines[i];
        while (!line.empty() && std::string_view(" \t\r").find(line.back()) != std::string_view::npos)
          line.remove_suffix(1);
        if (!block.text.empty()) block.text += "\n    ";
        block.text += line;
      }
  }

  // Everything that belongs to one line of the program.
  struct Line {
    std::vector<model::Decision> decisions;
    std::vector<std::size_t> exact;  // indices of events
    std::vector<spec::Event<double>> fast;
  };

  [[nodiscard]] bool wanted(const Source& source) const {
    if (!options_.block) return true;
    return numbered_ ? source.n == options_.block : source.line == *options_.block;
  }

  void print_block(const Source& source) const {
    fmt::print("line {}: {}\n", source.line, source.text);
    const auto found = lines_.find(source.line);
    const Line nothing;
    const Line& line = found == lines_.end() ? nothing : found->second;
    std::set<spec::Clause> decided;  // explained with their decisions
    for (const model::Decision& decision : line.decisions) {
      decided.insert(decision.clause);
      print_decision(decision, options_.digits);
    }
    for (const std::size_t index : line.exact) {
      const model::Event& event = exact_[index];
      std::string text;
      spec::append_event_json(text, event, axes_, [this](std::string& out, const exact::Real& value) {
        model::append_number(out, value, options_.digits);
      });
      fmt::print("  exact   {}\n", text);
      if (event.kind == spec::EventKind::alarm || event.kind == spec::EventKind::warning)
        fmt::print("          {}\n", event.message);
      for (const spec::Clause clause : event.clauses)
        if (!decided.contains(clause)) print_clause(spec::info(clause));
      print_words(index);
    }
    for (const auto& event : line.fast) {
      std::string text;
      spec::append_event_json(text, event, axes_,
                              [](std::string& out, double value) { fast::append_number(out, value); });
      fmt::print("  double  {}\n", text);
    }
    fmt::print("\n");
  }

  // In words: the corner at the end of an own move, what G37 may be off.
  void print_words(std::size_t index) const {
    const model::Event& event = exact_[index];
    if (event.kind != spec::EventKind::move) return;
    if (event.cause == spec::Cause::measure) fmt::print("  measured {}\n", measuring_words(setup_, options_.digits));
    if (event.space || (event.cause == spec::Cause::corner && !event.arc)) return;
    const std::string corner = corner_words(exact_, index, axes_, options_.digits);
    if (!corner.empty()) fmt::print("  corner   {}\n", corner);
  }

  const ExplainOptions& options_;
  const spec::Setup& setup_;
  spec::Axes axes_;
  std::vector<Source> blocks_;
  std::set<std::uint64_t> read_;  // lines of Klartext blocks
  std::vector<model::Event> exact_;
  std::map<std::uint64_t, Line> lines_;
  bool numbered_ = false;  // the block asked for is a sequence number
};

}  // namespace

int explain(const ExplainOptions& options) {
  const Program program(options.program, options.setup, options.samples);
  return Explanation(program, options).print();
}

}  // namespace toolcomp::cli
