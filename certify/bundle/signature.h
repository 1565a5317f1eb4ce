// SPDX-License-Identifier: Apache-2.0
// A detached signature beside a bundle, FILE.asc, made and checked by gpg.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace toolcomp::certify::bundle {

// FILE.asc.
std::filesystem::path signature_file(const std::filesystem::path& file);

// Throws spec::InputError where gpg is missing, or has no secret key of this name.
void expect_key(const std::string& key);
// Signs the file; a signature that stands there is replaced. Throws spec::InputError with what gpg says.
void sign(const std::filesystem::path& file, const std::string& key);

struct Signature {
  bool there = false;
  bool good = false;
  std::string words;  // "good, by NAME (FINGERPRINT)", or why it is not
};
Signature check_signature(const std::filesystem::path& file);

}  // namespace toolcomp::certify::bundle
