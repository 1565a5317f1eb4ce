// SPDX-License-Identifier: Apache-2.0
// Standard output, which may be closed, full, or gone.
#pragma once

namespace toolcomp::cli {

// At the start: where standard input, output or error is closed, no file that is opened later takes its number. What is
// closed stays what cannot be written.
void keep_standard_streams();

// At the end of every verb, and after much was written: throws InputError where not all of it arrived. A reader that
// went away ends the process, without a word.
void check_output();
// Whether any of it was lost so far.
[[nodiscard]] bool output_lost();

}  // namespace toolcomp::cli
