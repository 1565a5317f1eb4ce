// SPDX-License-Identifier: Apache-2.0
// Certification of a command, of an engine of ours, or of a controller written in Python.
#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certify/adapter.h"
#include "certify/certification.h"
#include "certify/input/program.h"
#include "certify/report.h"
#include "certify/running_report.h"
#include "corpus/golden.h"
#include "host/date.h"
#include "python/bindings.h"
#include "python/formal_thread.h"
#include "python/python_subject.h"
#include "spec/language/input_error.h"
#include "spec_engine/engine.h"

namespace py = pybind11;

namespace toolcomp::python {
namespace {

using certify::input::Program;

// The formal specification, in its thread.
class Specification final : public certify::Subject {
 public:
  std::variant<certify::Capabilities, certify::Fault> capabilities() override {
    return certify::formal_specification()->capabilities();
  }
  certify::Answer run(const spec::Case& c, std::optional<std::chrono::milliseconds> patience) override {
    certify::Answer answer;
    in_formal_thread([&] { answer = certify::formal_specification()->run(c, patience); });
    return answer;
  }
};

struct Asked {
  std::string command;                         // or the name of what is judged
  std::optional<PythonController> controller;  // instead of the command
  std::vector<std::string> sections;
  std::vector<std::shared_ptr<Program>> programs;
  std::string corpus;  // folder; empty: none
  std::uint32_t cases = 0;
  std::uint64_t seed = 1;
  double timeout = 10;    // seconds
  double time_limit = 0;  // seconds; 0: none
  double settle = 30;     // seconds
  std::string accept_resolution;
  unsigned jobs = 1;
  std::string report;  // folder; empty: none
  std::optional<std::function<void(std::uint64_t, std::uint64_t)>> progress;
};

// What a command line calls a controller.
void name_controller(certify::CertificationOptions& certification, const std::string& command) {
  certification.controller = command;
  if (command == "fast") {
    certification.subject = [] { return certify::built_in_engine(); };
  } else if (command == certify::kFormalSpecification) {
    if (!spec_engine::available())
      throw spec::InputError("controller", 0, 0, "this toolcomp was built without the formal specification");
    certification.subject = [] { return std::make_unique<Specification>(); };
  } else if (certify::is_adapter_name(command)) {
    const auto adapter = certify::find_adapter(command, certify::adapter_folders({}));
    if (!adapter) return;
    if (adapter->kind == certify::AdapterKind::trace)
      throw spec::InputError("controller", 0, 0,
                             command + " is a recorded controller; certify it with the command toolcomp");
    certify::expect_programs(*adapter);
    certification.controller = adapter->shell_command();
  }
}

std::vector<certify::CaseInput> inputs_of(const Asked& asked) {
  std::vector<certify::CaseInput> inputs;
  inputs.reserve(asked.programs.size());
  for (const auto& program : asked.programs) {
    inputs.push_back({program->as_case(), certify::Origin::own});
    certify::input::expect_readable(inputs.back().c, program->path());
  }
  if (!asked.corpus.empty())
    for (spec::Case& c : corpus::read_golden(asked.corpus, asked.sections))
      inputs.push_back({std::move(c), certify::Origin::golden});
  return inputs;
}

// A certification from its options to its certificate, written if a folder is named.
class Certification {
 public:
  explicit Certification(const Asked& asked) : asked_(asked) {
    name_controller(options_, asked.command);
    if (asked.controller) options_.subject = [this] { return python_subject(*asked_.controller, ending_); };
    options_.sections = asked.sections;
    options_.cases = inputs_of(asked);
    options_.generated = asked.cases;
    options_.seed = asked.seed;
    options_.timeout = std::chrono::milliseconds(std::llround(asked.timeout * 1000));
    options_.accepted_resolution = asked.accept_resolution;
    options_.jobs = asked.jobs;
    options_.settling.budget = std::chrono::milliseconds(std::llround(asked.settle * 1000));
    if (!asked.corpus.empty()) {
      const corpus::Manifest manifest = corpus::read_manifest(asked.corpus);
      options_.corpus = manifest.version;
      options_.corpus_hash = manifest.hash;
    }
    options_.stop = [this] { return why_to_stop(); };
  }

  std::shared_ptr<certify::Certificate> run() {
    std::optional<certify::RunningReport> running;
    if (!asked_.report.empty()) running.emplace(asked_.report, options_.controller);
    if (running) options_.found = [&running](const certify::Finding& finding) { running->found(finding); };
    options_.progress = [&](std::uint64_t done, std::uint64_t all) {
      if (running) running->progress(done, all);
      tell(done, all);
    };
    auto certificate = std::make_shared<certify::Certificate>(certify::certify(options_));
    certificate->occasion = {host::date_of_now(), {}, {}, {}};
    if (running) certify::write_report(*certificate, asked_.report);
    return certificate;
  }
  // Behind run(). Needs the GIL.
  void rethrow() { ending_.rethrow(); }

 private:
  std::string why_to_stop() {
    if (std::string why = ending_.why(); !why.empty()) return why;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begun_;
    if (asked_.time_limit > 0 && elapsed.count() >= asked_.time_limit) return "time limit";
    return {};
  }

  void tell(std::uint64_t done, std::uint64_t all) {
    if (!asked_.progress) return;
    const py::gil_scoped_acquire gil;
    try {
      (*asked_.progress)(done, all);
    } catch (py::error_already_set& error) {
      ending_.keep(error);
    }
  }

  const Asked& asked_;
  certify::CertificationOptions options_;
  Ending ending_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

std::shared_ptr<certify::Certificate> certify_asked(const Asked& asked) {
  Certification certification(asked);
  std::shared_ptr<certify::Certificate> certificate;
  {
    const py::gil_scoped_release released;
    certificate = certification.run();
  }
  certification.rethrow();
  return certificate;
}

std::vector<std::string> finding_texts(const certify::Certificate& certificate) {
  std::vector<std::string> texts;
  texts.reserve(certificate.findings.size());
  for (const certify::Finding& finding : certificate.findings) texts.push_back(certify::write_finding(finding));
  return texts;
}

std::vector<std::string> explanations(const certify::Certificate& certificate) {
  std::vector<std::string> texts;
  texts.reserve(certificate.findings.size());
  for (const certify::Finding& finding : certificate.findings)
    texts.push_back(certify::accusation(finding) + certify::how_it_comes(finding));
  return texts;
}

}  // namespace

void bind_certify(py::module_& module) {
  using certify::Certificate;
  using Released = py::call_guard<py::gil_scoped_release>;
  py::class_<PythonController>(module, "PythonController")
      .def(py::init([](py::function hello, py::function answer, py::object restart, bool raise_errors) {
             return PythonController{std::move(hello), std::move(answer), std::move(restart), raise_errors};
           }),
           py::arg("hello"), py::arg("answer"), py::arg("restart"), py::arg("raise_errors"));
  py::class_<Certificate, std::shared_ptr<Certificate>>(module, "Certificate")
      .def(
          "json", [](const Certificate& c) { return certify::json_report(c); }, Released())
      .def(
          "html", [](const Certificate& c) { return certify::html_report(c); }, Released())
      .def("findings", &finding_texts, Released())
      .def("explanations", &explanations, Released())
      .def(
          "write", [](const Certificate& c, const std::string& folder) { certify::write_report(c, folder); },
          py::arg("folder"), Released());
  module.def(
      "certify",
      [](const std::string& command, const std::optional<PythonController>& controller,
         const std::vector<std::string>& sections, const std::vector<std::shared_ptr<Program>>& programs,
         const std::string& corpus, std::uint32_t cases, std::uint64_t seed, double timeout, double time_limit,
         double settle, const std::string& accept_resolution, unsigned jobs, const std::string& report,
         const std::optional<std::function<void(std::uint64_t, std::uint64_t)>>& progress) {
        return certify_asked({command, controller, sections, programs, corpus, cases, seed, timeout, time_limit, settle,
                              accept_resolution, jobs, report, progress});
      },
      py::kw_only(), py::arg("command"), py::arg("controller"), py::arg("sections"), py::arg("programs"),
      py::arg("corpus"), py::arg("cases"), py::arg("seed"), py::arg("timeout"), py::arg("time_limit"),
      py::arg("settle"), py::arg("accept_resolution"), py::arg("jobs"), py::arg("report"), py::arg("progress"));
}

}  // namespace toolcomp::python
