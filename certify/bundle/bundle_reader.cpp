// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/bundle_reader.h"

#include <algorithm>
#include <set>
#include <utility>

#include "certify/bundle/archive_reader.h"
#include "certify/bundle/plain_name.h"
#include "certify/bundle/refused.h"
#include "certify/bundle/seal.h"
#include "host/sha256.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::bundle {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostInMemory = std::uint64_t{512} << 20;  // in all
constexpr std::uint64_t kMostInAll = std::uint64_t{16} << 30;
constexpr std::size_t kMostFiles = 100'000;

std::string read_text(ArchiveReader& archive, const ArchiveReader::Member& member) {
  if (member.size > kMostInMemory) throw Refused(member.name + ": is too large");
  std::string text;
  archive.read([&text](std::string_view piece) { text += piece; });
  return text;
}

// The manifest, which is the first member.
std::string read_first(ArchiveReader& archive) {
  const auto member = archive.next();
  if (!member || member->name != kManifest) throw Refused("does not begin with manifest.json");
  return read_text(archive, *member);
}

// Whether a file whose seal is broken was a bundle once.
bool begins_as_bundle(const fs::path& file) {
  try {
    ArchiveReader archive(file);
    static_cast<void>(read_manifest(read_first(archive)));
    return true;
  } catch (const std::runtime_error&) {  // Refused, or spec::InputError
    return false;
  }
}

Spool* spool_of(Bundle& bundle, const std::string& name) {
  if (name == kCases) return &bundle.cases;
  if (name == kAnswers) return &bundle.answers;
  return name == kResults ? &bundle.results : nullptr;
}

// Of these the digest alone is wanted.
bool is_passed_over(const std::string& name) { return name == "index.html" || name.starts_with("inputs/"); }

void expect_sizes(const Manifest& manifest) {
  if (manifest.files.size() > kMostFiles) throw Refused("manifest.json: names too many files");
  std::uint64_t all = 0;
  std::uint64_t memory = 0;
  std::set<std::string> names{std::string(kManifest)};
  for (const ManifestFile& file : manifest.files) {
    if (!is_plain_name(file.file)) throw Refused("manifest.json: has a file name that is not allowed in a bundle");
    if (!names.insert(file.file).second) throw Refused("manifest.json: names " + file.file + " twice");
    if (file.size > kMostInAll - all)
      throw Refused("manifest.json: the files are larger in total than toolcomp can read");
    all += file.size;
    const bool in_memory =
        file.file != kCases && file.file != kAnswers && file.file != kResults && !is_passed_over(file.file);
    if (in_memory) memory += file.size;
    if (memory > kMostInMemory)
      throw Refused("manifest.json: the files are larger in total than toolcomp can hold in memory");
  }
  for (const std::string_view needed : {kCases, kAnswers, kResults, kCertificate, kSbom})
    if (!names.contains(std::string(needed))) throw Refused("manifest.json: does not name " + std::string(needed));
  for (const ManifestInput& input : manifest.inputs)
    if (!names.contains(input.file)) throw Refused("manifest.json: an input is not among its files: " + input.file);
}

// A member with the digest it comes out with.
std::string digest_of(Bundle& bundle, ArchiveReader& archive, const ArchiveReader::Member& member) {
  if (Spool* const spool = spool_of(bundle, member.name)) {
    archive.read([spool](std::string_view piece) { spool->append(piece); });
    return spool->finish();
  }
  if (is_passed_over(member.name)) {
    host::Sha256 digest;
    archive.read([&digest](std::string_view piece) { digest.update(piece); });
    return digest.hex();
  }
  std::string text = read_text(archive, member);
  std::string digest = host::sha256(text);
  bundle.files.emplace(member.name, std::move(text));
  return digest;
}

}  // namespace

Bundle read_bundle(const fs::path& file) {
  if (fs::is_directory(file)) throw spec::InputError(file.string(), 0, 0, "is a folder");
  if (!is_sealed(file)) {
    if (begins_as_bundle(file))
      throw Refused("the file was changed or truncated: the digest at its end is not that of the bytes before it");
    throw spec::InputError(file.string(), 0, 0, "is not an evidence bundle");
  }
  Bundle bundle(fs::temp_directory_path());
  ArchiveReader archive(file);
  bundle.manifest = read_manifest(read_first(archive));
  expect_sizes(bundle.manifest);
  std::set<std::string> seen;
  while (const auto member = archive.next()) {
    const auto named = std::ranges::find(bundle.manifest.files, member->name, &ManifestFile::file);
    if (named == bundle.manifest.files.end()) throw Refused(member->name + ": is not in the manifest");
    if (!seen.insert(member->name).second) throw Refused(member->name + ": is in the bundle twice");
    if (member->size != named->size)
      throw Refused(member->name + ": has " + std::to_string(member->size) + " bytes and should have " +
                    std::to_string(named->size));
    if (digest_of(bundle, archive, *member) != named->sha256)
      throw Refused(member->name + ": its SHA-256 is not the one in the manifest");
  }
  for (const ManifestFile& named : bundle.manifest.files)
    if (!seen.contains(named.file)) throw Refused(named.file + ": is missing");
  return bundle;
}

}  // namespace toolcomp::certify::bundle
