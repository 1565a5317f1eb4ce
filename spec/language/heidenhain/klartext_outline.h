// SPDX-License-Identifier: Apache-2.0
// What of a text in memory matters to calls: LBL, CALL PGM, BEGIN PGM and END PGM, in the order of the text. Internal
// to the reader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/setup.h"

namespace toolcomp::spec::klartext {

// Where a block begins in a text: bytes before it, and its line.
struct TextPlace {
  std::size_t offset = 0;
  std::uint64_t line = 1;
};

// A block longer than this, its line feed included, cannot be read.
inline constexpr std::size_t kLongestBlock = 65536;
// Bytes behind a text that the parser may look at.
inline constexpr std::size_t kBehindText = 64;

struct OutlineEntry {
  Statement statement{};  // label, call_program, begin_program, end_program
  Name name;              // of the label (as in Block) or of the program
  Units unit = Units::mm;
  TextPlace at;
  TextPlace behind;
};

// The entries from `from` on. Blocks that cannot be read have none, nor have those that the setup skips.
std::vector<OutlineEntry> outline(const Setup& setup, const std::string& text, TextPlace from);

// What a program is called by: capitals, without the ending .H.
std::string program_key(std::string_view name);

}  // namespace toolcomp::spec::klartext
