// SPDX-License-Identifier: Apache-2.0
#include "cli/radii_note.h"

#include <fmt/format.h>

#include <algorithm>

namespace toolcomp::cli {

namespace {
// Ten times what rounding I and J to the least increment makes.
constexpr double kMillimetres = 0.01;
constexpr double kInches = 0.001;
}  // namespace

RadiiNote::RadiiNote(const spec::Setup& setup)
    : axes_(setup.axes),
      watches_(setup.control == spec::Control::fanuc && !setup.parameters.contains({3410, -1})),
      least_(setup.units == spec::Units::mm ? kMillimetres : kInches) {}

void RadiiNote::see(std::uint64_t line, double difference) {
  if (!(difference > least_)) return;
  first_line_ == 0 ? first_line_ = line : ++others_;
  largest_ = std::max(largest_, difference);
}

std::string RadiiNote::text() const {
  return fmt::format(
      "the start radius and the end radius of this arc{} differ by up to {:.6g}; the setup has no parameter 3410, the "
      "limit above which a control raises PS0020",
      others_ == 0 ? "" : fmt::format(" and of {} more", others_), largest_);
}

}  // namespace toolcomp::cli
