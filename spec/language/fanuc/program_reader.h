// SPDX-License-Identifier: Apache-2.0
// FANUC program text to blocks. Syntax only: modal and one-shot words are left uninterpreted.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "spec/language/axes.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/reader_options.h"

namespace toolcomp::spec {

// Reads blocks one by one in the order in which they run: M98, M99 and custom macros are followed. In constant memory,
// whatever the length of a line, up to the first M98 or macro statement; from there on the rest of the text is kept.
// Reading rules: README.md of this folder.
class ProgramReader {
 public:
  ProgramReader(std::unique_ptr<ByteSource> source, const Axes& axes, ReaderOptions options = {});
  ~ProgramReader();
  ProgramReader(ProgramReader&&) noexcept;
  ProgramReader& operator=(ProgramReader&&) noexcept;

  // The next block with at least one word (or an alarm) into `block`; false at the end of the text or at the `%` that
  // ends it, behind M99 of the main program, and after too many blocks of programs called. Throws InputError for bytes
  // that are no text. Allocates where a program is called or a macro statement stands, else not.
  bool next(Block& block);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// The text of a program and behind it that of each file it calls, as ReaderOptions::called_program gives them, in the
// order of the calls in the text; as it is where it calls none. Blocks have the lines of this text.
std::string joined_program(std::string_view text, const Axes& axes, const ReaderOptions& options);

}  // namespace toolcomp::spec
