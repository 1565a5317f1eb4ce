// SPDX-License-Identifier: Apache-2.0
// The files of the hard cases: manifest, cases, and the page with the tables.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "corpus/hard.h"

namespace toolcomp::corpus {

// "positive", "negative", "tie"; "ulp", "µm".
std::string_view name_of(exact::Sign outcome);
std::string_view name_of(Deviation of);

// The text of each file, by its name in the folder. The ids of the cases are made, lists sorted.
std::map<std::string, std::string> hard_files(HardCases& hard);

}  // namespace toolcomp::corpus
