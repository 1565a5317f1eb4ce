// SPDX-License-Identifier: Apache-2.0
// Nettle tests its own digest: here that we call it rightly. Expected: an example of FIPS 180-4 (NIST, "Secure Hash
// Standard — example values").
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "host/sha256.h"
#include "spec/language/input_error.h"

namespace toolcomp::host {
namespace {

TEST(Sha256, NistExample) {
  const std::string digest = "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1";
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"), digest);
  Sha256 pieces;
  pieces.update("abcdbcdecdefdefgefghfghi");
  pieces.update("ghijhijkijkljklmklmnlmnomnopnopq");
  EXPECT_EQ(pieces.hex(), digest);
}

TEST(Sha256, FileAndMissingFile) {
  const std::string path = testing::TempDir() + "sha256_test_" + std::to_string(::getpid());
  std::ofstream(path, std::ios::binary) << "abc";
  EXPECT_EQ(sha256_file(path), sha256("abc"));
  EXPECT_THROW(sha256_file(path + ".missing"), spec::InputError);
  std::remove(path.c_str());
}

}  // namespace
}  // namespace toolcomp::host
