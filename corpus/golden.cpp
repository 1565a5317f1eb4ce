// SPDX-License-Identifier: Apache-2.0
#include "corpus/golden.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "host/data_folder.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"

namespace toolcomp::corpus {
namespace {

// Appends the vectors of one file. `name` stands in messages and in the vectors.
void read_into(std::vector<Vector>& vectors, const std::filesystem::path& file, const std::string& name) {
  const std::string bytes = spec::read_file(file);
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    ++number;
    if (end > begin) {
      Vector vector{name, number, bytes.substr(begin, end - begin), {}};
      try {
        vector.c = spec::read_case(vector.text, name);
      } catch (const spec::InputError& error) {
        throw spec::InputError(file.string(), number, error.column(), error.message());
      }
      vectors.push_back(std::move(vector));
    }
    begin = end + 1;
  }
}

}  // namespace

std::filesystem::path default_folder() { return host::data_folder() / "corpus" / "golden"; }

bool Selection::wants(const std::string& section) const {
  return sections.empty() || std::ranges::find(sections, section) != sections.end();
}

std::vector<Vector> read_vectors(const std::filesystem::path& folder, const Selection& selection) {
  const Manifest manifest = read_manifest(folder);
  for (const std::string& section : selection.sections)
    if (std::ranges::none_of(manifest.files, [&](const ManifestFile& file) { return file.section == section; }))
      throw spec::InputError(folder.string(), 0, 0, "no vectors of section " + section);
  std::vector<Vector> all;
  for (const ManifestFile& file : manifest.files)
    if (selection.wants(file.section)) read_into(all, folder / file.file, file.file);
  if (selection.share.count == 1) return all;
  std::vector<Vector> selected;
  for (std::size_t i = selection.share.index - 1; i < all.size(); i += selection.share.count)
    selected.push_back(std::move(all[i]));
  return selected;
}

std::vector<spec::Case> read_cases(const std::filesystem::path& file) {
  std::vector<Vector> vectors;
  read_into(vectors, file, file.filename().string());
  std::vector<spec::Case> cases;
  cases.reserve(vectors.size());
  for (Vector& vector : vectors) cases.push_back(std::move(vector.c));
  return cases;
}

std::vector<spec::Case> read_golden(const std::filesystem::path& folder, const std::vector<std::string>& sections) {
  const Selection wanted{.sections = sections, .share = {}};
  std::vector<spec::Case> cases;
  for (const ManifestFile& file : read_manifest(folder).files)
    if (wanted.wants(file.section)) std::ranges::move(read_cases(folder / file.file), std::back_inserter(cases));
  return cases;
}

}  // namespace toolcomp::corpus
