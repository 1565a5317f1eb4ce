// SPDX-License-Identifier: Apache-2.0
// What a verb works on, as the command line names it, and how its alarms are reported.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "certify/input/program.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/line_columns.h"

namespace toolcomp::cli {

using certify::input::check_setup;
using certify::input::expect_readable;
using certify::input::Place;
using certify::input::Program;
using certify::input::read_setup;

// Throws spec::InputError that names the option if no folder can stand at `path`, before hours of work end there.
void expect_folder(const std::string& path, const std::string& option);

// A file of that name which nobody named is replaced if it is a page of toolcomp. Throws spec::InputError for another.
void expect_page_of_ours(const std::string& file);

// Reports an alarm of reading or of the run on standard error: FILE:LINE:COLUMN: NUMBER message. What is no alarm has
// no number.
void report_alarm(const std::string& file, std::uint64_t line, std::uint64_t column, std::string_view number,
                  std::string_view message);

// With --verbose: the program and the setup, as the command line names them.
void say_what_is_read(const std::string& program, const std::string& setup);

// A line of the text that is read; empty where the text cannot be read again.
std::string text_of_line(const Program& program, std::uint64_t line);

// Where alarms point to: the places of the blocks read lately, for those that name an earlier block. A block of several
// lines has its alarm of reading where the fault is.
class RecentBlocks {
 public:
  struct LineColumn {
    std::uint64_t line = 0;
    std::uint64_t column = 1;
  };

  void add(const spec::Block& block);
  void add(const spec::klartext::Block& block);
  // Of the first `count` of lines that were read together.
  void add(const spec::LineColumns& lines, std::size_t count);
  // Of the block that begins in this line; column 1 of it where the block is no longer known.
  [[nodiscard]] LineColumn place(std::uint64_t line) const;

 private:
  void add(std::uint64_t line, LineColumn place) { places_[next_++ % places_.size()] = {line, place}; }

  struct Known {
    std::uint64_t line = 0;
    LineColumn place;
  };
  std::array<Known, 16> places_{};
  std::size_t next_ = 0;
};

}  // namespace toolcomp::cli
