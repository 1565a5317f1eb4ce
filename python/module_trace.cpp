// SPDX-License-Identifier: Apache-2.0
// Recorded runs, from arrays in memory or from a CSV.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certify/input/program.h"
#include "certify/report.h"
#include "certify/trace/recording.h"
#include "certify/trace/trace.h"
#include "host/date.h"
#include "judge/oracle/program_facts.h"
#include "python/bindings.h"
#include "python/interrupt.h"
#include "spec/language/input_error.h"

namespace py = pybind11;

namespace toolcomp::python {
namespace {

using certify::TraceReport;
using certify::input::Program;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

struct Column {
  std::size_t axis = 0;
  std::span<const double> values;
};

// Samples side by side in arrays, numbered from 1. What was computed in doubles has no last digit: how far times may be
// off is `resolution`.
class ArraySource final : public certify::SampleSource {
 public:
  ArraySource(std::vector<Column> columns, std::optional<std::span<const double>> time, double resolution)
      : columns_(std::move(columns)), time_(time), resolution_(resolution) {
    recorded_.reserve(columns_.size());
    for (const Column& column : columns_) recorded_.push_back(column.axis);
    size_ = columns_.empty() ? 0 : columns_.front().values.size();
  }

  bool next(certify::RecordedSample& sample) override {
    interrupt_.check();
    if (next_ == size_) return false;
    for (const Column& column : columns_) sample.at[column.axis] = column.values[next_];
    if (time_) sample.time = (*time_)[next_];
    sample.resolution = resolution_;
    sample.line = ++next_;
    return true;
  }
  [[nodiscard]] const std::vector<std::size_t>& recorded() const override { return recorded_; }
  [[nodiscard]] bool has_time() const override { return time_.has_value(); }

 private:
  std::vector<Column> columns_;
  std::optional<std::span<const double>> time_;
  double resolution_;
  std::vector<std::size_t> recorded_;
  std::size_t size_ = 0;
  std::size_t next_ = 0;
  Interrupt interrupt_;
};

// The same source, with a look for Ctrl-C.
class Interruptible final : public certify::SampleSource {
 public:
  explicit Interruptible(SampleSource& source) : source_(source) {}
  bool next(certify::RecordedSample& sample) override {
    interrupt_.check();
    return source_.next(sample);
  }
  [[nodiscard]] const std::vector<std::size_t>& recorded() const override { return source_.recorded(); }
  [[nodiscard]] bool has_time() const override { return source_.has_time(); }

 private:
  SampleSource& source_;
  Interrupt interrupt_;
};

std::span<const double> judged(const std::string& name, const Array& array, std::size_t size) {
  if (array.ndim() != 1) throw std::invalid_argument(name + ": not one-dimensional");
  const std::span values(array.data(), static_cast<std::size_t>(array.size()));
  if (values.size() != size)
    throw std::invalid_argument(name + ": " + std::to_string(values.size()) + " samples, and other arrays have " +
                                std::to_string(size));
  for (std::size_t i = 0; i < size; ++i)
    if (!std::isfinite(values[i]))
      throw std::invalid_argument(name + ": sample " + std::to_string(i) + " is not a number");
  return values;
}

using Columns = std::vector<std::pair<std::string, Array>>;

ArraySource source_of(const Columns& given, const std::optional<Array>& time, double resolution,
                      const spec::Axes& axes) {
  if (given.empty()) throw std::invalid_argument("a recording needs at least one axis");
  const auto size = static_cast<std::size_t>(given.front().second.size());
  std::vector<Column> columns;
  columns.reserve(given.size());
  for (const auto& [name, array] : given) {
    const std::size_t axis = name.size() == 1 ? axes.index(name.front()) : spec::Axes::kNone;
    if (axis == spec::Axes::kNone)
      throw std::invalid_argument(name + ": not an axis of the setup, which has " + axes.letters());
    columns.push_back({axis, judged(name, array, size)});
  }
  std::optional<std::span<const double>> times;
  if (time) {
    times = judged("time", *time, size);
    for (std::size_t i = 1; i < size; ++i)
      if ((*times)[i] < (*times)[i - 1])
        throw std::invalid_argument("time: runs backwards at sample " + std::to_string(i));
  }
  return {std::move(columns), times, resolution};
}

certify::TraceOptions options_of(double tolerance, std::optional<double> rotary_tolerance, bool machine,
                                 bool judge_rapids) {
  const auto expect_positive = [](const char* name, double value) {
    if (!(value > 0) || !std::isfinite(value)) throw std::invalid_argument(std::string(name) + " must be positive");
  };
  expect_positive("tolerance", tolerance);
  if (rotary_tolerance) expect_positive("rotary_tolerance", *rotary_tolerance);
  certify::TraceOptions options;
  options.tolerance = tolerance;
  options.rotary_tolerance = rotary_tolerance;
  options.judge_rapids = judge_rapids;
  if (machine) options.frame = certify::PathFrame::machine;
  return options;
}

std::shared_ptr<TraceReport> report_of(const Program& program, std::string file, certify::TraceOptions options) {
  auto report = std::make_shared<TraceReport>();
  report->c = program.as_case();
  certify::input::expect_readable(report->c, program.path());
  report->file = std::move(file);
  report->options = options;
  report->occasion.date = host::date_of_now();
  return report;
}

std::shared_ptr<TraceReport> judge_arrays(const std::shared_ptr<Program>& program, const Columns& columns,
                                          const std::optional<Array>& time, double resolution, double tolerance,
                                          std::optional<double> rotary_tolerance, bool machine, bool judge_rapids) {
  const certify::TraceOptions options = options_of(tolerance, rotary_tolerance, machine, judge_rapids);
  ArraySource source = source_of(columns, time, resolution, program->setup().axes);
  const py::gil_scoped_release released;
  auto report = report_of(*program, "samples", options);
  report->result = certify::judge_trace(report->c, source, options);
  return report;
}

std::shared_ptr<TraceReport> judge_file(const std::shared_ptr<Program>& program, const std::string& path,
                                        double tolerance, std::optional<double> rotary_tolerance, bool machine,
                                        bool judge_rapids) {
  const certify::TraceOptions options = options_of(tolerance, rotary_tolerance, machine, judge_rapids);
  const py::gil_scoped_release released;
  auto report = report_of(*program, path, options);
  std::ifstream csv(path);
  if (!csv) throw spec::InputError(path, 0, 0, "cannot be read");
  const spec::Units units = judge::ProgramFacts::of(report->c).units().value_or(report->c.setup.units);
  certify::Recording recording(csv, path, report->c.setup.axes, units);
  Interruptible source(recording);
  report->result = certify::judge_trace(report->c, source, options);
  return report;
}

}  // namespace

void bind_trace(py::module_& module) {
  using Released = py::call_guard<py::gil_scoped_release>;
  py::class_<TraceReport, std::shared_ptr<TraceReport>>(module, "TraceReport")
      .def(
          "json", [](const TraceReport& report) { return certify::json_report(report); }, Released())
      .def(
          "html", [](const TraceReport& report) { return certify::html_report(report); }, Released())
      .def(
          "write", [](const TraceReport& report, const std::string& folder) { certify::write_report(report, folder); },
          py::arg("folder"), Released());
  module.def("judge_arrays", &judge_arrays, py::arg("program"), py::arg("columns"), py::arg("time"),
             py::arg("resolution"), py::arg("tolerance"), py::arg("rotary_tolerance"), py::arg("machine"),
             py::arg("judge_rapids"));
  module.def("judge_file", &judge_file, py::arg("program"), py::arg("path"), py::arg("tolerance"),
             py::arg("rotary_tolerance"), py::arg("machine"), py::arg("judge_rapids"));
}

}  // namespace toolcomp::python
