// SPDX-License-Identifier: Apache-2.0
// Cases as the formal specification takes them: trees of whole numbers and texts, read by the readers of spec/language.
#pragma once

#include <cstdint>
#include <exception>
#include <optional>
#include <vector>

#include "spec/language/case.h"
#include "spec_engine/data.h"

namespace toolcomp::spec_engine {

struct Place {
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
};

struct CaseData {
  Data data = List{};            // dialect, setup, blocks: what run_case takes (spec/formal/program/Case.v)
  std::vector<Place> places;     // of the blocks
  const char* beyond = nullptr;  // what of the last block is not followed here, a static text (spec/language/alarm.h)
  std::exception_ptr bad_input;  // in the text behind the last block; it counts where the run reaches kBadInput
};

// As the alarm of a block in whose place there is bad input.
constexpr const char* kBadInput = "bad input";

// Throws spec::InputError for a program that is no text.
CaseData fanuc_case(const spec::Case& c);
CaseData klartext_case(const spec::Case& c);

}  // namespace toolcomp::spec_engine
