// SPDX-License-Identifier: Apache-2.0
// Files: read whole or in pieces; what cannot be read is an InputError that says why.
#include "spec/language/byte_source.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "spec/language/input_error.h"

namespace {

using namespace toolcomp::spec;

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("toolcomp_byte_source_" + std::to_string(getpid()));
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& text) const {
    const std::string path = (folder_ / "file").string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  std::filesystem::path folder_;
};

TEST_F(Files, AreReadWholeOrInPieces) {
  const std::string text = "G0\r\n\xFF" + std::string(200'000, 'x');
  const std::string path = write(text);
  EXPECT_EQ(read_file(path), text);
  const auto source = file_source(path);
  std::array<char, 3> buffer{};
  EXPECT_EQ(source->read(buffer.data(), buffer.size()), 3U);
  EXPECT_EQ(std::string(buffer.data(), 3), "G0\r");
}

TEST_F(Files, ErrorsSayWhy) {
  const auto error = [](const std::string& path) -> std::string {
    try {
      read_file(path, 10);
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_EQ(error("/no/such/file.nc"), "/no/such/file.nc: cannot be read: No such file or directory");
  EXPECT_EQ(error(folder_.string()), folder_.string() + ": cannot be read: Is a directory");
  const std::string path = write("01234567890");
  EXPECT_EQ(error(path), path + ": is longer than 10 bytes");
  EXPECT_THROW(file_source("/no/such/file.nc"), InputError);
}

TEST(InputErrors, PositionsThatAreZeroAreLeftOut) {
  EXPECT_STREQ(InputError("f", 2, 3, "wrong").what(), "f:2:3: wrong");
  EXPECT_STREQ(InputError("f", 2, 0, "wrong").what(), "f:2: wrong");
  EXPECT_STREQ(InputError("f", 0, 0, "wrong").what(), "f: wrong");
  EXPECT_EQ(InputError("f", 2, 3, "wrong").message(), "wrong");
  EXPECT_EQ(display_name("-"), "standard input");
  EXPECT_EQ(display_name("a.nc"), "a.nc");
}

}  // namespace
