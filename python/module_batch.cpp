// SPDX-License-Identifier: Apache-2.0
// Lines by the million: numpy arrays in and out, without copies.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fast/batch/batch.h"
#include "python/bindings.h"
#include "python/numbers.h"
#include "spec/language/event_json.h"

namespace py = pybind11;

namespace toolcomp::python {
namespace {

// A contiguous array of doubles is looked at where it is; any other is converted.
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Column = std::tuple<std::string, Array, unsigned>;

// An array that is the memory of the moves, which live as long as any array of them.
template <class Number>
py::array view(std::span<const Number> values, const py::capsule& owner) {
  return py::array_t<Number>({values.size()}, {sizeof(Number)}, values.data(), owner);
}

// A batch that one thread uses at a time; others wait, without the GIL.
class Batch final : private fast::EventSink {
 public:
  explicit Batch(const spec::Setup& setup) : axes_(setup.axes), batch_(setup, this) {}

  void run(const std::string& text) {
    const py::gil_scoped_release released;
    const std::scoped_lock lock(mutex_);
    batch_.run(text);
  }

  void lines(const std::vector<Column>& columns) {
    std::vector<fast::WordColumn> words;
    words.reserve(columns.size());
    for (const auto& [word, array, decimals] : columns) {
      if (array.ndim() != 1) throw std::invalid_argument(word + ": not one-dimensional");
      words.push_back({word, {array.data(), static_cast<std::size_t>(array.size())}, decimals});
    }
    const py::gil_scoped_release released;
    const std::scoped_lock lock(mutex_);
    batch_.lines(words);
  }

  void end() {
    const py::gil_scoped_release released;
    const std::scoped_lock lock(mutex_);
    batch_.end();
  }

  // The moves so far, which are the caller's from now on: blocks, and an array for each axis.
  std::pair<py::array, std::vector<std::pair<std::string, py::array>>> moves() {
    auto taken = std::make_unique<fast::Moves>(axes_.size());
    {
      const py::gil_scoped_release released;
      const std::scoped_lock lock(mutex_);
      std::swap(*taken, batch_.moves());
    }
    const py::capsule owner(taken.get(), [](void* owned) { delete static_cast<fast::Moves*>(owned); });
    const fast::Moves& moves = *taken.release();
    std::vector<std::pair<std::string, py::array>> arrays;
    arrays.reserve(axes_.size());
    for (std::size_t i = 0; i < axes_.size(); ++i)
      arrays.emplace_back(std::string(1, axes_.letter(i)), view(moves.axis(i), owner));
    return {view(moves.block(), owner), std::move(arrays)};
  }

  // Events that are no moves, since the last call, as JSON.
  std::vector<std::string> events() {
    const py::gil_scoped_release released;
    const std::scoped_lock lock(mutex_);
    return std::exchange(events_, {});
  }

  [[nodiscard]] bool stopped() const { return batch_.stopped(); }
  [[nodiscard]] std::uint64_t blocks() const { return batch_.blocks(); }
  [[nodiscard]] std::uint64_t blocks_as_arrays() const { return batch_.blocks_as_arrays(); }

 private:
  void on(const fast::Event& event) override {
    spec::append_event_json(events_.emplace_back(), event, axes_, DoubleNumber{});
  }

  std::mutex mutex_;
  spec::Axes axes_;
  std::vector<std::string> events_;
  fast::Batch batch_;
};

}  // namespace

void bind_batch(py::module_& module) {
  py::class_<Batch>(module, "Batch")
      .def(py::init<const spec::Setup&>(), py::arg("setup"))
      .def("run", &Batch::run, py::arg("text"))
      .def("lines", &Batch::lines, py::arg("columns"))
      .def("end", &Batch::end)
      .def("moves", &Batch::moves)
      .def("events", &Batch::events)
      .def_property_readonly("stopped", &Batch::stopped)
      .def_property_readonly("blocks", &Batch::blocks)
      .def_property_readonly("blocks_as_arrays", &Batch::blocks_as_arrays);
}

}  // namespace toolcomp::python
