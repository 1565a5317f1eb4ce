// SPDX-License-Identifier: Apache-2.0
// Pieces of a self-contained HTML page.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::certify {

// How a page differs from the usual one, which loads nothing from outside.
struct PageOptions {
  bool fills_window = false;  // as wide and as high as the window
  std::string live;           // of a served page: the version that its server gives it (docs/view.md); empty for a file
};

// The page around `body`, which is HTML. `title` is text.
std::string page(std::string_view title, std::string_view body, const PageOptions& options = {});

// A table of HTML cells; the first row is the header. Columns from `numbers_from` on are numbers, aligned right.
using Row = std::vector<std::string>;
std::string table(const std::vector<Row>& rows, std::size_t numbers_from = SIZE_MAX);

// A program with line numbers. `marked` is the highlighted line, 0 for none.
std::string listing(std::string_view program, std::uint64_t marked);

// A list of names and values, both HTML.
std::string facts(const std::vector<Row>& rows);

// "PASS"-like badge of a verdict: good, bad or open.
enum class Tone : std::uint8_t { good, bad, open };
std::string badge(std::string_view text, Tone tone);

// The place for a signature, at the foot of a first page.
inline constexpr std::string_view kSignature =
    "<div class=\"sign\"><span>Place, date</span><span>Name</span><span>Signature</span></div>\n";

}  // namespace toolcomp::certify
