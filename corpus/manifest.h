// SPDX-License-Identifier: Apache-2.0
// The manifest of a golden corpus: the files that belong to it, and the digests that pin them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::corpus {

// A semantic version. The major number is raised if an expected result changed or a vector was removed, the minor
// number if vectors were added, the patch number if only descriptions changed.
struct Version {
  unsigned major = 1;
  unsigned minor = 0;
  unsigned patch = 0;
  friend auto operator<=>(const Version&, const Version&) = default;
};
std::string to_string(const Version& version);
// Throws std::invalid_argument for text that is not MAJOR.MINOR.PATCH.
Version parse_version(std::string_view text);

// One file of vectors, with one case in each line.
struct ManifestFile {
  std::string file;     // relative to the corpus, with '/'
  std::string section;  // "fanuc/leading-edge-offset"
  std::size_t vectors = 0;
  std::string sha256;
  friend bool operator==(const ManifestFile&, const ManifestFile&) = default;
};

struct Manifest {
  std::string version = "1.0.0";
  std::string generator;            // name and version of the generator
  std::string seed;                 // of the generated files
  std::vector<ManifestFile> files;  // by name
  std::string hash;                 // SHA-256 of the manifest's text itself; not part of it
};

// Reads FOLDER/manifest.json; throws spec::InputError, with the position of the fault, if it is not a manifest.
Manifest read_manifest(const std::filesystem::path& folder);
// The text of the manifest, with the meaning of the flags of the vectors. Equal manifests give equal text.
std::string write_manifest(const Manifest& manifest);

// A flag of vectors: its meaning, and its consequence for a comparison.
struct Flag {
  std::string_view name, description, effect;
};
inline constexpr Flag kFlags[] = {
    {"alarm", "The run ends in an alarm.", "The events before the alarm and its number are expected."},
    {"generated-unrestricted", "The program is made of any words, not of sensible blocks.",
     "Mostly tests what a control refuses."},
    {"near-tie", "A decision lies so near its boundary that a double may fall on the other side.",
     "The whole result of the other side is permitted too."},
    {"open", "The run rests on a clause the manual leaves open, or that rests on recollection.",
     "A control that differs need not be wrong: the clause lists the alternatives."},
    {"tie", "A decision falls exactly on its boundary.", "The clause says what holds there; rounding decides wrongly."},
};

}  // namespace toolcomp::corpus
