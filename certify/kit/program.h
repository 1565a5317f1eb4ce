// SPDX-License-Identifier: Apache-2.0
// The text of a program of a kit: a safe start, its mark, cases one behind the other, and an end.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "certify/kit/klartext.h"
#include "certify/kit/machine.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::certify::kit {

// A case as it stands in a program.
struct CaseText {
  std::string id;
  std::vector<spec::Block> blocks;  // FANUC; their sequence numbers are replaced
  Statements statements;            // Klartext
  spec::AxisTable start;            // workpiece coordinates
  std::size_t ending = 0;           // how compensation is ended behind it: below ending_count
  std::string restore;              // G10 blocks that give offsets their values back, with line feeds
};

std::size_t block_count(const CaseText& text);
void cut_to(CaseText& text, std::size_t count);

// Ways to end what a case leaves switched on. None is right in every state; the model says which is.
std::size_t ending_count(spec::Control control);

enum class ProgramKind : std::uint8_t {
  recorded,  // with a mark and rests between its cases
  stopped,   // one case, which ends in an alarm: without rests
};

// Lines of the text, from 1.
struct CaseLines {
  std::uint64_t first = 0, last = 0;  // of its blocks
  std::uint64_t end = 0;              // of the last block that belongs to it: the rest behind it
};

// What a recording is cut to: from the first rest of the mark to the rest behind the last case. Lines of the text.
struct MarkLines {
  std::uint64_t steps = 0;  // of the first move that keeps the first rest apart
  std::uint64_t first_rest = 0;
  std::uint64_t last_rest = 0;
};

struct ProgramText {
  std::string text;
  std::vector<CaseLines> cases;
  MarkLines marks;  // of recorded programs
};

// The program without the moves before its first rest and behind its last: what a cut recording shows. Lines keep their
// numbers.
std::string between_rests(std::string_view text, const MarkLines& marks);

// `number` stands behind O, and less kFirstProgram in the mark.
inline constexpr unsigned kFirstProgram = 8000;
// "O8001", of a Heidenhain control "8001".
std::string program_name(spec::Control control, unsigned number);
ProgramText write_program(const Machine& machine, unsigned number, std::string_view title, ProgramKind kind,
                          const std::vector<CaseText>& cases);

// A place as words: "X1. Y2.5", the axes in the order of the setup; those not in the table stand at 0.
std::string place_words(const spec::Setup& setup, const spec::AxisTable& place);

}  // namespace toolcomp::certify::kit
