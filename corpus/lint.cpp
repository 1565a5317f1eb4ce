// SPDX-License-Identifier: Apache-2.0
#include "corpus/lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "corpus/vector.h"
#include "host/sha256.h"
#include "spec/coverage/report.h"
#include "spec/language/case_format.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;

class Linter {
 public:
  explicit Linter(const fs::path& folder) : folder_(folder), manifest_(read_manifest(folder)) {}

  std::vector<std::string> run() {
    check_manifest();
    for (const Vector& vector : read_vectors(folder_)) check(vector);
    for (const ManifestFile& file : manifest_.files)
      if (counts_[file.file] != file.vectors)
        breach(file.file, fmt::format("{} vectors, the manifest says {}", counts_[file.file], file.vectors));
    return std::move(breaches_);
  }

 private:
  void breach(const std::string& where, std::string_view what) {
    breaches_.push_back(fmt::format("{}: {}", where, what));
  }

  void check_manifest() {
    if (!std::ranges::is_sorted(manifest_.files, std::ranges::less_equal(), &ManifestFile::file))
      breach("manifest.json", "files must be listed by name, each once");
    std::set<std::string> listed{"manifest.json"};
    for (const ManifestFile& file : manifest_.files) {
      listed.insert(file.file);
      if (host::sha256_file((folder_ / file.file).string()) != file.sha256)
        breach(file.file, "the SHA-256 is not the one in the manifest");
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      if (entry.is_regular_file()) found.push_back(entry.path().lexically_relative(folder_).generic_string());
    std::ranges::sort(found);
    for (const std::string& file : found)
      if (!listed.contains(file)) breach(file, "does not belong to the corpus");
  }

  void check(const Vector& vector) {
    const spec::Case& c = vector.c;
    ++counts_[vector.file];
    const auto require = [&](bool holds, std::string_view what) {
      if (!holds) breach(fmt::format("{}:{}", vector.file, vector.line), what);
    };
    require(spec::write_case_line(c) == vector.text, "the line is not in the form that toolcomp writes");
    require(c.id == vector_id(c), "the id does not belong to this vector");
    require(ids_.insert(c.id).second, "the same vector occurs twice");
    require(vector.file.starts_with(c.section + '/'), "the vector is not in the folder of its section");
    require(c.has_expect && !c.expect.empty(), "the expected events are missing");
    require(!c.source.generator.empty(), "the source is missing");
    require(!c.comment.empty() || !c.source.seed.empty(), "a vector written by hand needs a comment");
    for (const std::string& flag : c.flags)
      require(std::ranges::any_of(kFlags, [&](const Flag& known) { return known.name == flag; }),
              "unknown flag " + flag);
    require(std::ranges::is_sorted(c.flags, std::ranges::less_equal()), "flags must be sorted, each once");
  }

  fs::path folder_;
  Manifest manifest_;
  std::vector<std::string> breaches_;
  std::set<std::string> ids_;
  std::map<std::string, std::size_t> counts_;
};

}  // namespace

std::vector<std::string> lint(const std::filesystem::path& folder) { return Linter(folder).run(); }

}  // namespace toolcomp::corpus
