// SPDX-License-Identifier: Apache-2.0
// Rules for the form of a golden corpus. Whether its values are right is checked elsewhere.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "corpus/golden.h"

namespace toolcomp::corpus {

// Every breach, "FILE:LINE: what is wrong" or "FILE: what is wrong":
//   manifest  lists every file of vectors once, by name, with its section, number of vectors and SHA-256; the
//             corpus has no other files (a refused .rej, a left .tmp);
//   vectors   are in the form that toolcomp writes, one case in each line; each has its own id (vector_id), the section
//             of its folder, expected events, a source, and, if written by hand, a comment; flags are known and sorted.
// check() proves that clauses, flags and events are those of the run. Throws spec::InputError for a corpus that cannot
// be read at all.
std::vector<std::string> lint(const std::filesystem::path& folder = default_folder());

}  // namespace toolcomp::corpus
