// SPDX-License-Identifier: Apache-2.0
// M functions of a block, sorted by when they act.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>

#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::model::klartext {

// Clauses: heidenhain.program.tcpm-on, .tcpm-off, .oversize-switch, .machine-coordinates, .end.
struct Functions {
  bool m128 = false;  // at the start of the block
  bool m107 = false;
  bool machine_coordinates = false;  // M91, M92: for this block
  bool m129 = false;                 // at its end
  bool m108 = false;
  bool ends_program = false;  // M2, M30

  // Statements without M functions have none.
  static Functions of(const spec::klartext::Block& block) {
    using spec::klartext::Statement;
    const bool has_functions = block.statement == Statement::line || block.statement == Statement::line_with_vectors ||
                               block.statement == Statement::stop || block.statement == Statement::miscellaneous;
    const auto* const first = block.function.data();
    const auto* const end = first + (has_functions ? block.functions : 0);
    const auto any = [first, end](std::initializer_list<std::uint16_t> numbers) {
      return std::find_first_of(first, end, numbers.begin(), numbers.end()) != end;
    };
    return {any({128}), any({107}), any({91, 92}), any({129}), any({108}), any({2, 30})};
  }
};

}  // namespace toolcomp::model::klartext
