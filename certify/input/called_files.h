// SPDX-License-Identifier: Apache-2.0
// The files that a program calls, and the places of their lines in the joined text.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "spec/language/reader_options.h"
#include "spec/language/setup.h"

namespace toolcomp::certify::input {

struct Place {
  std::string file;
  std::uint64_t line = 0;
  std::uint64_t column = 1;
};

class CalledFiles {
 public:
  // Files that `main` calls are in the same folder. Standard input ("-") calls no files.
  CalledFiles(std::string main, spec::Control control) : main_(std::move(main)), control_(control) {}

  // The function for a reader of the program, valid as long as this object. It remembers which files the reader joined.
  spec::CalledProgram finder();
  // The file and line of a line of the joined text, as far as a reader has joined it.
  [[nodiscard]] Place place(std::uint64_t line, std::uint64_t column) const;

 private:
  std::string main_;
  spec::Control control_;
  std::map<std::uint64_t, std::filesystem::path> begins_;  // by the first line in the joined text
};

}  // namespace toolcomp::certify::input
