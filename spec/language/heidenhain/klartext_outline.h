// SPDX-License-Identifier: Apache-2.0
// The blocks of a text in memory that matter for calls: LBL, CALL PGM, BEGIN PGM and END PGM, in the order of the text.
// Internal to the reader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/setup.h"

namespace toolcomp::spec::klartext {

// The place at which a block begins in a text: the number of bytes before it, and its line.
struct TextPlace {
  std::size_t offset = 0;
  std::uint64_t line = 1;
};

// A block longer than this, including its line feed, cannot be read.
inline constexpr std::size_t kLongestBlock = 65536;
// Number of bytes after a text that the parser may look at.
inline constexpr std::size_t kBehindText = 64;

struct OutlineEntry {
  Statement statement{};  // label, call_program, begin_program, end_program
  Name name;              // of the label (as in Block) or of the program
  Units unit = Units::mm;
  TextPlace at;
  TextPlace behind;
};

// The entries from `from` on. Blocks that cannot be read have no entry, and blocks that the setup skips have none.
std::vector<OutlineEntry> outline(const Setup& setup, const std::string& text, TextPlace from);

// The key by which a program is called: upper case, without the ending .H.
std::string program_key(std::string_view name);

}  // namespace toolcomp::spec::klartext
