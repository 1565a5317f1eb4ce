// SPDX-License-Identifier: Apache-2.0
// Positions that the formal specification tells, by axes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "formal/data.h"
#include "model/exact/real.h"
#include "spec/language/axes.h"
#include "spec/language/event.h"

namespace toolcomp::formal {

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

inline std::array<exact::Real, 3> vector_of(const Data& data) {
  const List& v = data.list();
  return {v.at(0).number(), v.at(1).number(), v.at(2).number()};
}

}  // namespace toolcomp::formal
