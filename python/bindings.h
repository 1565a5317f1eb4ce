// SPDX-License-Identifier: Apache-2.0
// The parts of the extension toolcomp._core. What users see is Python (toolcomp/*.py): here is only what crosses over.
#pragma once

#include <pybind11/pybind11.h>

namespace toolcomp::python {

void bind_errors(pybind11::module_& module);
void bind_program(pybind11::module_& module);
void bind_run(pybind11::module_& module);
void bind_compare(pybind11::module_& module);
void bind_certify(pybind11::module_& module);
void bind_trace(pybind11::module_& module);
void bind_corpus(pybind11::module_& module);
void bind_batch(pybind11::module_& module);

}  // namespace toolcomp::python
