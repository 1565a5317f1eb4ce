// SPDX-License-Identifier: Apache-2.0
#include "spec/language/heidenhain/klartext_outline.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "spec/language/heidenhain/klartext_parser.h"

namespace toolcomp::spec::klartext {
namespace {

// The line feed that ends the block at `begin`; `lines` becomes the number of its lines. One stands at the end.
const char* block_end(const char* begin, const char* end, std::uint64_t& lines) {
  lines = 1;
  for (const char* line = begin;;) {
    const auto* feed = static_cast<const char*>(std::memchr(line, '\n', static_cast<std::size_t>(end - line) + 1));
    const char* last = feed;
    while (last != line && is_blank(last[-1])) --last;
    if (feed == end || last == line || last[-1] != '~') return feed;
    ++lines;
    line = feed + 1;
  }
}

}  // namespace

std::vector<OutlineEntry> outline(const Setup& setup, const std::string& text, TextPlace from) {
  std::vector<OutlineEntry> entries;
  const std::string file;
  BlockParser parser(setup, file);
  Block block;
  std::string read = text.substr(from.offset);
  const std::size_t size = read.size();
  read += '\n';
  read.append(kBehindText, '\0');
  const char* const end = read.data() + size;
  std::uint64_t line = from.line;
  std::uint64_t lines = 1;
  for (const char* at = read.data(); at < end; line += lines) {
    const char* const stop = block_end(at, end, lines);
    const char* const begin = at;
    at = std::min(stop + 1, end);
    if (static_cast<std::size_t>(stop - begin) >= kLongestBlock) continue;
    const BlockParser::Head head = parser.parse_head(block, {begin, stop, line, 0});
    if (head.statement == nullptr || (head.slash && setup.block_skip)) continue;
    if (std::ranges::none_of(std::array<std::string_view, 4>{"LBL", "CALL", "BEGIN", "END"},
                             [&](std::string_view word) { return read_word(head.statement, word) != nullptr; }))
      continue;
    parser.begin();
    if (!parser.parse_statement(block, head.statement) || block.alarm) continue;
    if (block.statement == Statement::call_label) continue;
    const auto place = [&](const char* place_at, std::uint64_t place_line) {
      return TextPlace{from.offset + static_cast<std::size_t>(place_at - read.data()), place_line};
    };
    entries.push_back({block.statement, block.statement == Statement::label ? block.label : block.program, block.unit,
                       place(begin, line), place(at, line + lines)});
  }
  return entries;
}

std::string program_key(std::string_view name) {
  std::string key(name);
  std::ranges::transform(key, key.begin(), upper);
  if (key.ends_with(".H")) key.resize(key.size() - 2);
  return key;
}

}  // namespace toolcomp::spec::klartext
