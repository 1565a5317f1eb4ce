// SPDX-License-Identifier: Apache-2.0
// Dates: ISO 8601, UTC.
#pragma once

#include <string>

namespace toolcomp::host {

// Now.
std::string time_of_now();
// The date of a report or a file: now, or the time that reproducible builds agree on (SOURCE_DATE_EPOCH).
std::string date_of_now();

}  // namespace toolcomp::host
