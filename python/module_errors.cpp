// SPDX-License-Identifier: Apache-2.0
// What C++ throws, as exceptions of toolcomp/errors.py.
#include <exception>
#include <string>

#include "model/exact/real.h"
#include "python/bindings.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace py = pybind11;

namespace toolcomp::python {
namespace {

py::object none_or(std::uint64_t number) { return number == 0 ? py::object(py::none()) : py::object(py::int_(number)); }

// NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 calls it so
void translate(std::exception_ptr thrown) {
  const auto raise = [](const char* name, const py::tuple& arguments) {
    const py::object type = py::module_::import("toolcomp.errors").attr(name);
    PyErr_SetObject(type.ptr(), arguments.ptr());
  };
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const spec::InputError& error) {
    raise("InputError", py::make_tuple(error.message(), spec::display_name(error.file()), none_or(error.line()),
                                       none_or(error.column())));
  } catch (const exact::Undecided& error) {
    raise("UndecidedError", py::make_tuple(error.what()));
  }
}

}  // namespace

void bind_errors(py::module_& /*module*/) { py::register_exception_translator(&translate); }

}  // namespace toolcomp::python
