// SPDX-License-Identifier: Apache-2.0
#include "certify/running_mark.h"

#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "host/date.h"
#include "host/file_writer.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"
#include "spec/language/outside_json.h"

namespace toolcomp::certify {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr auto kInterval = std::chrono::milliseconds(500);

// Whether the process of that number is another one of this program.
bool is_running(std::int64_t process) {
  std::error_code none;
  const fs::path self = fs::read_symlink("/proc/self/exe", none);
  return process > 0 && process != ::getpid() && !self.empty() &&
         fs::read_symlink(fmt::format("/proc/{}/exe", process), none) == self;
}

template <class Value>
Value value_at(const Json& state, const char* key) {
  const auto entry = state.find(key);
  try {
    return entry == state.end() ? Value{} : entry->get<Value>();
  } catch (const Json::exception&) {
    return Value{};
  }
}

std::optional<RunningMark::Earlier> read_mark(const fs::path& file) {
  if (!fs::exists(file)) return std::nullopt;
  const Json state = spec::read_outside_json(spec::read_file(file), file.string());
  if (!state.is_object()) return RunningMark::Earlier{};
  if (const auto process = value_at<std::int64_t>(state, "process"); is_running(process))
    throw spec::InputError(file.parent_path().string(), 0, 0,
                           fmt::format("process {} is still working in this folder", process));
  return RunningMark::Earlier{value_at<std::string>(state, "begun"), value_at<std::uint64_t>(state, "done"),
                              value_at<std::uint64_t>(state, "all")};
}

}  // namespace

RunningMark::RunningMark(const fs::path& folder, std::string command)
    : made_folder_(!fs::exists(folder)),
      file_(folder / "running.json"),
      command_(std::move(command)),
      begun_(host::time_of_now()),
      earlier_(read_mark(file_)) {
  write(0, 0);
}

RunningMark::~RunningMark() {
  std::error_code none;
  fs::remove(file_, none);
  if (made_folder_) fs::remove(file_.parent_path(), none);
}

void RunningMark::progress(std::uint64_t done, std::uint64_t all) {
  if (std::chrono::steady_clock::now() - last_ >= kInterval) write(done, all);
}

void RunningMark::write(std::uint64_t done, std::uint64_t all) {
  last_ = std::chrono::steady_clock::now();
  const Json state{{"process", ::getpid()}, {"begun", begun_}, {"controller", command_}, {"done", done}, {"all", all}};
  host::write_file(file_, state.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<fs::path> set_aside(const fs::path& folder) {
  if (!fs::is_directory(folder) || fs::is_empty(folder)) return std::nullopt;
  for (int n = 1;; ++n) {
    fs::path aside = folder.parent_path() / fmt::format("interrupted-{}", n);
    if (fs::exists(aside)) continue;
    fs::rename(folder, aside);
    return aside;
  }
}

std::string words(const RunningMark::Earlier& earlier) {
  std::string text =
      "the run begun at " + (earlier.begun.empty() ? "an unknown time" : earlier.begun) + " ended without a report";
  if (earlier.all > 0)
    text += fmt::format(", after {} of {} cases", earlier.done, earlier.all);
  else if (earlier.done > 0)
    text += fmt::format(", after {} cases", earlier.done);
  return text;
}

}  // namespace toolcomp::certify
