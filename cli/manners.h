// SPDX-License-Identifier: Apache-2.0
// How the command speaks: what it says besides its data, on standard error; colors; what a terminal can show.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace toolcomp::cli {

enum class Loudness : std::uint8_t { quiet, usual, verbose };
enum class Coloring : std::uint8_t { automatic, always, never };

struct Manners {
  Loudness loudness = Loudness::usual;
  Coloring coloring = Coloring::automatic;
};
// Those of this process, from the command line; set before a verb begins.
void set_manners(const Manners& manners);

[[nodiscard]] bool is_quiet();
[[nodiscard]] bool is_verbose();

// A line that nobody needs to act on: not with --quiet.
void note(std::string_view line);
// What is read, with what and how long: with --verbose alone, "toolcomp: …".
void detail(std::string_view line);

enum class Stream : std::uint8_t { out, err };
enum class Paint : std::uint8_t { place, good, bad, doubtful };

// Whether text on the stream has colors: as --color says; else none where NO_COLOR is set, some where CLICOLOR_FORCE
// is (and not 0); else on a terminal that has them, unless CLICOLOR is 0.
[[nodiscard]] bool is_colored(Stream stream);
// The text in a color (bold for places), where the stream has colors.
[[nodiscard]] std::string painted(Paint paint, std::string_view text, Stream stream);
// A line of a diagnostic with its FILE:LINE:COLUMN: bold, for standard error.
[[nodiscard]] std::string painted_diagnostic(std::string_view line);

// Whether progress may be drawn over itself: standard error is a terminal that can, and nobody asked for quiet.
[[nodiscard]] bool can_redraw();
// Columns of the terminal: of COLUMNS where that is set, of the stream's terminal, else 80.
[[nodiscard]] std::size_t columns_of(Stream stream);
// The text up to so many characters (not bytes).
[[nodiscard]] std::string_view first_characters(std::string_view text, std::size_t count);

}  // namespace toolcomp::cli
