// SPDX-License-Identifier: Apache-2.0
// Cases as a fuzzer's bytes and back.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "spec/language/case.h"

namespace toolcomp::fuzz {

// Setup and program of a case as compact text: one setup value a line, a line "%%", then the program as it stands.
std::string encode(const spec::Case& c);
// Total: any bytes are a case. Lines that say nothing, or nothing possible, are left out; without "%%" there is no
// program. decode(s, encode(c)) has c's setup and program, for every case c that a generator makes.
spec::Case decode(std::string_view section, std::string_view bytes);

inline std::string_view as_text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};  // NOLINT(*-reinterpret-cast): bytes as text
}

}  // namespace toolcomp::fuzz
