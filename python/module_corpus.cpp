// SPDX-License-Identifier: Apache-2.0
// The golden corpus, a file at a time.
#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "corpus/golden.h"
#include "python/bindings.h"

namespace py = pybind11;

namespace toolcomp::python {
namespace {

// Version, and the files with their sections.
std::pair<std::string, std::vector<std::pair<std::string, std::string>>> manifest(const std::string& folder) {
  const corpus::Manifest read = corpus::read_manifest(folder);
  std::vector<std::pair<std::string, std::string>> files;
  files.reserve(read.files.size());
  for (const corpus::ManifestFile& file : read.files) files.emplace_back(file.file, file.section);
  return {read.version, std::move(files)};
}

}  // namespace

void bind_corpus(py::module_& module) {
  module.def("corpus_manifest", &manifest, py::arg("folder"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace toolcomp::python
