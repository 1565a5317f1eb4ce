// SPDX-License-Identifier: Apache-2.0
// The last bytes of a bundle: a digest of all that stands before them.
#pragma once

#include <filesystem>
#include <string>

namespace toolcomp::certify::bundle {

// A frame that zstd passes over, with these hexadecimal digits of a SHA-256.
std::string seal(const std::string& digest);

// Whether a file ends with the seal of what stands before it: any other byte, one more or one less, and it does not.
// Throws spec::InputError for a file that cannot be read.
bool is_sealed(const std::filesystem::path& file);

}  // namespace toolcomp::certify::bundle
