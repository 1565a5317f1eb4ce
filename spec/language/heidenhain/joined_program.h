// SPDX-License-Identifier: Apache-2.0
// A program and all those it calls as one text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "spec/language/heidenhain/klartext_outline.h"
#include "spec/language/reader_options.h"

namespace toolcomp::spec::klartext {

// Whether the name of a program has a path: what it names is looked for nowhere.
bool has_path(std::string_view name);

// The main text, and behind it the programs that it calls and does not hold itself, and those that they call: each
// once, in the order of the first CALL PGM in the text that arises, as it is in its file. Lines count on. The
// definition of a program that calls others is this text: the reader gives the same blocks, lines and columns for both.
// A main text without END PGM gets one where others follow it; what is not found is left out.
std::string joined_klartext(std::string_view main_text, const CalledProgram& called);

// The same for the rest of a main text, with the line in which it begins; `main` is its name, where BEGIN PGM stood
// before.
struct TextAt {
  std::string_view text;
  std::uint64_t line = 1;
};
std::string joined_rest(TextAt rest, std::string_view main, const CalledProgram& called);

}  // namespace toolcomp::spec::klartext
