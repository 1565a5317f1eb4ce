// SPDX-License-Identifier: Apache-2.0
// The machine that a kit is made for: its setup, and the travels of its axes.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "model/basis/event.h"
#include "spec/language/setup.h"

namespace toolcomp::certify::kit {

// Machine coordinates, in the units of the setup or in degrees.
struct Travel {
  spec::Decimal least, greatest;
};

// [position] of the setup is the place at which every program begins, ends and makes its marks. G54 of the setup is the
// origin that the operator of the kit sets.
struct Machine {
  spec::Setup setup;
  std::map<char, Travel> travels;  // one for every axis
};

// Reads "X=-300,300" into the machine. Throws spec::InputError for anything else, for an axis that the setup does not
// have or that is given twice, and for a least position that is not below the greatest.
void add_travel(Machine& machine, std::string_view text);

// Throws spec::InputError that names what is missing: an axis without travel, a place of marks outside the travels.
void expect_whole(const Machine& machine);

// The axis that makes the marks: the first linear axis.
char mark_axis(const Machine& machine);

// How the axes leave the travels in these events; empty if they do not. Arcs count with all their points. Between two
// samples a path may leave the box around both by the longest step between two samples, so that samples make the test
// safe under tool center point control.
std::string outside_travels(const Machine& machine, std::span<const model::Event> events);

// The least and greatest machine coordinate of every axis, in the order of the setup.
struct Extent {
  double least = 0;
  double greatest = 0;
};
std::map<char, Extent> extents(const Machine& machine, std::span<const model::Event> events);

// The value of an axis in a table of a setup; 0 if it has none.
double value_in(const spec::AxisTable& table, char axis);

}  // namespace toolcomp::certify::kit
