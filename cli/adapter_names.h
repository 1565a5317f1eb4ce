// SPDX-License-Identifier: Apache-2.0
// The adapters that are there.
#pragma once

#include <string>
#include <vector>

namespace toolcomp::cli {

// Their names, of these folders and of those that are searched anyway (certify::adapter_folders()). A manifest that
// cannot be read has none.
std::vector<std::string> adapter_names(const std::vector<std::string>& folders);

// Throws spec::InputError that names what may be meant, for a word that could name an adapter, is near one, and is no
// command either.
void expect_no_slip(const std::string& controller, const std::vector<std::string>& folders);

}  // namespace toolcomp::cli
