// SPDX-License-Identifier: Apache-2.0
// kit.json: the content of a kit, for `kit judge`.
#pragma once

#include <filesystem>
#include <string>

#include "certify/kit/kit.h"

namespace toolcomp::certify::kit {

// The same kit gives the same text. Files are listed with their SHA-256.
std::string write_kit(const Kit& kit);

// Reads the text of a kit.json, which has the name `file` in messages. The files that it names are not checked. Throws
// spec::InputError, with the position of the fault.
Kit read_kit_json(std::string_view text, const std::string& file);

// Reads FOLDER/kit.json and compares every file of the kit with its digest, except the alarm form, which is filled in.
// Throws spec::InputError, with the position of the fault, for anything other than a complete kit.
Kit read_kit(const std::filesystem::path& folder);

}  // namespace toolcomp::certify::kit
