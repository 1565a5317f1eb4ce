// SPDX-License-Identifier: Apache-2.0
// The text of a program of a kit: a safe start, its mark, cases one after the other, and an end.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "certify/kit/klartext.h"
#include "certify/kit/machine.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::certify::kit {

// A case in the form in which it is in a program.
struct CaseText {
  std::string id;
  std::vector<spec::Block> blocks;  // FANUC; their sequence numbers are replaced
  Statements statements;            // Klartext
  spec::AxisTable start;            // workpiece coordinates
  std::size_t ending = 0;           // how compensation is ended after it; less than ending_count
  std::string restore;              // G10 blocks that restore offsets, with line feeds
};

std::size_t block_count(const CaseText& text);
void cut_to(CaseText& text, std::size_t count);

// The number of ways to end the modes that a case leaves on. No way is right in every state; the model shows which one
// is.
std::size_t ending_count(spec::Control control);

enum class ProgramKind : std::uint8_t {
  recorded,  // with a mark and rests between its cases
  stopped,   // one case, which ends in an alarm; without rests
};

// Lines of the text, from 1.
struct CaseLines {
  std::uint64_t first = 0, last = 0;  // of its blocks
  std::uint64_t end = 0;              // of the last block that belongs to it: the rest after it
};

// The part of a program to which a recording is cut: from the first rest of the mark to the rest after the last case.
// Lines of the text.
struct MarkLines {
  std::uint64_t steps = 0;  // of the first move that separates the first rest
  std::uint64_t first_rest = 0;
  std::uint64_t last_rest = 0;
};

struct ProgramText {
  std::string text;
  std::vector<CaseLines> cases;
  MarkLines marks;  // of recorded programs
};

// The program without the moves before its first rest and after its last rest, as a cut recording shows it. Lines keep
// their numbers.
std::string between_rests(std::string_view text, const MarkLines& marks);

// `number` is the program number after O. The mark has `number` - kFirstProgram.
inline constexpr unsigned kFirstProgram = 8000;
// "O8001"; for a Heidenhain control "8001".
std::string program_name(spec::Control control, unsigned number);
ProgramText write_program(const Machine& machine, unsigned number, std::string_view title, ProgramKind kind,
                          const std::vector<CaseText>& cases);

// A position as words: "X1. Y2.5", with the axes in the order of the setup. Axes that are not in the table are at 0.
std::string place_words(const spec::Setup& setup, const spec::AxisTable& place);

}  // namespace toolcomp::certify::kit
