// SPDX-License-Identifier: Apache-2.0
#include "certify/explained.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

#include "certify/block_words.h"
#include "fuzz/gen/program_text.h"
#include "judge/oracle/control.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

template <class Number>
struct Gathered final : spec::EventSink<Number> {
  std::vector<spec::Event<Number>> events;
  void on(const spec::Event<Number>& event) override { events.push_back(event); }
};

// Keeps what is read.
class KeptText final : public spec::ByteSource {
 public:
  KeptText(std::unique_ptr<spec::ByteSource> source, std::string& text) : source_(std::move(source)), text_(text) {}
  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t n = source_->read(buffer, size);
    text_.append(buffer, n);
    return n;
  }

 private:
  std::unique_ptr<spec::ByteSource> source_;
  std::string& text_;
};

// All that is said of them is in memory at once.
constexpr std::size_t kMostBlocks = 200'000;

// Both engines over one program, and the text of its blocks.
class BothRuns {
 public:
  explicit BothRuns(const input::Program& program) : setup_(program.setup()) {
    judge::with_control(setup_, [&]<class Control>(Control) { run<Control>(program); });
  }

  // Lines are counted by block; more than one block may begin in a line that runs again.
  std::vector<ExplainedBlock> blocks(std::optional<std::uint64_t> wanted, int digits) {
    std::map<std::uint64_t, std::vector<model::Decision>> decisions;
    for (const model::Decision& decision : recorder_.decisions()) decisions[decision.line].push_back(decision);
    std::map<std::uint64_t, std::vector<std::size_t>> exact;
    for (std::size_t i = 0; i < exact_.events.size(); ++i) exact[exact_.events[i].line].push_back(i);
    std::map<std::uint64_t, std::vector<fast::Event>> fast;
    for (const fast::Event& event : fast_.events) fast[event.line].push_back(event);
    const bool numbered = std::ranges::any_of(blocks_, [&](const ExplainedBlock& b) { return b.n && b.n == wanted; });
    std::vector<ExplainedBlock> result;
    for (ExplainedBlock& block : blocks_) {
      if (wanted && (numbered ? block.n != wanted : block.line != *wanted)) continue;
      block.decisions = decisions[block.line];
      for (const std::size_t index : exact[block.line]) block.exact.push_back(explained(index, digits));
      block.fast = fast[block.line];
      result.push_back(std::move(block));
    }
    return result;
  }

 private:
  template <class Control>
  void run(const input::Program& program) {
    auto model = Control::model(setup_, recorder_, exact_, program.samples());
    auto fast = Control::fast(setup_, fast_, program.samples());
    const judge::StreamedProgram text = program.text();
    std::string read;
    auto reader =
        Control::reader(std::make_unique<KeptText>(text.open(), read), setup_, text.name, text.called_program);
    typename Control::Block block;
    try {
      for (std::size_t read_so_far = 0; !model.stopped() && reader.next(block);) {
        if (++read_so_far > kMostBlocks)
          throw spec::InputError(text.name, block.line, 1,
                                 fmt::format("more than {} blocks cannot be explained at once", kMostBlocks));
        add(block);
        model.block(block);
        fast.block(block);
      }
    } catch (const spec::InputError& error) {
      throw program.placed(error);
    }
    model.end();
    fast.end();
    add_text(text.once ? read : program.as_case().program);
  }

  void add(const spec::Block& block) { add(block.line, block.n, block.alarm ? std::string() : to_string(block)); }
  // What is read again has its events at its line.
  void add(const spec::klartext::Block& block) {
    if (read_.insert(block.line).second) add(block.line, block.n, {});
  }
  void add(std::uint64_t line, std::optional<std::uint64_t> n, std::string text) {
    ExplainedBlock block;
    block.line = line;
    block.n = n;
    block.text = std::move(text);
    blocks_.push_back(std::move(block));
  }

  // Blocks that have no text yet: their lines as written, with those that ~ joins to them.
  void add_text(std::string_view read) {
    const std::vector<std::string> lines = fuzz::lines(read);
    for (ExplainedBlock& block : blocks_)
      for (std::size_t i = block.line - 1; i < lines.size() && (block.text.empty() || block.text.ends_with('~')); ++i) {
        std::string_view line = lines[i];
        while (!line.empty() && std::string_view(" \t\r").find(line.back()) != std::string_view::npos)
          line.remove_suffix(1);
        if (!block.text.empty()) block.text += "\n    ";
        block.text += line;
      }
  }

  // In words: the corner at the end of an own move, what G37 may be off.
  [[nodiscard]] ExplainedEvent explained(std::size_t index, int digits) const {
    ExplainedEvent result{exact_.events[index], {}, {}};
    const model::Event& event = result.event;
    if (event.kind != spec::EventKind::move) return result;
    if (event.cause == spec::Cause::measure) result.measured = measuring_words(setup_, digits);
    if (event.space || (event.cause == spec::Cause::corner && !event.arc)) return result;
    result.corner = corner_words(exact_.events, index, setup_.axes, digits);
    return result;
  }

  const spec::Setup& setup_;
  model::Recorder recorder_{true};
  Gathered<exact::Real> exact_;
  Gathered<double> fast_;
  std::vector<ExplainedBlock> blocks_;
  std::set<std::uint64_t> read_;  // lines of Klartext blocks
};

}  // namespace

std::vector<spec::Clause> ExplainedBlock::other_clauses(const ExplainedEvent& event) const {
  std::vector<spec::Clause> clauses;
  for (const spec::Clause clause : event.event.clauses)
    if (std::ranges::find(decisions, clause, &model::Decision::clause) == decisions.end()) clauses.push_back(clause);
  return clauses;
}

std::vector<ExplainedBlock> explain_blocks(const input::Program& program, std::optional<std::uint64_t> block,
                                           int digits) {
  std::vector<ExplainedBlock> blocks = BothRuns(program).blocks(block, digits);
  if (blocks.empty() && block)
    throw spec::InputError(program.path(), 0, 0,
                           fmt::format("no block has the sequence number {0} or stands on line {0}", *block));
  return blocks;
}

}  // namespace toolcomp::certify
