// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/found.h"

#include <fmt/format.h>

#include "certify/fuzzing/dossier.h"

namespace toolcomp::certify::fuzzing {

Found found_in(const std::filesystem::path& folder) {
  Found found{dossiers_in(folder), {}, {}, {}};
  std::vector<Way> ways;
  for (const std::filesystem::path& dossier : found.dossiers) {
    Story story = read_story(dossier);
    found.what.push_back(std::move(story.what));
    found.voices.push_back(std::move(story.voices));
    ways.push_back({std::move(story.section), std::move(story.shape), std::move(story.core)});
  }
  found.findings = families(ways);
  return found;
}

std::string findings_text(std::size_t findings, std::size_t ways) {
  std::string text = fmt::format("{} finding{}", findings, findings == 1 ? "" : "s");
  if (ways > findings) text += fmt::format(" in {} ways", ways);
  return text;
}

}  // namespace toolcomp::certify::fuzzing
