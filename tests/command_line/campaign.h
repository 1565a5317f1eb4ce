// SPDX-License-Identifier: Apache-2.0
// What tests of `toolcomp fuzz` ask of its folder and its process.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "tests/command_line/command.h"

namespace toolcomp::test {

// What is in a folder, by name; of one that is not there nothing.
inline std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> list;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder)) list.push_back(entry.path());
  std::ranges::sort(list);
  return list;
}

// The folders of what a campaign found.
inline std::vector<fs::path> dossiers(const std::string& campaign) {
  std::vector<fs::path> list = entries(fs::path(campaign) / "findings");
  // One that is being written has a name with a dot in front.
  std::erase_if(list, [](const fs::path& path) {
    return path.filename().string().starts_with('.') || !fs::exists(path / "finding.txt");
  });
  return list;
}

inline nlohmann::json state_of(const std::string& campaign) {
  return nlohmann::json::parse(read(campaign + "/state.json"));
}

inline bool alive(int process) { return ::kill(process, 0) == 0; }

// Waits until it is true; so long is far more than it takes.
template <class Condition>
bool comes_true(Condition condition, int seconds = 300) {
  for (int i = 0; i < seconds * 20; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

// A campaign in the background, until it is told to end.
class Background {
 public:
  explicit Background(const std::string& line) {
    const std::string file = folder_.path("process");
    // NOLINTNEXTLINE(cert-env33-c): as a user does
    EXPECT_EQ(
        std::system((line + " >" + folder_.path("out") + " 2>" + folder_.path("err") + " & echo $! >" + file).c_str()),
        0);
    process_ = std::stoi(read(file));
  }
  ~Background() {
    if (alive(process_)) ::kill(process_, SIGKILL);
  }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  [[nodiscard]] int process() const { return process_; }
  [[nodiscard]] std::string out() const { return read(folder_.path("out")); }
  [[nodiscard]] std::string errors() const { return read(folder_.path("err")); }
  [[nodiscard]] bool end(int signal) const {
    ::kill(process_, signal);
    return comes_true([this] { return !alive(process_); });
  }

 private:
  Folder folder_;
  int process_ = 0;
};

}  // namespace toolcomp::test
