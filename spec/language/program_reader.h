// FANUC program text to blocks. Syntax only: modal and one-shot words are left uninterpreted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <string_view>

#include "spec/language/axes.h"
#include "spec/language/block.h"

namespace toolcomp::spec {

// Where program bytes come from.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  // Up to `size` bytes into `buffer`; 0 at the end.
  virtual std::size_t read(char* buffer, std::size_t size) = 0;
};
std::unique_ptr<ByteSource> stream_source(std::istream& stream);
// The text must outlive the source.
std::unique_ptr<ByteSource> text_source(std::string_view text);

struct ReaderOptions {
  std::string file = "program";  // for messages
  bool block_skip = false;       // blocks that begin with / are skipped
};

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

// The text of a block, as the reader reads it back: "N30 G01 X10. Y-0".
std::string to_string(const Block& block);

}  // namespace toolcomp::spec
