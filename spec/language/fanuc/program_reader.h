// SPDX-License-Identifier: Apache-2.0
// Reads the blocks of FANUC program text. Only syntax: it does not interpret modal and one-shot words.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "spec/language/axes.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/line_columns.h"
#include "spec/language/reader_options.h"

namespace toolcomp::spec {

// Reads blocks one by one in the order in which they run, following M98, M99 and custom macros. Needs constant memory,
// whatever the length of a line, up to the first M98 or macro statement. From there on it keeps the rest of the text.
// Reading rules: README.md of this folder.
class ProgramReader {
 public:
  ProgramReader(std::unique_ptr<ByteSource> source, const Axes& axes, ReaderOptions options = {});
  ~ProgramReader();
  ProgramReader(ProgramReader&&) noexcept;
  ProgramReader& operator=(ProgramReader&&) noexcept;

  // The next block with at least one word (or an alarm) into `block`; false at the end of the text or at the `%` that
  // ends it, after M99 of the main program, and after too many blocks of called programs. Throws InputError for bytes
  // that are not text. Allocates only if a program is called or a macro statement is read.
  bool next(Block& block);
  // The usual lines after the block read last (BlockReader::lines); none in a called program, and after a jump. They
  // are still to be read, but for those that pass_lines() goes past.
  void lines(LineColumns& to, std::size_t most);
  void pass_lines(std::size_t count);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// The text of a program, followed by the text of each file that it calls, as ReaderOptions::called_program gives them,
// in the order of the calls in the text. If it calls none, the text is unchanged. Blocks have the line numbers of this
// text.
std::string joined_program(std::string_view text, const Axes& axes, const ReaderOptions& options);

}  // namespace toolcomp::spec
