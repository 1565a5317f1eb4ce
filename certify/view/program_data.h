// SPDX-License-Identifier: Apache-2.0
// The data for each block on a program's page: text, exact numbers, decisions.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "certify/view/program_run.h"
#include "spec/clauses/clauses.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

// The data of a page with blocks next to the drawing.
struct ProgramView {
  const ProgramRun* run = nullptr;
  std::vector<std::pair<std::uint64_t, std::string>> files;  // called files, each with its first line in the text
  int digits = 15;                                           // decimals of exact numbers
};

// The largest number of blocks on a page. A page says what it leaves out.
inline constexpr std::size_t kMostBlocks = 20'000;

// `step_of`: for each event of the run, the number of its step in the view, or SIZE_MAX if it has none. `number_of`:
// the number of a clause on the page.
nlohmann::ordered_json program_data(const spec::Case& c, const ProgramView& view,
                                    const std::vector<std::size_t>& step_of,
                                    const std::function<std::size_t(spec::Clause)>& number_of);

// A clause in the form of `toolcomp spec show --json`.
nlohmann::ordered_json clause_data(spec::Clause clause);

}  // namespace toolcomp::certify
