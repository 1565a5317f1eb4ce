// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <system_error>

#include "cli/manners.h"
#include "cli/shown_place.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"
#include "spec/language/printable.h"

namespace toolcomp::cli {

namespace fs = std::filesystem;

void expect_folder(const std::string& path, const std::string& option) {
  // The nearest of the folders above it that exists; "" is the one we are in.
  fs::path place = path;
  std::error_code error;
  while (!place.empty() && !fs::exists(place, error)) place = place.parent_path();
  if (!place.empty() && !fs::is_directory(place, error))
    throw spec::InputError(option, 0, 0, place.string() + " is not a folder");
}

void expect_page_of_ours(const std::string& file) {
  constexpr std::size_t kHead = 1000;
  std::error_code error;
  if (!fs::exists(file, error)) return;
  std::string head(kHead, '\0');
  head.resize(spec::file_source(file)->read(head.data(), head.size()));
  if (head.find(R"(name="generator" content="toolcomp")") == std::string::npos)
    throw spec::InputError(file, 0, 0, "exists and is not a page of toolcomp; name another file with --out");
}

void report_alarm(const std::string& file, std::uint64_t line, std::uint64_t column, std::string_view number,
                  std::string_view message) {
  // Lines of a case are those of the program in it.
  const std::uint64_t shown = file.ends_with(".json") ? column : character_column(file, line, column);
  std::cerr << painted(Paint::place, fmt::format("{}:{}:{}:", spec::printable(spec::display_name(file)), line, shown),
                       Stream::err)
            << (number.empty() ? "" : " ") << painted(Paint::bad, number, Stream::err);
  if (!message.empty()) std::cerr << ' ' << spec::printable(message);
  std::cerr << '\n';
}

void say_what_is_read(const std::string& program, const std::string& setup) {
  const fs::path beside = fs::path(program).parent_path() / "setup.toml";
  const bool is_there = setup.empty() && !program.ends_with(".json");
  detail("reads " + std::string(spec::display_name(program)) +
         (setup.empty() ? is_there ? "; setup " + beside.string() : "" : "; setup " + setup));
}

std::string text_of_line(const Program& program, std::uint64_t line) {
  if (program.is_case()) {
    std::istringstream text(program.as_case().program);
    return line_of(text, line);
  }
  const Place place = program.place(line);
  return line_of(place.file, place.line);
}

void RecentBlocks::add(const spec::Block& block) {
  add(block.line, {block.line, block.alarm ? block.alarm->column : block.size > 0 ? block.word[0].column : 1});
}

void RecentBlocks::add(const spec::klartext::Block& block) {
  add(block.line,
      block.alarm ? LineColumn{block.alarm->line, block.alarm->column} : LineColumn{block.line, block.column});
}

void RecentBlocks::add(const spec::LineColumns& lines, std::size_t count) {
  for (std::size_t i = count - std::min(count, places_.size()); i < count; ++i)
    add(lines.line + i, {lines.line + i, lines.column[i]});
}

RecentBlocks::LineColumn RecentBlocks::place(std::uint64_t line) const {
  // The latest block of the line: an alarm ends the run, so no block after the one at fault was read for it, except
  // within the look-ahead.
  for (std::size_t i = next_; i > 0 && next_ - i < places_.size(); --i)
    if (const Known& known = places_[(i - 1) % places_.size()]; known.line == line) return known.place;
  return {line, 1};
}

}  // namespace toolcomp::cli
