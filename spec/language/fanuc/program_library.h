// SPDX-License-Identifier: Apache-2.0
// The programs that a FANUC program may call: those in its own text, and those in files that are joined to it.
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

// What a block with M98 calls.
struct ProgramCall {
  std::string program;      // "O1000", or the name in < >; empty: none is named
  std::uint64_t times = 1;  // how often it runs
};
// `block` has been read last by `reader`.
ProgramCall program_call(const Block& block, const BlockReader& reader);

class ProgramLibrary {
 public:
  struct Program {
    std::string_view text;  // from its head to the head of the next one, or to the end of its file
    std::uint64_t line = 1;
  };

  // A part of a text.
  struct Piece {
    std::string name;  // of the program; of the first piece, which stands before any head, empty
    std::string_view text;
    std::uint64_t line = 1;
  };

  ProgramLibrary(Axes axes, ReaderOptions options) : axes_(std::move(axes)), options_(std::move(options)) {}

  // Adds the text behind a call of `program`, whose first line has this number, with the programs whose heads stand in
  // it; then the files of what is called, from this call on, in the order of the text, each followed by those that it
  // calls itself. A file without the head of its program gets one, in its first line with a block. Lines count on. The
  // text up to the first head in it.
  std::string_view add(std::string text, std::uint64_t first_line, const std::string& program);
  [[nodiscard]] std::optional<Program> find(const std::string& program) const;
  // All texts that were added, one behind the other, each ending with its line.
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
