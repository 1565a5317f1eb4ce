// SPDX-License-Identifier: Apache-2.0
// The folder of the files that come with the command: golden corpus, adapters, seeds.
#pragma once

#include <filesystem>

namespace toolcomp::host {

// share/toolcomp next to the folder of the running command, if it exists. Otherwise the folder that the build names:
// the source tree, or the place where a package puts its files. It contains corpus/ and adapters/.
std::filesystem::path data_folder();

}  // namespace toolcomp::host
