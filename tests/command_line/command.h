// SPDX-License-Identifier: Apache-2.0
// Runs the toolcomp command as a user would.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace toolcomp::test {

namespace fs = std::filesystem;

// A folder of its own for each test, removed behind it.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("toolcomp-" + std::to_string(std::random_device{}()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

inline std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Outcome {
  int status = -1;
  std::string out;
  std::string err;

  // The events on standard output, one JSON line each.
  [[nodiscard]] std::vector<nlohmann::json> events() const {
    std::vector<nlohmann::json> list;
    std::size_t from = 0;
    for (std::size_t to = out.find('\n'); to != std::string::npos; from = to + 1, to = out.find('\n', from))
      list.push_back(nlohmann::json::parse(out.substr(from, to - from)));
    return list;
  }
};

// A line as a shell reads it.
inline Outcome command(const std::string& line) {
  const Folder folder;
  const std::string errors = folder.path("stderr");
  Outcome outcome;
  FILE* pipe = popen((line + " 2>" + errors).c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 65536> buffer{};
  while (const std::size_t size = fread(buffer.data(), 1, buffer.size(), pipe)) outcome.out.append(buffer.data(), size);
  const int status = pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.err = read(errors);
  return outcome;
}

// `arguments` as a shell reads them; `shell` stands in front ("ulimit -v 500000;").
inline Outcome toolcomp(const std::string& arguments, const std::string& shell = "") {
  return command(shell + TOOLCOMP_BINARY_DIR "/toolcomp " + arguments);
}

}  // namespace toolcomp::test
