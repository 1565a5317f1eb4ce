// SPDX-License-Identifier: Apache-2.0
// The machine that a kit is for: its setup, and how far its axes may go.
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

// The setup's [position] is the place where every program begins and ends and makes its marks, its G54 the origin that
// whoever runs the kit sets.
struct Machine {
  spec::Setup setup;
  std::map<char, Travel> travels;  // one for every axis
};

// Reads "X=-300,300" into the machine. Throws spec::InputError for anything else, for an axis that the setup does not
// have or that was given before, and for a least that is not below the greatest.
void add_travel(Machine& machine, std::string_view text);

// Throws spec::InputError that names what is missing: an axis without travel, a place of marks outside the travels.
void expect_whole(const Machine& machine);

// The axis that makes marks: the first linear one.
char mark_axis(const Machine& machine);

// How the axes go outside the travels in these events; empty where they do not. Arcs count with all they pass; between
// two samples a path may leave the box of both by the longest step between two, so samples make it safe under tool
// center point control.
std::string outside_travels(const Machine& machine, std::span<const model::Event> events);

// The least and greatest machine coordinate of every axis, in the order of the setup.
struct Extent {
  double least = 0;
  double greatest = 0;
};
std::map<char, Extent> extents(const Machine& machine, std::span<const model::Event> events);

// The value of an axis in a table of a setup; 0 where it has none.
double value_in(const spec::AxisTable& table, char axis);

}  // namespace toolcomp::certify::kit
