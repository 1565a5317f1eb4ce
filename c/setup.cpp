// SPDX-License-Identifier: Apache-2.0
#include "c/setup.h"

#include <memory>
#include <string>
#include <string_view>

#include "c/call.h"
#include "spec/language/byte_source.h"
#include "spec/language/setup_format.h"

namespace {

using toolcomp::c::guarded;
using toolcomp::c::need;

toolcomp_setup* read(std::string_view text, const std::string& file) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string_view::npos && text[first] == '{';
  return std::make_unique<toolcomp_setup>(toolcomp_setup{json ? toolcomp::spec::read_setup_json(text, file)
                                                              : toolcomp::spec::read_setup_toml(text, file)})
      .release();
}

}  // namespace

const char* toolcomp_version() { return TOOLCOMP_VERSION; }

toolcomp_status toolcomp_setup_from_text(const char* text, size_t length, toolcomp_setup** setup,
                                         toolcomp_error* error) {
  return guarded(error, [&] {
    need(setup, "setup") = nullptr;
    need(text, "text");
    *setup = read({text, length}, "setup");
  });
}

toolcomp_status toolcomp_setup_from_file(const char* path, toolcomp_setup** setup, toolcomp_error* error) {
  return guarded(error, [&] {
    need(setup, "setup") = nullptr;
    need(path, "path");
    *setup = read(toolcomp::spec::read_file(path), path);
  });
}

const char* toolcomp_setup_axes(const toolcomp_setup* setup) { return setup->value.axes.letters().c_str(); }

void toolcomp_setup_free(toolcomp_setup* setup) { delete setup; }
