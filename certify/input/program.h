// SPDX-License-Identifier: Apache-2.0
// The input of most commands: a case, or a program with its setup, from files or from memory.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "certify/input/called_files.h"
#include "judge/oracle/verdict.h"
#include "spec/language/case.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::input {

// A program of any length with its setup. A case's program is held in memory, a program file is streamed.
class Program {
 public:
  // `path` names a case (it ends in .json, or its first character is `{`) or a program; "-" is standard input. `setup`
  // names a setup file, TOML or JSON by its ending; empty: setup.toml in the folder of the program. `samples` replaces
  // the number of a case. Throws spec::InputError.
  Program(const std::string& path, const std::string& setup, std::optional<std::uint32_t> samples = {});
  // The same with a given setup.
  Program(const std::string& path, const spec::Setup& setup, std::optional<std::uint32_t> samples);
  // A program in memory, which is not checked here. `name` is its name in messages. It cannot call other files.
  Program(std::string name, spec::Case c);

  [[nodiscard]] const spec::Setup& setup() const { return case_.setup; }
  // The text, each time from the beginning; standard input can be read only once. Valid as long as this program.
  [[nodiscard]] judge::StreamedProgram text() const;
  // The case itself, or the program as a case (the whole text is read).
  [[nodiscard]] spec::Case as_case() const;
  [[nodiscard]] const std::string& path() const { return path_; }
  // The place of a line of the joined text: in the file of the program, or in a file that it calls.
  [[nodiscard]] Place place(std::uint64_t line, std::uint64_t column = 1) const;
  // The error with such a place.
  [[nodiscard]] spec::InputError placed(const spec::InputError& error) const;
  [[nodiscard]] bool is_case() const { return is_case_; }
  // The number of parts into which blocks under tool center point control are divided (docs/events.md, rule 7); 0: no
  // samples.
  [[nodiscard]] std::uint32_t samples() const { return case_.samples; }

 private:
  [[noreturn]] void refuse_setup() const;
  void take(spec::Setup setup, std::optional<std::uint32_t> samples);

  std::string path_;
  spec::Case case_;
  bool is_case_ = false;
  std::unique_ptr<CalledFiles> called_;
};

// Throws spec::InputError, with the place in the file, also for setups that only the engines refuse (check_setup).
spec::Setup read_setup(const std::string& path);
// The same for a text. `name` is its name in messages.
spec::Setup read_setup_text(const std::string& text, const std::string& name, bool json);
// Refuses setups that only the engines refuse: kinematics that no machine could have, missing tables of deviations.
void check_setup(const spec::Setup& setup);

// Throws spec::InputError if the program of a case, up to the end of the run, contains something that no control would
// read. `name` is the name of the program in the message.
void expect_readable(const spec::Case& c, const std::string& name);

}  // namespace toolcomp::certify::input
