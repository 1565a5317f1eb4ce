// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/seal.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>

#include "host/sha256.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::bundle {
namespace {

// RFC 8878, 3.1.2: skippable frames. The magic number, the length in four bytes, then anything.
constexpr std::string_view kMagic = "\x50\x2a\x4d\x18";
constexpr std::string_view kName = "sha256 ";
constexpr std::size_t kDigits = 64;
constexpr std::size_t kLength = kName.size() + kDigits;
constexpr std::size_t kSeal = kMagic.size() + 4 + kLength;

}  // namespace

std::string seal(const std::string& digest) {
  std::string frame(kMagic);
  for (unsigned shift = 0; shift < 32; shift += 8) frame += static_cast<char>((kLength >> shift) & 0xffU);
  return frame.append(kName).append(digest);
}

bool is_sealed(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!in || error) throw spec::InputError(file.string(), 0, 0, "cannot be read");
  if (size < kSeal) return false;
  host::Sha256 digest;
  std::array<char, std::size_t{1} << 16> buffer{};
  const auto take = [&](std::uintmax_t most) -> std::string_view {
    in.read(buffer.data(), static_cast<std::streamsize>(std::min<std::uintmax_t>(most, buffer.size())));
    return {buffer.data(), static_cast<std::size_t>(in.gcount())};
  };
  for (std::uintmax_t left = size - kSeal; left > 0;) {
    const std::string_view piece = take(left);
    if (piece.empty()) throw spec::InputError(file.string(), 0, 0, "cannot be read to the end");
    digest.update(piece);
    left -= piece.size();
  }
  return take(kSeal) == seal(digest.hex());
}

}  // namespace toolcomp::certify::bundle
