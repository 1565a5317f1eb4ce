// SPDX-License-Identifier: Apache-2.0
// Lines that a reader gives as columns are the blocks that it gives one by one.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "fuzz/targets/worker.h"
#include "spec/language/input_error.h"
#include "spec/language/line_columns.h"

namespace toolcomp::fuzz {

// Two readers of one text: after each block the first gives up to `most` lines as columns and passes half of them. Both
// give the same blocks, by same(block, block) and is_line(block, columns, line), and end with the same error or none.
template <class Block, class Reader, class Same, class IsLine>
void read_by_columns(Reader& reader, Reader& one_by_one, std::size_t most, Same same, IsLine is_line) {
  const auto columns = std::make_unique<spec::LineColumns>();
  Block block;
  Block other;
  std::string error;
  const auto next_of_others = [&] {
    try {
      return one_by_one.next(other);
    } catch (const spec::InputError& fault) {
      error = fault.what();
      return false;
    }
  };
  try {
    while (reader.next(block)) {
      require(next_of_others() && same(block, other));
      reader.lines(*columns, most);
      const std::size_t passed = columns->size / 2;
      for (std::size_t i = 0; i < passed; ++i) require(next_of_others() && is_line(other, *columns, i));
      if (passed > 0) reader.pass_lines(passed);
    }
    require(!next_of_others() && error.empty());
  } catch (const spec::InputError& fault) {
    while (next_of_others()) {
    }
    require(error == fault.what());
  }
}

}  // namespace toolcomp::fuzz
