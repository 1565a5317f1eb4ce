// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/long_program.h"

#include <cstddef>

#include "fuzz/oracle/control.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::fuzz {

bool repeats_much(const spec::Case& c) {
  constexpr std::size_t kMostBlocks = 4000;
  return with_control(c.setup, [&]<class Control>(Control) {
    auto reader = Control::reader(spec::text_source(c.program), c.setup, "program");
    typename Control::Block block;
    std::size_t blocks = 0;
    try {
      while (blocks <= kMostBlocks && reader.next(block)) ++blocks;
    } catch (const spec::InputError&) {
      return false;
    }
    return blocks > kMostBlocks;
  });
}

Trial try_short(const spec::Case& c, const Subject& subject) {
  if (!repeats_much(c)) return try_case(c, subject);
  Trial trial;
  trial.acceptance = Acceptance::too_long;
  return trial;
}

}  // namespace toolcomp::fuzz
