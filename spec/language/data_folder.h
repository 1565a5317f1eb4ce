// SPDX-License-Identifier: Apache-2.0
// Where the files lie that come with the command: golden corpus, adapters, seeds.
#pragma once

#include <filesystem>

namespace toolcomp::spec {

// share/toolcomp beside the folder of the running command, where there is one; else the folder that the build names:
// the source tree, or where a package puts its files. It holds corpus/ and adapters/.
std::filesystem::path data_folder();

}  // namespace toolcomp::spec
