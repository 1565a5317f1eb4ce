// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/regression.h"

#include <algorithm>

#include "certify/finding.h"
#include "fuzz/campaign/diary.h"
#include "fuzz/campaign/target.h"
#include "fuzz/gen/encode.h"
#include "host/file_writer.h"
#include "spec/language/byte_source.h"

namespace toolcomp::certify::fuzzing {

namespace fs = std::filesystem;

std::vector<spec::Case> regression_cases(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<spec::Case> cases;
  cases.reserve(files.size());
  for (const fs::path& file : files)
    cases.push_back(read_finding(spec::read_file(file.string()), file.string()).smallest);
  return cases;
}

void write_regression_inputs(const fs::path& folder, const fs::path& inputs) {
  fs::remove_all(inputs);
  for (const spec::Case& c : regression_cases(folder))
    for (const fuzz::Target& target : fuzz::targets())
      if (target.section == c.section) {
        const std::string bytes = fuzz::encode(c);
        host::write_file(inputs / target.seeds / fuzz::digest(bytes), bytes);
      }
}

}  // namespace toolcomp::certify::fuzzing
