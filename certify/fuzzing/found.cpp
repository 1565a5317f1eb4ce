// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/found.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "spec/language/byte_source.h"

namespace toolcomp::certify::fuzzing {
namespace {

namespace fs = std::filesystem;

std::vector<Shown> shown_in(const fs::path& folder) {
  std::vector<Shown> list;
  for (const fs::path& dossier : dossiers_in(folder))
    list.push_back({dossier.filename().string(), dossier, read_story(dossier)});
  return list;
}

// What it is about: a case, or the input of a reader.
std::string case_of(const fs::path& dossier) {
  for (const char* const name : {"case.json", "input"})
    if (const fs::path file = dossier / name; fs::exists(file)) return spec::read_file(file.string());
  return {};
}

// Where it is, or can be: no other case has that name.
fs::path place_of(const Shown& shown, const fs::path& to) {
  fs::path place = to / shown.name;
  for (int n = 2; fs::exists(place) && case_of(place) != case_of(shown.folder); ++n)
    place = to / fmt::format("{}-{}", shown.name, n);
  return place;
}

// Whole or not at all; where it is then.
fs::path copied(const Shown& shown, const fs::path& to) {
  fs::path place = place_of(shown, to);
  if (fs::exists(place)) return place;
  const fs::path part = to / fmt::format(".{}.{}.part", shown.name, ::getpid());
  fs::remove_all(part);
  fs::create_directories(to);
  fs::copy(shown.folder, part, fs::copy_options::recursive);
  fs::rename(part, place);
  return place;
}

}  // namespace

Found found_in(const Folder& folder) {
  Found found{shown_in(folder.findings()), {}, shown_in(folder.open())};
  std::vector<Way> ways;
  ways.reserve(found.ways.size());
  for (const Shown& shown : found.ways) ways.push_back({shown.story.section, shown.story.shape, shown.story.core});
  found.findings = families(ways);
  return found;
}

Found copy_out(Found found, const fs::path& to) {
  for (Family& finding : found.findings) {
    const auto there = std::ranges::find_if(
        finding.others, [&](std::size_t other) { return fs::exists(place_of(found.ways[other], to)); });
    if (there != finding.others.end() && !fs::exists(place_of(found.ways[finding.first], to)))
      std::swap(finding.first, *there);
    found.ways[finding.first].folder = copied(found.ways[finding.first], to);
    for (const std::size_t other : finding.others) found.ways[other].folder.clear();
  }
  for (Shown& shown : found.open) shown.folder = copied(shown, to);
  return found;
}

std::string findings_text(std::size_t findings, std::size_t ways) {
  std::string text = fmt::format("{} finding{}", findings, findings == 1 ? "" : "s");
  if (ways > findings) text += fmt::format(" in {} ways", ways);
  return text;
}

}  // namespace toolcomp::certify::fuzzing
