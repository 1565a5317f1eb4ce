// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "certify/finding.h"
#include "certify/fuzzing/dossier.h"
#include "certify/fuzzing/folder.h"
#include "fuzz/campaign/diary.h"
#include "host/file_writer.h"
#include "host/process.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::fuzzing {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> list;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (!entry.path().filename().string().starts_with('.')) list.push_back(entry.path());
  std::ranges::sort(list);
  return list;
}

// Names of one corpus stand for their bytes; another file with that name gets one of its own.
void take_file(const fs::path& from, const fs::path& to) {
  const std::string bytes = spec::read_file(from.string());
  fs::path file = to / from.filename();
  if (fs::exists(file) && spec::read_file(file.string()) != bytes) file = to / fuzz::digest(bytes);
  host::write_file(file, bytes);
}

// By name alone what is the same input: two campaigns name it alike.
void take_corpus(const fs::path& from, const fs::path& to) {
  for (const fs::path& target : entries(from))
    for (const fs::path& file : entries(target)) {
      const std::string bytes = spec::read_file(file.string());
      host::write_file(to / target.filename() / fuzz::digest(bytes), bytes);
    }
}

// The whole of a dossier as one text, to choose between two of them in any order.
std::string text_of(const fs::path& dossier) {
  std::string text;
  for (const fs::path& file : entries(dossier)) text += spec::read_file(file.string());
  return text;
}

bool is_better(const fs::path& a, const fs::path& b) {
  const auto finding = [](const fs::path& folder) {
    const fs::path file = folder / "finding.json";
    return read_finding(spec::read_file(file.string()), file.string());
  };
  if (!fs::exists(a / "finding.json") || !fs::exists(b / "finding.json")) return text_of(a) < text_of(b);
  const Finding first = finding(a);
  const Finding second = finding(b);
  if (is_smaller(first, second) || is_smaller(second, first)) return is_smaller(first, second);
  return text_of(a) < text_of(b);
}

void take_dossiers(const fs::path& from, const fs::path& to) {
  for (const fs::path& dossier : entries(from)) {
    if (!fs::exists(dossier / "finding.txt")) continue;
    const fs::path place = to / dossier.filename();
    if (fs::exists(place) && !is_better(dossier, place)) continue;
    fs::remove_all(place);
    fs::create_directories(place);
    for (const fs::path& file : entries(dossier)) take_file(file, place);
  }
}

// A slice's number says which of a campaign's it was: of several, its bytes tell it apart.
void take_sightings(const Folder& from, const Folder& to) {
  for (const Folder::Sighting& sighting : from.waiting()) {
    const std::string name = sighting.file.filename().string();
    const std::string bytes = spec::read_file(sighting.file.string());
    const std::size_t last = name.rfind("--");
    host::write_file(to.sightings() / fmt::format("00000000--{}--{}{}", sighting.target, fuzz::digest(bytes),
                                                  name.substr(std::min(name.find('.', last), name.size()))),
                     bytes);
  }
}

void expect_at_rest(const fs::path& folder) {
  if (!fs::exists(folder / "state.json"))
    throw spec::InputError(folder.string(), 0, 0, "is not the folder of a campaign");
  if (!entries(folder / "work").empty())
    throw spec::InputError(folder.string(), 0, 0,
                           "its campaign was killed or is still running; `toolcomp fuzz --campaign` resumes it");
}

}  // namespace

void merge_campaigns(const std::vector<fs::path>& folders, const fs::path& merged) {
  if (fs::exists(merged) && (!fs::is_directory(merged) || !fs::is_empty(merged)))
    throw spec::InputError(merged.string(), 0, 0, "exists already; name a new folder for the merged campaign");
  for (const fs::path& folder : folders) expect_at_rest(folder);
  const Folder to(merged);
  State sum;
  for (const fs::path& folder : folders) {
    const Folder from(folder);
    merge(sum, *from.load());
    take_corpus(folder / "corpus", merged / "corpus");
    take_dossiers(from.findings(), to.findings());
    take_dossiers(from.open(), to.open());
    take_sightings(from, to);
  }
  to.save(sum, {});
}

}  // namespace toolcomp::certify::fuzzing
