// A program and all those it calls as one text.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "spec/language/heidenhain/klartext_outline.h"

namespace toolcomp::spec::klartext {

using CalledProgram = std::function<std::optional<std::string>(std::string_view name)>;

// The text of the program that a CALL PGM names, in this folder: a file of that name, with or without the ending .h, in
// capitals or not. Nothing where there is none, and for a name with a path.
std::optional<std::string> program_beside(const std::filesystem::path& folder, std::string_view name);

// The main text, and behind it the programs that it calls and does not hold itself, and those that they call: each
// once, in the order of the first CALL PGM in the text that arises, as it is in its file. Lines count on. The
// definition of a program that calls others is this text: the reader gives the same blocks, lines and columns for both.
// A main text without END PGM gets one where others follow it; what is not found is left out.
std::string joined_klartext(std::string_view main_text, const CalledProgram& called);
std::string joined_klartext(std::string_view main_text, const std::filesystem::path& folder);

// The same for the rest of a main text that begins at `from`; `main` is its name, where BEGIN PGM stood before.
std::string joined_rest(std::string_view rest, std::string_view main, const CalledProgram& called);

}  // namespace toolcomp::spec::klartext
