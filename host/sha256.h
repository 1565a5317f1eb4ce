// SPDX-License-Identifier: Apache-2.0
// SHA-256, for manifests and certificates. The digest itself is Nettle's.
#pragma once

#include <nettle/sha2.h>

#include <string>
#include <string_view>

namespace toolcomp::host {

// A digest built piece by piece; the digest of a text does not depend on how it is cut.
class Sha256 {
 public:
  Sha256();
  void update(std::string_view bytes);
  // The digest of all bytes so far, 64 lower-case hexadecimal digits. Nothing may be added afterwards.
  [[nodiscard]] std::string hex();

 private:
  sha256_ctx context_;
};

// The digest of `bytes`, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

// The digest of the file at `path`; throws spec::InputError if it cannot be read.
std::string sha256_file(const std::string& path);

}  // namespace toolcomp::host
