// SPDX-License-Identifier: Apache-2.0
// What a program's page says of each block, as data: text, exact numbers, decisions.
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

// Of a page with blocks beside the drawing.
struct ProgramView {
  const ProgramRun* run = nullptr;
  std::vector<std::pair<std::uint64_t, std::string>> files;  // that are called: the first line of each in the text
  int digits = 15;                                           // decimals of exact numbers
};

// How many blocks a page has at most; a page says what it leaves out.
inline constexpr std::size_t kMostBlocks = 20'000;

// `step_of`: by event of the run, the number of its step in the view, or nothing (SIZE_MAX). `number_of`: the number of
// a clause on the page.
nlohmann::ordered_json program_data(const spec::Case& c, const ProgramView& view,
                                    const std::vector<std::size_t>& step_of,
                                    const std::function<std::size_t(spec::Clause)>& number_of);

// A clause as `toolcomp spec show --json` has it.
nlohmann::ordered_json clause_data(spec::Clause clause);

}  // namespace toolcomp::certify
