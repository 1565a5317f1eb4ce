// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/target.h"

#include <algorithm>
#include <vector>

namespace toolcomp::fuzz {
namespace {

std::vector<Target> all() {
  std::vector<Target> list;
  for (const std::string_view section : sections())
    for (const Mode mode : {Mode::directed, Mode::unrestricted}) {
      std::string name = twin_name(section, mode);
      std::string seeds = std::string(section.substr(0, section.find('/') + 1)) + name;
      list.push_back({std::move(name), std::string(section), mode, std::move(seeds)});
    }
  for (const char* const seeds :
       {"fanuc/read_program", "heidenhain/read_klartext", "read_case", "read_setup", "read_outside"}) {
    const std::string folder = seeds;
    const std::size_t slash = folder.find('/');
    list.push_back({slash == std::string::npos ? folder : folder.substr(slash + 1), "", Mode::unrestricted, folder});
  }
  return list;
}

}  // namespace

std::string twin_name(std::string_view section, Mode mode) {
  std::string name(section.substr(section.find('/') + 1));
  std::ranges::replace(name, '-', '_');
  return name + (mode == Mode::directed ? "_directed" : "_unrestricted");
}

std::span<const Target> targets() {
  static const std::vector<Target> list = all();
  return list;
}

const Target* find_target(std::string_view name) {
  const auto found = std::ranges::find(targets(), name, &Target::name);
  return found == targets().end() ? nullptr : &*found;
}

}  // namespace toolcomp::fuzz
