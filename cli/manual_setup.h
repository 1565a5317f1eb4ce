// SPDX-License-Identifier: Apache-2.0
// The manual page of setups, made of their schema.
#pragma once

#include <string>

namespace toolcomp::cli {

// toolcomp-setup.5; `date` as "January 31, 2026".
std::string setup_page(const std::string& date);

}  // namespace toolcomp::cli
