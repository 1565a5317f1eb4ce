// SPDX-License-Identifier: Apache-2.0
// Joins a program and all programs that it calls into one text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "spec/language/heidenhain/klartext_outline.h"
#include "spec/language/reader_options.h"

namespace toolcomp::spec::klartext {

// Whether the name of a program has a path. Such a program is not looked for.
bool has_path(std::string_view name);

// The main text, followed by the programs that it calls and does not contain itself, and by the programs that they
// call. Each program comes once, as it is in its file, in the order of the first CALL PGM in the joined text. Line
// numbers continue. This text defines what a program that calls others means: the reader gives the same blocks, lines
// and columns for both. A main text without END PGM gets one if programs follow it. Programs that are not found are
// left out.
std::string joined_klartext(std::string_view main_text, const CalledProgram& called);

// The same for the rest of a main text, with the line in which it begins. `main` is its name, if BEGIN PGM came before
// this rest.
struct TextAt {
  std::string_view text;
  std::uint64_t line = 1;
};
std::string joined_rest(TextAt rest, std::string_view main, const CalledProgram& called);

}  // namespace toolcomp::spec::klartext
