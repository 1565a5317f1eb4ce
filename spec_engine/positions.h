// SPDX-License-Identifier: Apache-2.0
// Positions that the formal specification tells, by axes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "model/exact/real.h"
#include "spec/language/axes.h"
#include "spec/language/event.h"
#include "spec_engine/data.h"

namespace toolcomp::spec_engine {

// Of every axis.
inline spec::AxisValues<exact::Real> positions(const Data& data, const spec::Axes& axes) {
  spec::AxisValues<exact::Real> values;
  for (std::size_t i = 0; i < axes.size(); ++i) values.set(i, data.list().at(i).number());
  return values;
}

// Of the linear axes, which alone are told; but for those of `unknown`, bit i axis i.
inline spec::AxisValues<exact::Real> linear_positions(const Data& data, const spec::Axes& axes,
                                                      std::uint16_t unknown = 0) {
  spec::AxisValues<exact::Real> values;
  std::size_t next = 0;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (spec::is_linear_axis(axes.letter(i)) && (unknown >> i & 1U) == 0)
      values.set(i, data.list().at(next++).number());
  return values;
}

// A hole, of place, kind, point (the linear axes but the drilling axis), point R, bottom, return level, the positions
// behind it, and the place of the drilling axis. Returns the positions: the dialects do not tell the same axes.
inline const Data& read_hole(spec::Event<exact::Real>& event, const List& data, const spec::Axes& axes) {
  event.kind = spec::EventKind::hole;
  const auto drilled = static_cast<std::size_t>(data.at(7).integer());
  event.point = linear_positions(data.at(2), axes, static_cast<std::uint16_t>(1U << drilled));
  event.hole = {drilled, data.at(3).number(), data.at(4).number(), data.at(5).number()};
  return data.at(6);
}

inline std::array<exact::Real, 3> vector_of(const Data& data) {
  const List& v = data.list();
  return {v.at(0).number(), v.at(1).number(), v.at(2).number()};
}

}  // namespace toolcomp::spec_engine
