// SPDX-License-Identifier: Apache-2.0
// A detached signature next to a bundle, FILE.asc, made and checked by gpg.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace toolcomp::certify::bundle {

// FILE.asc.
std::filesystem::path signature_file(const std::filesystem::path& file);

// Throws spec::InputError if gpg is missing, or has no secret key of this name.
void expect_key(const std::string& key);
// Signs the file, and replaces an existing signature. Throws spec::InputError with the message of gpg.
void sign(const std::filesystem::path& file, const std::string& key);

struct Signature {
  bool there = false;
  bool good = false;
  std::string words;  // "good, by NAME (FINGERPRINT)", or why it is not
};
Signature check_signature(const std::filesystem::path& file);

}  // namespace toolcomp::certify::bundle
