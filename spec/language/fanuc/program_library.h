// SPDX-License-Identifier: Apache-2.0
// The programs that a FANUC program may call: programs in its own text, and programs in files that are joined to it.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spec/language/axes.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/fanuc/block_reader.h"
#include "spec/language/reader_options.h"

namespace toolcomp::spec {

// The program that a block with M98 calls.
struct ProgramCall {
  std::string program;      // "O1000", or the name in < >; empty if none is named
  std::uint64_t times = 1;  // how often it runs
};
// `block` has been read last by `reader`.
ProgramCall program_call(const Block& block, const BlockReader& reader);

class ProgramLibrary {
 public:
  struct Program {
    std::string_view text;  // from its head to the head of the next program, or to the end of its file
    std::uint64_t line = 1;
  };

  // A part of a text.
  struct Piece {
    std::string name;  // of the program; empty for the first piece, which is before any head
    std::string_view text;
    std::uint64_t line = 1;
  };

  ProgramLibrary(Axes axes, ReaderOptions options) : axes_(std::move(axes)), options_(std::move(options)) {}

  // Adds the text after a call of `program`, with the programs whose heads are in it. `first_line` is the number of its
  // first line. Then adds the files of the called programs, from this call on, in the order of the text, each followed
  // by the files that it calls itself. A file without the head of its program gets one, in its first line with a block.
  // Line numbers continue. Returns the text up to its first head.
  std::string_view add(std::string text, std::uint64_t first_line, const std::string& program);
  [[nodiscard]] std::optional<Program> find(const std::string& program) const;
  // All texts that were added, one after the other. Each ends with a line end.
  [[nodiscard]] std::string joined() const;

 private:
  std::vector<Piece> keep(std::string text, const std::string& program);
  void join(const std::string& program);
  void join_called(std::string_view text);

  Axes axes_;
  ReaderOptions options_;
  std::deque<std::string> texts_;
  std::map<std::string, Program, std::less<>> programs_;
  std::uint64_t next_line_ = 1;
};

}  // namespace toolcomp::spec
