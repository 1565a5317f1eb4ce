// FANUC program text to blocks. Syntax only: modal and one-shot words are left uninterpreted.
#pragma once

#include <memory>

#include "spec/language/axes.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/reader_options.h"

namespace toolcomp::spec {

// Reads blocks one by one in constant memory, whatever the length of a line. Reading rules: README.md of this folder.
class ProgramReader {
 public:
  ProgramReader(std::unique_ptr<ByteSource> source, const Axes& axes, ReaderOptions options = {});
  ~ProgramReader();
  ProgramReader(ProgramReader&&) noexcept;
  ProgramReader& operator=(ProgramReader&&) noexcept;

  // The next block with at least one word (or an alarm) into `block`; false at the end of the text or at the `%` that
  // ends it. Throws InputError for bytes that are no text. Does not allocate.
  bool next(Block& block);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toolcomp::spec
