// SPDX-License-Identifier: Apache-2.0
#include "spec/language/heidenhain/klartext_calls.h"

#include <algorithm>
#include <utility>

#include "spec/language/heidenhain/joined_program.h"

namespace toolcomp::spec::klartext {
namespace {

// Of subprograms in subprograms, and of programs in programs.
constexpr std::size_t kDeepest = 19;

void raise(Block& block, AlarmCause cause, const char* message) {
  block.alarm = ReadAlarm{cause, block.line, block.column, message};
}

}  // namespace

Calls::Calls(const Setup& setup, const ReaderOptions& options, std::string text, Main main)
    : setup_(setup), options_(options), main_(std::move(main)), text_(std::move(text)) {
  text_.append(kBehindText, '\0');
  make_programs();
}

void Calls::make_programs() {
  const std::string text = text_.substr(0, size());
  most_blocks_ = options_.most_repeated + static_cast<std::uint64_t>(std::ranges::count(text, '\n')) + 1;
  programs_.clear();
  programs_.push_back({program_key(main_.name), main_.units, {}, false, {}});
  bool open = true;  // the last program has not ended yet
  for (const OutlineEntry& entry : outline(setup_, text, {0, main_.line})) {
    if (entry.statement == Statement::end_program) {
      programs_.back().ends = programs_.back().ends || open;
      open = false;
    } else if (entry.statement == Statement::begin_program && (programs_.size() > 1 || !open)) {
      programs_.push_back({program_key(entry.name.view()), entry.unit, entry.behind, false, {}});
      open = true;
    } else if (entry.statement == Statement::label && open && entry.name != Name("0")) {
      programs_.back().labels[std::string(entry.name.view())].push_back(entry.at);
    }
  }
}

std::optional<TextPlace> Calls::next(Block& block, TextPlace at, TextPlace behind) {
  if (++blocks_ > most_blocks_) {
    raise(block, AlarmCause::not_supported,
          "CALL (more blocks in calls and repeats than toolcomp runs) is not supported");
    return std::nullopt;
  }
  if (block.alarm) return behind;
  switch (block.statement) {
    case Statement::label:
      return label(block, behind);
    case Statement::call_label:
      return block.repeats == 0 ? subprogram(block, behind) : repeat(block, at, behind);
    case Statement::call_program:
      return program(block, behind);
    case Statement::end_program:
      return end(block);
    default:
      return behind;
  }
}

std::optional<TextPlace> Calls::label(Block& block, TextPlace behind) {
  if (block.label != Name("0") || frames_.back().label.empty()) return behind;
  block.jumps = true;
  const TextPlace back = frames_.back().back;
  frames_.pop_back();
  return back;
}

std::optional<TextPlace> Calls::place_of_label(Block& block) {
  const Labels& labels = programs_[frames_.back().program].labels;
  const auto found = labels.find(block.label.view());
  if (found == labels.end())
    raise(block, AlarmCause::label_missing, "there is no such label in this program");
  else if (found->second.size() > 1)
    raise(block, AlarmCause::label_twice, "the program has this label more than once");
  else
    return found->second.front();
  return {};
}

std::size_t Calls::depth(bool subprograms) const {
  return static_cast<std::size_t>(std::count_if(
      frames_.begin() + 1, frames_.end(), [&](const Frame& frame) { return frame.label.empty() != subprograms; }));
}

TextPlace Calls::subprogram(Block& block, TextPlace behind) {
  const std::optional<TextPlace> place = place_of_label(block);
  if (!place) return behind;
  const std::size_t program = frames_.back().program;
  if (std::ranges::any_of(
          frames_, [&](const Frame& frame) { return frame.program == program && frame.label == block.label.view(); }))
    raise(block, AlarmCause::label_recursion, "a subprogram calls itself");
  else if (depth(true) == kDeepest)
    raise(block, AlarmCause::nesting, "subprograms are nested more than 19 deep");
  if (block.alarm) return behind;
  block.jumps = true;
  frames_.push_back({behind, program, std::string(block.label.view()), {}});
  return *place;
}

TextPlace Calls::repeat(Block& block, TextPlace at, TextPlace behind) {
  const std::optional<TextPlace> place = place_of_label(block);
  if (!place) return behind;
  if (place->offset > at.offset) {
    raise(block, AlarmCause::not_supported, "REP (of a label after its call) is not supported");
    return behind;
  }
  auto& repeats = frames_.back().repeats;
  std::uint32_t& left = repeats.try_emplace(at.offset, block.repeats).first->second;
  if (left == 0) {
    repeats.erase(at.offset);
    return behind;
  }
  --left;
  block.jumps = true;
  return *place;
}

std::optional<std::size_t> Calls::find(std::string_view key) const {
  const auto found = std::ranges::find(programs_, key, &Program::key);
  if (found == programs_.end()) return {};
  return static_cast<std::size_t>(found - programs_.begin());
}

void Calls::join(TextPlace& behind) {
  if (joined_ || !options_.called_program) return;
  joined_ = true;
  const std::size_t before = size();
  const bool open_line = text_[before - 1] != '\n';
  text_ = joined_rest({std::string_view(text_).substr(0, size()), main_.line}, main_.name, options_.called_program);
  if (open_line && text_.size() > before && behind.offset == before) ++behind.offset;
  text_.append(kBehindText, '\0');
  make_programs();
}

TextPlace Calls::program(Block& block, TextPlace behind) {
  const std::string_view name = block.program.view();
  if (name.find_first_of("/\\:") != std::string_view::npos) {
    raise(block, AlarmCause::called_program_missing,
          "a program is called by its name without a path; its file must be in the same folder as this program");
    return behind;
  }
  const std::string key = program_key(name);
  if (!find(key)) join(behind);
  const std::optional<std::size_t> called = find(key);
  const auto is_called = [&](const Frame& frame) { return frame.label.empty() && frame.program == called; };
  if (!called)
    raise(block, AlarmCause::called_program_missing, "no program begins with BEGIN PGM and this name");
  else if (std::ranges::any_of(frames_, is_called))
    raise(block, AlarmCause::program_recursion, "a program calls itself");
  else if (!programs_[*called].ends)
    raise(block, AlarmCause::called_program_missing, "the called program has no END PGM");
  else if (depth(false) == kDeepest)
    raise(block, AlarmCause::nesting, "program calls are nested more than 19 deep");
  else if (programs_[*called].units != main_.units)
    raise(block, AlarmCause::not_supported,
          "CALL PGM (of a program in other units than the main program) is not supported");
  if (block.alarm) return behind;
  frames_.push_back({behind, *called, {}, {}});
  return programs_[*called].begin;
}

std::optional<TextPlace> Calls::end(Block& block) {
  while (!frames_.back().label.empty()) frames_.pop_back();
  if (frames_.size() == 1) return {};
  block.statement = Statement::program_return;
  const TextPlace back = frames_.back().back;
  frames_.pop_back();
  return back;
}

}  // namespace toolcomp::spec::klartext
