// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "certify/fuzzing/third_voice.h"
#include "certify/fuzzing/worker.h"
#include "fuzz/campaign/black_box.h"
#include "fuzz/campaign/diary.h"
#include "host/date.h"
#include "host/file_writer.h"
#include "spec/language/byte_source.h"

namespace toolcomp::certify::fuzzing {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kBetween = "--";

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.is_regular_file() && !entry.path().filename().string().ends_with(".part"))
        files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

std::vector<std::uint64_t> slices_in(const fs::path& work) {
  std::vector<std::uint64_t> numbers;
  if (fs::is_directory(work))
    for (const auto& entry : fs::directory_iterator(work))
      numbers.push_back(std::strtoull(entry.path().filename().c_str(), nullptr, 10));
  std::ranges::sort(numbers);
  return numbers;
}

std::string target_in(const fs::path& work) {
  const fs::path file = work / "target";
  std::string name = fs::exists(file) ? spec::read_file(file.string()) : std::string();
  while (!name.empty() && name.back() == '\n') name.pop_back();
  return name;
}

void count(State& state, const fs::path& work, std::optional<std::uint64_t> milliseconds) {
  const std::string target = target_in(work);
  if (target.empty()) return;
  fuzz::Counters counters = counters_in(work);
  if (milliseconds) counters.milliseconds = *milliseconds;
  TargetState& sum = target == third_voice().name ? state.specification : state.targets[target];
  ++sum.slices;
  fuzz::add(sum.sum, counters);
}

}  // namespace

fs::path Folder::work(std::uint64_t slice) const { return root_ / "work" / fmt::format("{:08}", slice); }

std::optional<State> Folder::load() const {
  const fs::path file = root_ / "state.json";
  if (!fs::exists(file)) return std::nullopt;
  State state = read_state(spec::read_file(file.string()), file.string());
  for (const std::uint64_t slice : slices_in(root_ / "work")) {
    const bool counted = slice < state.next_slice && !state.open.contains(slice);
    if (!counted) count(state, work(slice), {});
    state.next_slice = std::max(state.next_slice, slice + 1);
  }
  state.open.clear();
  return state;
}

void Folder::save(const State& state, const std::vector<Running>& running) const {
  host::write_file(root_ / "state.json", write_state(state, running));
}

void Folder::log(const std::string& line) const {
  std::ofstream(root_ / "log", std::ios::app) << host::time_of_now() << ' ' << line << '\n';
}

void Folder::take_sightings(std::uint64_t slice) const {
  const fs::path from = work(slice);
  const std::string target = target_in(from);
  if (target.empty()) return;
  const std::string prefix = fmt::format("{:08}{}{}{}", slice, kBetween, target, kBetween);
  fs::create_directories(sightings());
  for (const fs::path& file : files_in(from / fuzz::Diary::kFindings))
    fs::rename(file, sightings() / (prefix + file.filename().string()));
  for (const fs::path& file : files_in(from)) {
    const std::string name = file.filename().string();
    if (name.starts_with("crash-") || name.starts_with("timeout-") || name.starts_with("oom-"))
      fs::rename(file, sightings() / (prefix + name));
  }
  // What a full disk kept from being a file: its ending, then itself.
  if (const auto box = fuzz::BlackBox::read(from / fuzz::Diary::kBlackBox))
    for (const std::string& kept : box->kept) {
      const std::size_t end = std::min(kept.find('\n'), kept.size());
      const std::string text = kept.substr(std::min(end + 1, kept.size()));
      const fs::path file = sightings() / (prefix + kept.substr(0, end));
      if (!fs::exists(file)) host::write_file(file, text);
    }
}

void Folder::close(State& state, std::uint64_t slice, std::uint64_t milliseconds,
                   const std::vector<Running>& running) const {
  take_sightings(slice);
  count(state, work(slice), milliseconds);
  state.open.erase(slice);
  save(state, running);
  fs::remove_all(work(slice));
}

void Folder::remove_work() const {
  for (const std::uint64_t slice : slices_in(root_ / "work")) take_sightings(slice);
  fs::remove_all(root_ / "work");
}

std::vector<Folder::Sighting> Folder::waiting() const {
  std::vector<Sighting> list;
  for (const fs::path& file : files_in(sightings())) {
    const std::string name = file.filename().string();
    const std::size_t begin = name.find(kBetween);
    const std::size_t end = begin == std::string::npos ? begin : name.find(kBetween, begin + kBetween.size());
    if (end == std::string::npos) continue;
    list.push_back({file, name.substr(begin + kBetween.size(), end - begin - kBetween.size())});
  }
  return list;
}

}  // namespace toolcomp::certify::fuzzing
