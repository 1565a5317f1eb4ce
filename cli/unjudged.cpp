// SPDX-License-Identifier: Apache-2.0
#include "cli/unjudged.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "judge/oracle/control.h"
#include "spec/language/alarm.h"
#include "spec/language/event_names.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

bool ends_program(const spec::Block& block) {
  return std::ranges::any_of(block.words(), [](const spec::Word& word) {
    return word.address == 'M' && (word.value.digits == 2 || word.value.digits == 30);
  });
}
bool ends_program(const spec::klartext::Block& block) {
  return block.statement == spec::klartext::Statement::end_program;
}

// Blocks after the first one that is not followed, up to the end of the program; nothing where the program cannot be
// read again.
std::optional<std::uint64_t> blocks_left(const Program& program) {
  const judge::StreamedProgram text = program.text();
  if (text.once) return std::nullopt;
  std::uint64_t left = 0;
  judge::with_control(program.setup(), [&]<class Control>(Control) {
    auto reader = Control::reader(text.open(), program.setup(), text.name, text.called_program);
    const auto block = std::make_unique<typename Control::Block>();
    bool beyond = false;
    try {
      while (reader.next(*block)) {
        left += beyond ? 1 : 0;
        if (beyond && ends_program(*block)) break;
        beyond = beyond || spec::beyond(*block) != nullptr;
      }
    } catch (const spec::InputError&) {  // NOLINT(bugprone-empty-catch)
      // No text: what no run gets to is no fault of it.
    }
  });
  return left;
}

}  // namespace

void Unjudged::say(std::uint64_t line, std::uint64_t column, std::string_view name, std::string_view text) const {
  const Place place = program_.place(line, column);
  report_alarm(place.file, place.line, place.column, name, text);
}

void Unjudged::open(std::uint64_t line, std::uint64_t column, bool out_of_scope, std::uint64_t count) {
  if (count == 0) return;
  if (open_ == 0)
    say(line, column, out_of_scope ? spec::kOutOfScope : "undecided",
        out_of_scope ? "radius compensation in the plane (RL or RR without TCPM) is not modelled"
                     : "the specification leaves open what this block does");
  open_ += count;
}

void Unjudged::ends(std::uint64_t line, std::uint64_t column, std::string_view text) {
  say(line, column, {}, text);
  ended_ = true;
}

void Unjudged::end() {
  if (open_ > 1) std::cerr << fmt::format("not judged: {} moves of this kind\n", open_);
  if (!ended_) return;
  const std::optional<std::uint64_t> left = blocks_left(program_);
  if (left) std::cerr << fmt::format("not run: {} block{} after it\n", *left, *left == 1 ? "" : "s");
}

}  // namespace toolcomp::cli
