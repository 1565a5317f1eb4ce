// SPDX-License-Identifier: Apache-2.0
// The folder of one finding, with everything that is needed to check and repeat it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "certify/finding.h"

namespace toolcomp::certify::fuzzing {

// The stage of a finding.
enum class Stage : std::uint8_t {
  seen,        // as its worker saw it; examining it failed
  gone,        // examined, and not reproduced
  reproduced,  // reproduced, not completely shrunk
  shrunk,      // nothing simpler fails in the same way
};
std::string_view name(Stage stage);

struct Dossier {
  Finding finding;
  Stage stage = Stage::seen;
  std::string shape;  // of the shrunk case (shape.h); empty if it is not shrunk
  // The shape of the simplest program that is left if the shrunk program may be shrunk further, and may then fail in
  // any way. Different ways in which one bug shows have the same core. Empty if it is not known.
  std::string core;
  std::string why;  // why it is not shrunk

  // Two cases of one bug have the same name, and two bugs have different names. The name has kind, clause or section,
  // and a digest of these with the shape and the controller.
  [[nodiscard]] std::string name() const;
};

// Writes the folder: finding.json, case.json, expected.jsonl, actual.jsonl, picture.svg, finding.txt. An existing
// folder stays if its case is not larger. The folder is complete or not written at all, whatever ends the process.
// Returns whether there was no such folder. Throws std::runtime_error if it cannot be written.
bool write_dossier(const Dossier& dossier, const std::filesystem::path& folder);

// The dossiers of a folder, by name.
std::vector<std::filesystem::path> dossiers_in(const std::filesystem::path& folder);
// The content of finding.txt of a dossier: its first line, section, shape and core, which voice stands alone
// (certify/voices.h), and the program. A finding of a reader has only the first line. A finding that is not shrunk has
// no shape and no core.
struct Story {
  std::string what, section, shape, core, voices, program;
};
Story read_story(const std::filesystem::path& dossier);

// Whether `a` is smaller: fewer blocks, then fewer bytes, then the smaller bytes; for the same case, the one that was
// found earlier.
bool is_smaller(const Finding& a, const Finding& b);

}  // namespace toolcomp::certify::fuzzing
