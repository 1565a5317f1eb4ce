// SPDX-License-Identifier: Apache-2.0
// The extension as a whole.
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "certify/capabilities.h"
#include "fuzz/gen/generator.h"
#include "python/bindings.h"
#include "spec_engine/engine.h"

// NOLINTNEXTLINE(*): the macro's
PYBIND11_MODULE(_core, module) {
  using namespace toolcomp;  // NOLINT(google-build-using-namespace): what the macro opens is in none
  module.doc() = "The part of toolcomp that is written in C++. Use the package toolcomp.";
  module.attr("version") = TOOLCOMP_VERSION;
  module.attr("has_specification") = spec_engine::available();
  module.def("sections", [] {
    const auto names = fuzz::sections();
    return std::vector<std::string>(names.begin(), names.end());
  });
  module.def("fields", &certify::all_fields);
  python::bind_errors(module);
  python::bind_program(module);
  python::bind_run(module);
  python::bind_compare(module);
  python::bind_certify(module);
  python::bind_trace(module);
  python::bind_corpus(module);
  python::bind_batch(module);
}
