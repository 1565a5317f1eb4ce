// What a verb works on: a case or a program with its setup, read from the files named on the command line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cli/called_files.h"
#include "fuzz/oracle/verdict.h"
#include "spec/language/case.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {

// A program of any length with its setup. A case's program is held in memory, a program file is streamed.
class Program {
 public:
  // `path` names a case (it ends in .json, or its first character is `{`) or a program; "-" is standard input. `setup`
  // names a setup file, TOML or JSON by its ending; empty: setup.toml beside the program. `samples` replaces those of a
  // case. Throws spec::InputError.
  Program(const std::string& path, const std::string& setup, std::optional<std::uint32_t> samples = {});

  [[nodiscard]] const spec::Setup& setup() const { return case_.setup; }
  // Its text, from the beginning each time; that of standard input once. Valid while this program is.
  [[nodiscard]] fuzz::StreamedProgram text() const;
  // The case itself, or the program as one (read whole).
  [[nodiscard]] spec::Case as_case() const;
  [[nodiscard]] const std::string& path() const { return path_; }
  // Where a line of the text that is read stands: in its file, or in one that it calls.
  [[nodiscard]] Place place(std::uint64_t line, std::uint64_t column = 1) const;
  // The same for a fault of the input.
  [[nodiscard]] spec::InputError placed(const spec::InputError& error) const;
  [[nodiscard]] bool is_case() const { return is_case_; }
  // Into how many parts blocks under tool center point control are divided (docs/events.md, rule 7); 0: no samples.
  [[nodiscard]] std::uint32_t samples() const { return case_.samples; }

 private:
  std::string path_;
  spec::Case case_;
  bool is_case_ = false;
  std::unique_ptr<CalledFiles> called_;
};

// Throws spec::InputError, with the place in the file, also for what only the engines refuse (check_setup).
spec::Setup read_setup(const std::string& path);
// What only the engines refuse: kinematics no machine could have, tables of deviations that are missing.
void check_setup(const spec::Setup& setup);

// How many processors work on this program: those asked for (0: all), one for a program that is small or can be read
// only once.
unsigned jobs_for(const Program& program, unsigned asked);

// Throws spec::InputError where the program of a case holds what no control would read, up to where the run ends.
// `name` stands for the program in it.
void expect_readable(const spec::Case& c, const std::string& name);

// Throws spec::InputError that names the option if no folder can stand at `path`, before hours of work end there.
void expect_folder(const std::string& path, const std::string& option);

// Reports an alarm of reading or of the run on standard error: FILE:LINE:COLUMN: NUMBER message.
void report_alarm(const std::string& file, std::uint64_t line, std::uint64_t column, std::string_view number,
                  std::string_view message);

// Where alarms point to: the places of the blocks read lately, for those that name an earlier block. A block of several
// lines has its alarm of reading where the fault is.
class RecentBlocks {
 public:
  struct LineColumn {
    std::uint64_t line = 0;
    std::uint64_t column = 1;
  };

  // The block has to be there, and the one read last, where place() is asked.
  void add(const spec::Block& block);
  void add(const spec::klartext::Block& block);
  // Of the block that begins in this line; column 1 of it where the block is no longer known.
  [[nodiscard]] LineColumn place(std::uint64_t line) const;

 private:
  void add(std::uint64_t line, LineColumn place) { places_[next_++ % places_.size()] = {line, place}; }

  struct Known {
    std::uint64_t line = 0;
    LineColumn place;
  };
  const spec::Block* latest_ = nullptr;
  std::array<Known, 16> places_{};
  std::size_t next_ = 0;
};

}  // namespace toolcomp::cli
