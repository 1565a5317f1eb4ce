// SPDX-License-Identifier: Apache-2.0
// The folder of one finding: everything somebody needs to believe it, and to repeat it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "certify/finding.h"

namespace toolcomp::certify::fuzzing {

// How far a finding has come.
enum class Stage : std::uint8_t {
  seen,        // as its worker met it; looking again failed
  gone,        // looked at again, and not met
  reproduced,  // met again, not shrunk to the end
  shrunk,      // nothing simpler fails in the same way
};
std::string_view name(Stage stage);

struct Dossier {
  Finding finding;
  Stage stage = Stage::seen;
  std::string shape;  // of the shrunk case (shape.h); of what is not shrunk: none
  // Of the simplest program that is left when the shrunk one may go on to fail in any way: where several ways a bug
  // shows come from. None where it is not known.
  std::string core;
  std::string why;  // why it is not shrunk

  // Two cases of one bug have one name, two bugs have two: kind, clause or section, and a digest of these with the
  // shape and the controller.
  [[nodiscard]] std::string name() const;
};

// Everything but the program's name for the folder: finding.json, case.json, expected.jsonl, actual.jsonl, picture.svg,
// finding.txt. A folder with the same name stays if its case is as small or smaller. Whole or not at all, whatever ends
// the process. Whether there was none. Throws std::runtime_error where it cannot be written.
bool write_dossier(const Dossier& dossier, const std::filesystem::path& folder);

// The dossiers of a folder, by name.
std::vector<std::filesystem::path> dossiers_in(const std::filesystem::path& folder);
// What finding.txt of a dossier says first, of what, who stands alone there (certify/voices.h), and its program; of a
// reader's finding all but the first is empty, and shape and core of what is not shrunk.
struct Story {
  std::string what, section, shape, core, voices, program;
};
Story read_story(const std::filesystem::path& dossier);

// Whether it is smaller: fewer blocks, fewer bytes, the lesser bytes; of one case that which was found earlier.
bool is_smaller(const Finding& a, const Finding& b);

}  // namespace toolcomp::certify::fuzzing
