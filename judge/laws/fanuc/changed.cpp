// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/changed.h"

#include <algorithm>
#include <memory>
#include <string_view>

#include "spec/language/byte_source.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/input_error.h"

namespace toolcomp::judge::laws {
namespace {

bool calls(const spec::Block& block) {
  return std::ranges::any_of(block.words(), [](const spec::Word& word) {
    return word.address == 'M' && (word.value.digits == 98 || word.value.digits == 99);
  });
}

// The text from this line on, as it is.
std::string_view from_line(std::string_view text, std::uint64_t line) {
  for (; line > 1; --line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text;
}

}  // namespace

std::optional<std::string> rewritten(const spec::Case& c, const ChangedWord& changed) {
  std::string text;
  std::uint64_t line = 1;
  try {
    spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes, spec::reader_options(c.setup));
    const auto block = std::make_unique<spec::Block>();
    const auto image = std::make_unique<spec::Block>();
    std::uint64_t latest = 0;
    for (std::size_t index = 0; reader.next(*block); ++index) {
      if (block->line <= latest || calls(*block)) return std::nullopt;
      latest = block->line;
      for (; line < block->line; ++line) text += '\n';
      // The run ends here.
      if (block->alarm) return text.append(from_line(c.program, line));
      *image = *block;
      for (std::size_t i = 0; i < block->size; ++i) {
        const auto word = changed(index, *block, block->word.at(i));
        if (!word) return std::nullopt;
        image->word.at(i) = *word;
      }
      text += to_string(*image);
    }
  } catch (const spec::InputError&) {
    return std::nullopt;
  }
  return text + '\n';
}

bool is_alike(const model::Event& a, const model::Event& b) {
  return a.kind == b.kind && a.line == b.line && a.type == b.type && a.cause == b.cause && a.number == b.number &&
         a.arc.has_value() == b.arc.has_value() && a.hole.has_value() == b.hole.has_value();
}

bool is_open(std::span<const model::Event> events) {
  return std::ranges::any_of(events, [](const model::Event& e) {
    return e.kind == spec::EventKind::undecided || e.alarm == spec::AlarmCause::offset_value ||
           e.alarm == spec::AlarmCause::g10_value;
  });
}

}  // namespace toolcomp::judge::laws
