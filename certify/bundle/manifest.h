// SPDX-License-Identifier: Apache-2.0
// manifest.json of a bundle: its files, and the command that asked for the certificate.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::certify::bundle {

// The version of the format. A reader accepts only its own version.
inline constexpr int kFormat = 1;

// Names in a bundle.
inline constexpr std::string_view kManifest = "manifest.json";
inline constexpr std::string_view kCases = "cases.jsonl";
inline constexpr std::string_view kAnswers = "answers.jsonl";
inline constexpr std::string_view kResults = "results.jsonl";
inline constexpr std::string_view kHello = "hello.json";
inline constexpr std::string_view kCertificate = "certificate.json";
inline constexpr std::string_view kCorpus = "corpus/manifest.json";
inline constexpr std::string_view kSbom = "sbom.spdx.json";

struct ManifestFile {
  std::string file;  // its name in the bundle
  std::uint64_t size = 0;
  std::string sha256;
};

// A program, case or setup that the user gave.
struct ManifestInput {
  std::string given;  // its name on the command line
  std::string file;   // its name in the bundle
};

struct Manifest {
  std::string tool;                   // name and version
  std::string made;                   // UTC
  std::vector<std::string> command;   // the words of the command line
  std::string directory;              // folder in which the command was run
  std::vector<std::string> sections;  // asked for; empty: all
  std::string adapter;                // its name; empty: the controller is a command
  std::string interrupted;            // why not everything was run; otherwise empty
  std::uint64_t cases = 0;            // lines of cases.jsonl
  std::vector<ManifestInput> inputs;
  std::vector<ManifestFile> files;  // all except the manifest itself, by name
};

std::string write_manifest(const Manifest& manifest);
// Throws spec::InputError for text that is not a manifest of this format (`toolcomp config schema manifest`).
Manifest read_manifest(std::string_view text);

}  // namespace toolcomp::certify::bundle
