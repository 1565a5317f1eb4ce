// SPDX-License-Identifier: Apache-2.0
#include "cli/adapter_names.h"

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <sstream>

#include "certify/adapter.h"
#include "spec/language/input_error.h"
#include "spec/language/suggestion.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;

bool is_command(const std::string& word) {
  const char* const path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path(folder) / word).c_str(), X_OK) == 0) return true;
  return false;
}

}  // namespace

std::vector<std::string> adapter_names(const std::vector<std::string>& folders) {
  std::vector<std::string> names;
  for (const fs::path& folder : certify::adapter_folders(folders)) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
      try {
        if (!fs::exists(entry.path() / "manifest.toml")) continue;
        for (const certify::Adapter& adapter : certify::read_manifest(entry.path() / "manifest.toml"))
          names.push_back(adapter.name);
      } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch)
        // Whoever asks for it by name is told what is wrong with it.
      }
    }
  }
  return names;
}

void expect_no_slip(const std::string& controller, const std::vector<std::string>& folders) {
  if (!certify::is_adapter_name(controller) || is_command(controller)) return;
  std::vector<std::string> names = adapter_names(folders);
  names.emplace_back("spec");
  const std::string meant = spec::did_you_mean(controller, names);
  if (!meant.empty())
    throw spec::InputError("--controller", 0, 0, "no adapter and no command \"" + controller + '"' + meant);
}

}  // namespace toolcomp::cli
