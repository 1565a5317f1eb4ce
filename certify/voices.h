// SPDX-License-Identifier: Apache-2.0
// Three voices on one case: the exact model, the formal specification, and a third that computes by its own means, the
// fast engine or a controller. Where two disagree, the one left over says who stands alone.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "certify/subject.h"

namespace toolcomp::certify {

enum class Alone : std::uint8_t {
  other,          // the engine or the controller
  model,          // which is then to be corrected
  specification,  // the formal one, or the clause it says
  each,           // all three differ
  nobody,         // all agree, or the engine agrees with both within what the oracle grants
  not_known,      // no formal specification is built in, or one of them could not decide
};

struct Voices {
  Alone alone = Alone::not_known;
  std::string words;  // "the model stands alone: fast engine and formal specification agree"
};

inline constexpr std::string_view kFastEngine = "fast engine";

// Model and formal specification are held exactly (exactly.h), the other one against either by the oracle. `name`: what
// it is called, "fast engine". From one thread, always the same.
Voices ask_all(const spec::Case& c, Subject& other, std::string_view name);

}  // namespace toolcomp::certify
