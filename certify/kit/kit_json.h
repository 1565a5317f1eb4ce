// SPDX-License-Identifier: Apache-2.0
// kit.json: what a kit holds, for `kit judge`.
#pragma once

#include <filesystem>
#include <string>

#include "certify/kit/kit.h"

namespace toolcomp::certify::kit {

// Stable: the same kit gives the same text. Files are named with their SHA-256.
std::string write_kit(const Kit& kit);

// The text of a kit.json, named `file` in messages; the files it names are not looked at. Throws spec::InputError, with
// the position of the fault.
Kit read_kit_json(std::string_view text, const std::string& file);

// Reads FOLDER/kit.json and checks every file of the kit but the alarm form, which is filled in, against its digest.
// Throws spec::InputError, with the position of the fault, for anything else than a whole kit.
Kit read_kit(const std::filesystem::path& folder);

}  // namespace toolcomp::certify::kit
