// SPDX-License-Identifier: Apache-2.0
// Setups and programs: from files, text and cases.
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "certify/input/program.h"
#include "python/bindings.h"
#include "spec/language/case_format.h"
#include "spec/language/setup_format.h"

namespace py = pybind11;

namespace toolcomp::python {
namespace {

using certify::input::Program;
using Released = py::call_guard<py::gil_scoped_release>;

std::shared_ptr<Program> program_of_text(const std::string& text, const std::string& name, const spec::Setup& setup,
                                         std::uint32_t samples) {
  spec::Case c;
  c.id = name;
  c.setup = setup;
  c.dialect = spec::dialect_of(setup.control);
  c.program = text;
  c.samples = samples;
  return std::make_shared<Program>(name, std::move(c));
}

std::shared_ptr<Program> program_of_case(const std::string& json, const std::string& name,
                                         std::optional<std::uint32_t> samples) {
  spec::Case c = spec::read_case(json, name);
  if (samples) c.samples = *samples;
  return std::make_shared<Program>(name, std::move(c));
}

std::shared_ptr<Program> program_of_file(const std::string& path, const std::string& setup,
                                         std::optional<std::uint32_t> samples) {
  return std::make_shared<Program>(path, setup, samples);
}

// The same program with another setup.
std::shared_ptr<Program> program_with_setup(const std::string& path, const spec::Setup& setup, std::uint32_t samples) {
  return std::make_shared<Program>(path, setup, samples);
}

}  // namespace

void bind_program(py::module_& module) {
  py::class_<spec::Setup>(module, "Setup")
      .def("json", [](const spec::Setup& setup) { return spec::write_setup_json(setup); })
      .def("toml", [](const spec::Setup& setup) { return spec::write_setup_toml(setup); })
      .def_property_readonly("axes", [](const spec::Setup& setup) { return setup.axes.letters(); });
  module.def("setup_of_text", &certify::input::read_setup_text, py::arg("text"), py::arg("name"), py::arg("json"),
             Released());
  module.def("setup_of_file", &certify::input::read_setup, py::arg("path"), Released());

  py::class_<Program, std::shared_ptr<Program>>(module, "Program")
      .def("setup", [](const Program& program) { return program.setup(); })
      .def(
          "case", [](const Program& program) { return spec::write_case_line(program.as_case()); }, Released())
      .def("place", [](const Program& program, std::uint64_t line) {
        const certify::input::Place place = program.place(line);
        return std::pair(place.file, place.line);
      });
  module.def("program_of_file", &program_of_file, py::arg("path"), py::arg("setup"), py::arg("samples"), Released());
  module.def("program_with_setup", &program_with_setup, py::arg("path"), py::arg("setup"), py::arg("samples"),
             Released());
  module.def("program_of_text", &program_of_text, py::arg("text"), py::arg("name"), py::arg("setup"),
             py::arg("samples"), Released());
  module.def("program_of_case", &program_of_case, py::arg("json"), py::arg("name"), py::arg("samples"), Released());
}

}  // namespace toolcomp::python
