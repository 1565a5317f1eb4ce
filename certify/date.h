// SPDX-License-Identifier: Apache-2.0
// The date of a report or a file.
#pragma once

#include <string>

namespace toolcomp::certify {

// Now, or the time that reproducible builds agree on (SOURCE_DATE_EPOCH): ISO 8601, UTC.
std::string date_of_now();

}  // namespace toolcomp::certify
