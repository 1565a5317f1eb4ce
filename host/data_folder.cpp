// SPDX-License-Identifier: Apache-2.0
#include "host/data_folder.h"

#include <system_error>

namespace toolcomp::host {

std::filesystem::path data_folder() {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path beside = fs::read_symlink("/proc/self/exe", none).parent_path().parent_path() / "share" / "toolcomp";
  return fs::is_directory(beside, none) ? beside : fs::path(TOOLCOMP_DATA);
}

}  // namespace toolcomp::host
