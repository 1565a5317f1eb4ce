// SPDX-License-Identifier: Apache-2.0
// Inputs written by hand: the worked examples of the manuals, and one program for each rule that generated programs
// seldom meet.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace toolcomp::corpus {

// The comment says where the example is from and what it must give, in words and figures worked out by hand. The tests
// compare the vectors with these figures.
struct Example {
  std::string_view comment;
  std::string_view setup;  // TOML; a FANUC control without 1411 has F100 at power-on
  std::string_view program;
  // The expected events, with which tests compare the vector, both engines and the laws: one row for each event, ending
  // with a line feed, typed in from the derivation in the form of the section (tests/golden/rows.h, pose_rows.h,
  // space_rows.h). If it is empty, a table in tests/golden has the rows.
  // NOLINTNEXTLINE(*-redundant-member-init): otherwise GCC warns if braces leave it out
  std::string_view figures = {};
  std::uint32_t samples = 0;  // number of parts into which samples divide a block; 0: no samples
};

// A file of vectors made of examples.
struct ExampleFile {
  std::string_view section;
  std::string_view name;  // "examples": golden/SECTION/examples.jsonl
  std::span<const Example> examples;
};

// Every such file of every section, in the order of fuzz::sections().
std::span<const ExampleFile> example_files();

// Defined in examples/SECTION.cpp.
std::span<const Example> tool_length_offset_examples();
std::span<const Example> tool_length_offset_rules();
std::span<const Example> tool_length_measurement_examples();
std::span<const Example> tool_length_measurement_rules();
std::span<const Example> tool_offset_examples();
std::span<const Example> tool_offset_rules();
std::span<const Example> canned_cycle_examples();
std::span<const Example> cutter_compensation_b_examples();
std::span<const Example> cutter_compensation_b_rules();
std::span<const Example> cutter_compensation_c_examples();
std::span<const Example> cutter_compensation_c_corners();
std::span<const Example> cutter_compensation_c_checks();
std::span<const Example> cutter_compensation_c_rules();
std::span<const Example> tool_side_compensation_examples();
std::span<const Example> tool_side_compensation_rules();
std::span<const Example> leading_edge_offset_examples();
std::span<const Example> leading_edge_offset_rules();
std::span<const Example> tool_center_point_control_examples();
std::span<const Example> tool_center_point_control_rules();
std::span<const Example> tool_posture_control_examples();
std::span<const Example> tool_posture_control_rules();
std::span<const Example> face_milling_examples();
std::span<const Example> face_milling_rules();
std::span<const Example> klartext_examples();
std::span<const Example> klartext_calls();
std::span<const Example> klartext_retractions();
std::span<const Example> klartext_drilling();
std::span<const Example> peripheral_milling_examples();
std::span<const Example> peripheral_milling_rules();
std::span<const Example> programmed_contour_examples();
std::span<const Example> programmed_contour_rules();

}  // namespace toolcomp::corpus
