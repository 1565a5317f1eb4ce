// SPDX-License-Identifier: Apache-2.0
// The clause counters steer libFuzzer only if it reports them: from a shared library they would be lost in silence.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include "fuzz/campaign/steering.h"

namespace toolcomp::fuzz {
namespace {

namespace fs = std::filesystem;

// What a command prints, both streams.
std::string output(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return text;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
  pclose(pipe);
  return text;
}

TEST(ExtraCounters, LibFuzzerReportsEveryFeature) {
  const fs::path target = fs::path(TOOLCOMP_SOURCE_DIR) / "build/fuzz/leading_edge_offset_directed";
  if (!fs::exists(target)) GTEST_SKIP() << "no clang fuzz build";
  const std::string text = output("'" + target.string() + "' -runs=500 -seed=1 -max_len=16384");
  // Built from the same clauses: an older build of the targets says nothing about this one.
  EXPECT_NE(text.find(fmt::format("{} Extra Counters", kSteeringSlots)), std::string::npos) << text.substr(0, 2000);
  EXPECT_NE(text.find("acceptance:"), std::string::npos) << text;
}

}  // namespace
}  // namespace toolcomp::fuzz
