// SPDX-License-Identifier: Apache-2.0
// Three voices on one case: the exact model, the formal specification, and a third that computes independently, the
// fast engine or a controller. If two of them disagree, the third one shows which one stands alone.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "certify/subject.h"

namespace toolcomp::certify {

enum class Alone : std::uint8_t {
  other,          // the engine or the controller
  model,          // the model has to be corrected
  specification,  // the formal specification, or its clause, has to be corrected
  each,           // all three differ
  nobody,         // all agree, or the engine agrees with both within its tolerance
  not_known,      // no formal specification is built in, or one of them could not decide
};

struct Voices {
  Alone alone = Alone::not_known;
  std::string words;  // "the model stands alone: fast engine and formal specification agree"
};

inline constexpr std::string_view kFastEngine = "fast engine";

// Model and formal specification are compared exactly (exactly.h); the oracle compares the third voice with each of
// them. `name` is the name of the third voice, such as "fast engine". Always call it from the same thread.
Voices ask_all(const spec::Case& c, Subject& other, std::string_view name);

}  // namespace toolcomp::certify
