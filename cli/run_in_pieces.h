// SPDX-License-Identifier: Apache-2.0
// toolcomp run on several processors: the same bytes.
#pragma once

#include "cli/program.h"
#include "cli/verbs.h"

namespace toolcomp::cli {

// Formats in which the text of an event depends on no other event.
bool runs_in_pieces(Format format);

// The exit status. The fast engine runs in one thread and its events are printed piece by piece; the model runs piece
// by piece (fuzz/parallel/in_pieces.h). Throws spec::InputError.
int run_in_pieces(const Program& program, const RunOptions& options, unsigned jobs);

}  // namespace toolcomp::cli
