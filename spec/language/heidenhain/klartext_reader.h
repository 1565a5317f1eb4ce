// SPDX-License-Identifier: Apache-2.0
// Reads the blocks of Klartext program text. Only syntax: the engines decide what the words mean.
#pragma once

#include <cstddef>
#include <memory>

#include "spec/language/byte_source.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/line_columns.h"
#include "spec/language/reader_options.h"
#include "spec/language/setup.h"

namespace toolcomp::spec::klartext {

// Reads logical blocks one by one in constant memory. Reading rules: README.md of this folder.
class Reader {
 public:
  // The setup gives the axes, whether blocks with / are skipped, and the rows of the correction table. Of the options
  // only the name of the file is used.
  Reader(std::unique_ptr<ByteSource> source, const Setup& setup, ReaderOptions options = {});
  ~Reader();
  Reader(Reader&&) noexcept;
  Reader& operator=(Reader&&) noexcept;

  // The next block that is neither empty nor a comment nor a structure block, into `block`; false at the end of the
  // text or after END PGM. Throws InputError for bytes that are not text and for correction rows that do not exist.
  // Does not allocate.
  bool next(Block& block);
  // The LN blocks after the block read last, at most `most`, that have the same usual words (klartext_lines.h). There
  // may be none. They are still to be read.
  void lines(LineColumns& to, std::size_t most);
  // Goes past the first `count` of the blocks given last.
  void pass_lines(std::size_t count);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toolcomp::spec::klartext
