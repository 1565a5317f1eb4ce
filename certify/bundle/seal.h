// SPDX-License-Identifier: Apache-2.0
// The seal, the last bytes of a bundle: a digest of all bytes before them.
#pragma once

#include <filesystem>
#include <string>

namespace toolcomp::certify::bundle {

// A frame that zstd skips, with these hexadecimal digits of a SHA-256.
std::string seal(const std::string& digest);

// Whether a file ends with the seal of the bytes before it. Any changed, added or missing byte makes this false. Throws
// spec::InputError for a file that cannot be read.
bool is_sealed(const std::filesystem::path& file);

}  // namespace toolcomp::certify::bundle
