// SPDX-License-Identifier: Apache-2.0
// toolcomp_judge_cases FILE|FOLDER…: cases (a line each in *.jsonl; in *.json a case, or a finding with its case)
// through both engines, oracle and laws, for builds with sanitizers. Exit status 1 where engines or laws differ, or
// where nothing was judged; 2 where there is no case or one cannot be read.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "judge/oracle/trial.h"
#include "judge/oracle/verdict.h"
#include "spec/language/case_format.h"

namespace {

namespace fs = std::filesystem;
using toolcomp::spec::Case;

std::vector<fs::path> files_of(int argc, char** argv) {
  std::vector<fs::path> files;
  for (int i = 1; i < argc; ++i) {
    const fs::path path = argv[i];
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file() && entry.path().extension().string().starts_with(".json") &&
          entry.path().filename() != "manifest.json")
        files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

std::vector<Case> cases_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  std::vector<Case> cases;
  if (file.extension() == ".jsonl") {
    for (std::string line; std::getline(in, line);) cases.push_back(toolcomp::spec::read_case(line, file.string()));
  } else {
    // A finding has the case in it; a case has its version there.
    const nlohmann::json read = nlohmann::json::parse(in);
    const nlohmann::json& c = read.at("case").is_object() ? read.at("case") : read;
    cases.push_back(toolcomp::spec::read_case(c.dump(), file.string()));
  }
  return cases;
}

// Whether it is as it should be: judged, and no difference.
bool is_good(const Case& c, const toolcomp::judge::Trial& trial) {
  if (trial.found()) {
    std::fprintf(stderr, "%s: %s\n", c.id.c_str(), toolcomp::judge::explain(*trial.verdict.difference).c_str());
    return false;
  }
  if (trial.acceptance != toolcomp::judge::Acceptance::not_decided) return true;
  std::fprintf(stderr, "%s: not decided: %s\n", c.id.c_str(), trial.verdict.undecided.c_str());
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kBadInput = 2;
  std::size_t count = 0;
  std::size_t values = 0;
  std::size_t bad = 0;
  try {
    for (const fs::path& file : files_of(argc, argv))
      for (const Case& c : cases_of(file)) {
        const toolcomp::judge::Trial trial = toolcomp::judge::try_case(c);
        ++count;
        values += trial.verdict.values;
        if (!is_good(c, trial)) ++bad;
      }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return kBadInput;
  }
  std::printf("%zu cases, %zu values judged, %zu bad\n", count, values, bad);
  if (count == 0) return kBadInput;
  return bad == 0 && values > 0 ? 0 : 1;
}
