// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/long_program.h"

#include <cstddef>

#include "judge/oracle/control.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::fuzz {

bool repeats_much(const spec::Case& c) {
  constexpr std::size_t kMostBlocks = 4000;
  return judge::with_control(c.setup, [&]<class Control>(Control) {
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

judge::Trial try_short(const spec::Case& c, const judge::CaseJudge& judged_by) {
  if (!repeats_much(c)) return judge::try_case(c, judged_by);
  judge::Trial trial;
  trial.acceptance = judge::Acceptance::too_long;
  return trial;
}

}  // namespace toolcomp::fuzz
