// SPDX-License-Identifier: Apache-2.0
// What this project does not follow in a program that a control may well run.
#pragma once

#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::spec::klartext {

// Nothing, or a static text that names what of this block is not supported: the run ends here with an alarm of ours
// (E_UNSUPPORTED, E_TOO_LONG), or it goes on as if the words did nothing (PLANE SPATIAL, M94 …). What a control does
// from here on is nothing that a run of ours could judge.
inline const char* not_supported(const Block& block) {
  if (block.alarm) return block.alarm->beyond ? block.alarm->message : nullptr;
  return block.passed_over;
}

}  // namespace toolcomp::spec::klartext
