// SPDX-License-Identifier: Apache-2.0
#include "spec/language/fanuc/program_reader.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spec/language/fanuc/block_reader.h"
#include "spec/language/fanuc/not_supported.h"
#include "spec/language/fanuc/program_library.h"

namespace toolcomp::spec {
namespace {

constexpr std::size_t kMostCalls = 10;  // one inside the other

}  // namespace

struct ProgramReader::State {
  State(std::unique_ptr<ByteSource> source, Axes given, ReaderOptions reader_options)
      : axes(std::move(given)), options(std::move(reader_options)), main(std::move(source), axes, options, variables) {
    variables.inch = options.inch;
  }

  // A program that is called and runs.
  struct Call {
    ProgramLibrary::Program program;
    std::unique_ptr<BlockReader> reader;
    std::uint64_t left;  // how often it runs again
    bool macro = false;  // G65
    bool empty = true;   // no block of it has come
  };

  // The next block, calls and jumps of macros followed.
  bool next(Block& block);
  BlockReader& reader() { return calls.empty() ? main : *calls.back().reader; }
  // The next block in the order of the run.
  bool read(Block& block);
  // After a block with M98 or M99; `block` gets the alarm where there is one.
  void follow(Block& block);
  // The text from here on may be read again, or holds what is called; `program`: the one that is called first.
  void keep(const std::string& program);
  // M98, and G65, whose program has local variables of its own.
  void call(Block& block, bool macro);
  void return_to(Block& block, const Word& sequence_number);
  // The end of a program, by M99 or by its text.
  void end_program();
  void begin(Call& call);
  void end_call();

  Axes axes;
  ReaderOptions options;
  MacroVariables variables;
  BlockReader main;
  std::optional<ProgramLibrary> library;  // from the first call on
  std::vector<Call> calls;
  std::vector<std::unique_ptr<BlockReader>> spare;  // of calls that have ended: a reader is large
  std::uint64_t repeated_blocks = 0;                // of programs called, and after the first jump
  bool over = false;                                // no block comes any more
};

bool ProgramReader::State::read(Block& block) {
  while (!reader().next(block)) {
    if (calls.empty()) return false;
    end_program();
  }
  return true;
}

void ProgramReader::State::begin(Call& call) {
  call.empty = true;
  if (!call.reader && !spare.empty()) {
    call.reader = std::move(spare.back());
    spare.pop_back();
  }
  if (call.reader)
    call.reader->begin(call.program.text, call.program.line);
  else
    call.reader = std::make_unique<BlockReader>(call.program.text, axes, options, variables, call.program.line);
}

void ProgramReader::State::end_call() {
  if (calls.back().macro) variables.leave();
  spare.push_back(std::move(calls.back().reader));
  calls.pop_back();
}

void ProgramReader::State::end_program() {
  if (calls.empty()) {
    main.end();
    return;
  }
  Call& call = calls.back();
  // A program without blocks would end at once, however often.
  if (call.left == 0 || call.empty) {
    end_call();
    return;
  }
  --call.left;
  begin(call);
}

void ProgramReader::State::follow(Block& block) {
  const auto refuse = [&block](const char* message) {
    block.alarm = ReadAlarm{AlarmCause::not_supported, block.size == 0 ? 1 : block.word[0].column, message};
  };
  if (reader().jump() == BlockReader::Jump::call) {
    call(block, false);
    return;
  }
  const Word* p = nullptr;
  for (const Word& word : block.words()) {
    if (word.address == 'L') return refuse("M99 L (number of repetitions) is not supported");
    if (word.address == 'P') p = &word;
  }
  if (p == nullptr || calls.empty()) {
    if (p != nullptr) return refuse("M99 P (in a main program) is not supported");
    end_program();
    return;
  }
  const Word to = *p;
  end_call();
  return_to(block, to);
}

// In the program that has called, from behind the call to its end.
void ProgramReader::State::return_to(Block& block, const Word& sequence_number) {
  const Decimal& number = sequence_number.value;
  if (number.decimals != 0 || number.negative || !reader().find(number.digits))
    block.alarm = ReadAlarm{AlarmCause::sequence_number_missing, sequence_number.column,
                            "M99 P: no block after the call has this sequence number"};
}

void ProgramReader::State::keep(const std::string& program) {
  if (library) return;
  library.emplace(axes, options);
  const std::uint64_t line = main.line();
  main.go_on(library->add(main.take_rest(), line, program));
}

void ProgramReader::State::call(Block& block, bool macro) {
  const ProgramCall wanted = program_call(block, reader());
  const std::uint32_t column = macro ? reader().macro_call().column : block.word[0].column;
  const auto fault = [&block, column](AlarmCause cause, const char* message) {
    block.alarm = ReadAlarm{cause, column, message};
  };
  keep(wanted.program);
  const std::optional<ProgramLibrary::Program> program = library->find(wanted.program);
  if (!program && macro) return fault(AlarmCause::not_supported, kMacroOfNoProgram);
  if (!program && reader().has_variables())
    return fault(AlarmCause::not_supported, "# (the number of a program that is missing) is not supported");
  if (wanted.program.empty()) return fault(AlarmCause::program_missing, "M98 without a program number");
  if (!program) return fault(AlarmCause::program_missing, "M98: there is no program with this number");
  if (calls.size() == kMostCalls)
    return fault(AlarmCause::calls_too_deep, "program calls are nested more than 10 deep");
  if (macro) variables.call(reader().macro_call().arguments);
  begin(calls.emplace_back(Call{*program, {}, wanted.times - 1, macro}));
}

ProgramReader::ProgramReader(std::unique_ptr<ByteSource> source, const Axes& axes, ReaderOptions options)
    : state_(std::make_unique<State>(std::move(source), axes, std::move(options))) {}
ProgramReader::~ProgramReader() = default;
ProgramReader::ProgramReader(ProgramReader&&) noexcept = default;
ProgramReader& ProgramReader::operator=(ProgramReader&&) noexcept = default;

// A block of the text, or a statement that changes which one comes next.
bool ProgramReader::State::next(Block& block) {
  for (;;) {
    if (calls.empty()) [[likely]] {
      if (!main.next(block)) return false;
    } else if (!read(block)) {
      return false;
    }
    const BlockReader::Jump jump = reader().jump();
    if (jump == BlockReader::Jump::keep) [[unlikely]] {
      keep({});
      continue;
    }
    if (jump == BlockReader::Jump::macro && !block.alarm) [[unlikely]] {
      call(block, true);
      if (!block.alarm) continue;
    }
    return true;
  }
}

bool ProgramReader::next(Block& block) {
  State& state = *state_;
  if (state.over) [[unlikely]]
    return false;
  // An end, be it by an exception, is that of all programs.
  state.over = true;
  if (!state.next(block)) return false;
  bool too_many = false;
  const bool called = !state.calls.empty();
  if (called || state.variables.jumps != 0) [[unlikely]] {
    if (called) state.calls.back().empty = false;
    too_many = ++state.repeated_blocks > state.options.most_repeated;
    if (too_many)
      block.alarm = ReadAlarm{AlarmCause::not_supported, 1,
                              called ? "M98 (more blocks of called programs than toolcomp runs) is not supported"
                                     : "GOTO (more blocks than toolcomp runs) is not supported"};
  }
  if (state.reader().jump() != BlockReader::Jump::none && !block.alarm) [[unlikely]]
    state.follow(block);
  state.over = too_many;
  return true;
}

void ProgramReader::lines(LineColumns& to, std::size_t most) {
  to.size = 0;
  if (!state_->over && state_->calls.empty() && state_->variables.jumps == 0) state_->main.lines(to, most);
}

void ProgramReader::pass_lines(std::size_t count) { state_->main.pass_lines(count); }

std::string joined_program(std::string_view text, const Axes& axes, const ReaderOptions& options) {
  MacroVariables variables;
  BlockReader reader(text_source(text), axes, options, variables);
  reader.scan();
  Block block;
  while (reader.next(block))
    if (reader.calls() && !block.alarm) {
      ProgramLibrary library(axes, options);
      const std::uint64_t line = reader.line();
      std::string rest = reader.take_rest();
      std::string joined(text.substr(0, text.size() - rest.size()));
      library.add(std::move(rest), line, program_call(block, reader).program);
      return joined + library.joined();
    }
  return std::string(text);
}

}  // namespace toolcomp::spec
