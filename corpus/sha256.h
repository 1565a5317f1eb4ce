// SHA-256 (FIPS 180-4), for manifests and certificates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace toolcomp::corpus {

// A digest built piece by piece; the digest of a text does not depend on how it is cut.
class Sha256 {
 public:
  void update(std::string_view bytes);
  // The digest of all bytes so far, 64 lower-case hexadecimal digits. Nothing may be added afterwards.
  [[nodiscard]] std::string hex();

 private:
  void compress(const unsigned char* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> buffer_{};
  std::size_t buffered_ = 0;
  std::uint64_t length_ = 0;  // bytes
};

// The digest of `bytes`, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

// The digest of the file at `path`; throws spec::InputError if it cannot be read.
std::string sha256_file(const std::string& path);

}  // namespace toolcomp::corpus
