// SPDX-License-Identifier: Apache-2.0
// A bundle with bytes that somebody, or a disk, has changed: refused, never a crash, never accepted as another.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "certify/bundle/seal.h"
#include "certify/bundle/verify.h"
#include "host/sha256.h"
#include "spec/language/input_error.h"
#include "tests/command_line/bundles.h"
#include "tests/effort.h"

namespace {

using toolcomp::certify::bundle::Verification;
using toolcomp::test::Folder;
using toolcomp::test::Members;

const int kTrials = toolcomp::test::effort(60, 400);

// Nothing: no bundle.
std::optional<Verification> verify(const std::string& file, bool all) {
  toolcomp::certify::bundle::VerifyOptions options;
  options.file = file;
  options.corpus = TOOLCOMP_SOURCE_DIR "/corpus/golden";
  options.sample = 3;
  options.all = all;
  try {
    return toolcomp::certify::bundle::verify(options);
  } catch (const toolcomp::spec::InputError&) {
    return std::nullopt;
  }
}

// A bundle of two programs, which is judged in no time.
class Bytes : public testing::Test {
 protected:
  void SetUp() override {
    const std::string program = TOOLCOMP_SOURCE_DIR "/examples/fanuc/three-hole-boring/three-holes.nc";
    const auto outcome = toolcomp::test::toolcomp("certify --controller '" TOOLCOMP_BINARY_DIR
                                                  "/toolcomp serve --engine fast' --report " +
                                                  folder.path("r") + " --evidence " + file + " " + program);
    ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    ASSERT_TRUE(verify(file, true)->refused.empty());
    bytes = toolcomp::test::read(file);
  }
  std::size_t below(std::size_t n) { return random() % n; }
  // A flip, some bytes in place of others, a piece taken out, twice there, or cut off.
  std::string changed(std::string text) {
    if (text.empty()) return "x";
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(std::min<std::size_t>(text.size() - at, 40));
    switch (below(5)) {
      case 0:
        text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << below(8)));
        break;
      case 1:
        for (std::size_t i = 0; i < length; ++i) text[at + i] = static_cast<char>(below(256));
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, text.substr(at, length));
        break;
      default:
        text.resize(at);
        break;
    }
    return text;
  }

  const Folder folder;
  const std::string file = folder.path("e.tar.zst");
  std::string bytes;
  std::mt19937_64 random{20};
};

TEST_F(Bytes, AnyOtherByteIsRefused) {
  for (int i = 0; i < kTrials; ++i) {
    const std::string other = changed(bytes);
    if (other == bytes) continue;
    const auto verification = verify(folder.write("o.tar.zst", other), false);
    EXPECT_TRUE(!verification || !verification->refused.empty()) << i;
  }
}

// With a seal that fits: what decompressor and archive make of it is the same bundle, or refused.
TEST_F(Bytes, SealedAgainItIsTheSameOrRefused) {
  const std::string body = bytes.substr(0, bytes.size() - toolcomp::certify::bundle::seal(std::string(64, '0')).size());
  const Members members = toolcomp::test::members_of(file);
  for (int i = 0; i < kTrials; ++i) {
    const std::string other = changed(body);
    const std::string name =
        folder.write("o.tar.zst", other + toolcomp::certify::bundle::seal(toolcomp::host::sha256(other)));
    const auto verification = verify(name, false);
    if (verification && verification->refused.empty()) {
      EXPECT_TRUE(toolcomp::test::members_of(name) == members) << i;
    }
  }
}

// With digests that fit: what is in the members is read by whoever expects the worst.
TEST_F(Bytes, MembersMayHoldAnything) {
  const Members members = toolcomp::test::members_of(file);
  int refused = 0;
  for (const char* name :
       {"manifest.json", "cases.jsonl", "answers.jsonl", "results.jsonl", "certificate.json", "hello.json"})
    for (int i = 0; i < kTrials / 8; ++i) {
      Members other = members;
      other[name] = changed(members.at(name));
      try {
        toolcomp::test::adapt_manifest(other);
      } catch (const nlohmann::json::exception&) {
        // The manifest itself is what was changed.
      }
      toolcomp::test::write_bundle(folder.path("o.tar.zst"), other);
      const auto verification = verify(folder.path("o.tar.zst"), true);
      if (!verification || !verification->refused.empty()) ++refused;
    }
  // What nobody judges may be another: a blank, a comment, the number of a word that is not announced.
  EXPECT_GT(refused, kTrials / 8 * 4);
}

}  // namespace
