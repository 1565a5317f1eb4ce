// SPDX-License-Identifier: Apache-2.0
// Programs in programs: the reader has followed the call; what is left is to say which clause it was.
#pragma once

#include "model/basis/recorder.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::model::klartext {

// A block LBL, CALL LBL or CALL PGM, or the end of a program that was called.
void record_call(Recorder& recorder, const spec::klartext::Block& block);

}  // namespace toolcomp::model::klartext
