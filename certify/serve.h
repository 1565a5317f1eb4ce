// SPDX-License-Identifier: Apache-2.0
// The controller's side of the protocol, for the engines of toolcomp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <ostream>
#include <string>
#include <string_view>

#include "certify/capabilities.h"

namespace toolcomp::certify {

enum class ServedEngine : std::uint8_t { model, fast, specification };

// So many decimals that an irrational coordinate can be judged by the same rule as a double.
inline constexpr int kModelDigits = 40;

// The capabilities of the engine: every section, every field.
Capabilities served_capabilities(ServedEngine engine);

// The answer to one request line, without a line feed: capabilities for {"hello":1}, the events for a case. Throws
// spec::InputError for anything else. The model prints 40 decimals.
std::string answer(ServedEngine engine, std::string_view request);

// Answers requests line by line until the input ends. A request that cannot be read is answered with
// {"error":"stdin:LINE:COLUMN: …"}, also reported on `errors`, and the next one is read. A request of more than `limit`
// bytes is such a request too. Returns the number of requests that could not be read.
std::uint64_t serve(ServedEngine engine, std::istream& in, std::ostream& out, std::ostream& errors,
                    std::size_t limit = std::size_t{256} << 20);

}  // namespace toolcomp::certify
