// SPDX-License-Identifier: Apache-2.0
// What is worked on: a case or a program with its setup, from files or from memory.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "certify/input/called_files.h"
#include "fuzz/oracle/verdict.h"
#include "spec/language/case.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::input {

// A program of any length with its setup. A case's program is held in memory, a program file is streamed.
class Program {
 public:
  // `path` names a case (it ends in .json, or its first character is `{`) or a program; "-" is standard input. `setup`
  // names a setup file, TOML or JSON by its ending; empty: setup.toml beside the program. `samples` replaces those of a
  // case. Throws spec::InputError.
  Program(const std::string& path, const std::string& setup, std::optional<std::uint32_t> samples = {});
  // The same with the setup given.
  Program(const std::string& path, const spec::Setup& setup, std::optional<std::uint32_t> samples);
  // A program in memory, which is not looked at here. `name` stands for it in messages; what it calls is not there.
  Program(std::string name, spec::Case c);

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
  [[noreturn]] void refuse_setup() const;
  void take(spec::Setup setup, std::optional<std::uint32_t> samples);

  std::string path_;
  spec::Case case_;
  bool is_case_ = false;
  std::unique_ptr<CalledFiles> called_;
};

// Throws spec::InputError, with the place in the file, also for what only the engines refuse (check_setup).
spec::Setup read_setup(const std::string& path);
// The same of text, for which `name` stands in messages.
spec::Setup read_setup_text(const std::string& text, const std::string& name, bool json);
// What only the engines refuse: kinematics no machine could have, tables of deviations that are missing.
void check_setup(const spec::Setup& setup);

// Throws spec::InputError where the program of a case holds what no control would read, up to where the run ends.
// `name` stands for the program in it.
void expect_readable(const spec::Case& c, const std::string& name);

}  // namespace toolcomp::certify::input
