// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>

#include "fuzz/gen/late_fault.h"
#include "fuzz/gen/program_text.h"
#include "spec/clauses/clauses.h"
#include "spec/language/setup_key.h"

namespace toolcomp::fuzz {
namespace {

// A section and what makes its directed cases.
struct Generator {
  std::string_view section;
  spec::Case (*make)(Choices& choose, std::uint32_t blocks);
};
constexpr Generator kGenerators[] = {
    {"fanuc/tool-length-offset", tool_length_offset},
    {"fanuc/tool-length-measurement", tool_length_measurement},
    {"fanuc/tool-offset", tool_offset},
    {"fanuc/canned-cycle", canned_cycle},
    {"fanuc/cutter-compensation-b", cutter_compensation_b},
    {"fanuc/cutter-compensation-c", cutter_compensation_c},
    {"fanuc/tool-side-compensation", tool_side_compensation},
    {"fanuc/leading-edge-offset", leading_edge_offset},
    {"fanuc/tool-center-point-control", tool_center_point_control},
    {"fanuc/tool-posture-control", tool_posture_control},
    {"heidenhain/face-milling", face_milling},
    {"heidenhain/peripheral-milling", peripheral_milling},
    {"heidenhain/programmed-contour", programmed_contour},
};
constexpr auto kSections = [] {
  std::array<std::string_view, std::size(kGenerators)> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kGenerators[i].section;
  return names;
}();
// Of a hundred directed cases, those that are left as they were made.
constexpr std::uint64_t kFaultsAnywhere = 15;
// Cases made one after the other until one has enough to judge.
constexpr int kMostDraws = 3;

// Mostly a few blocks, which are quick to run and to read; some tens; seldom hundreds, as real programs have.
std::uint32_t number_of_blocks(Choices& choose) {
  switch (choose.weighted({188, 10, 2})) {
    case 0:
      return static_cast<std::uint32_t>(choose.between(4, 8));
    case 1:
      return static_cast<std::uint32_t>(choose.between(9, 40));
    default:
      return static_cast<std::uint32_t>(choose.between(40, 300));
  }
}

// Those of fanuc/program and heidenhain/program rule every section of their control.
bool has_clause_of(const spec::KeyInfo& key, std::string_view section) {
  return std::ranges::any_of(key.clauses, [&](std::string_view id) {
    const auto clause = spec::find_clause(id);
    const std::string_view of = clause ? spec::info(*clause).section : std::string_view();
    return of == section || (of.ends_with("/program") && section.starts_with(of.substr(0, of.find('/') + 1)));
  });
}

// Keys of this section that nothing else chooses (percent in spec/parameters.toml).
void choose_keys(Choices& choose, spec::Case& c) {
  for (const spec::KeyInfo& key : spec::keys())
    if (key.percent != 0 && has_clause_of(key, c.section) && choose.chance(key.percent))
      key.set(c.setup, (key.default_value + 1 + choose.below(key.values.size() - 1)) % key.values.size());
}

// The series, and the parameters of fanuc/program, which rule every section.
void choose_program_parameters(Choices& choose, spec::Setup& setup) {
  if (setup.control != spec::Control::fanuc) return;
  if (choose.chance(30)) setup.series = spec::Series::series_30i;
  // Seldom none: a cutting move before the first F ends the run.
  if (choose.chance(90)) setup.parameters[{1411, -1}] = spec::decimal(choose.between(1, 40) * 100);
  if (choose.chance(15)) setup.parameters[{3403, 5}] = spec::decimal(choose.chance(85) ? 0 : 1);
  if (choose.chance(5)) setup.parameters[{3403, 6}] = spec::decimal(choose.chance(85) ? 1 : 0);
  if (choose.chance(15)) setup.parameters[{3410, -1}] = spec::decimal(choose.between(0, 4));
}

// Seldom M140 somewhere, or a departure, and mostly words behind it that make the position known again. Chosen last, so
// that no other case changes.
void put_retraction(Choices& choose, spec::Case& c) {
  if (c.setup.control != spec::Control::heidenhain || !choose.chance(8)) return;
  std::vector<std::string> text = lines(c.program);
  if (text.size() < 3) return;
  const std::size_t at = 1 + choose.below(text.size() - 2);
  if (text[at - 1].ends_with('~')) return;
  std::vector<std::string> more;
  if (choose.chance(15)) more = {"L IX+3 IY-2 RL F100", "DEP LT LEN5 F200"};
  more.emplace_back(choose.one_of({"L M140 MB MAX", "L M140 MB+5", "M140 MB 2.5", "L R0 FMAX M140 MB MAX",
                                   "L M140 MB-1.25 F500", "M140 MB MAX FMAX M9", "L R0 F200 M140 MB30"}));
  if (choose.chance(75))
    more.emplace_back(choose.one_of({"L X+1 Y+2 Z+3 R0 FMAX", "L Z+50 R0 FMAX", "L X-4.5 Y+7 R0"}));
  text.insert(text.begin() + static_cast<std::ptrdiff_t>(at), more.begin(), more.end());
  c.program = joined(text);
}

spec::Case directed(const Generator& generator, Choices& choose, std::uint32_t blocks) {
  spec::Case c = generator.make(choose, blocks);
  c.section = generator.section;
  // Faults come late, so that something is judged before them; a few stay where they are.
  if (choose.chance(kFaultsAnywhere)) return c;
  for (int draws = 1; !put_fault_last(c) && draws < kMostDraws; ++draws) {
    c = generator.make(choose, blocks);
    c.section = generator.section;
  }
  return c;
}

}  // namespace

std::span<const std::string_view> sections() { return kSections; }

spec::Case generate(std::string_view section, Mode mode, ChoiceSource& source, std::uint32_t blocks) {
  Choices choose(source);
  if (blocks == 0) blocks = number_of_blocks(choose);
  const auto* const generator = std::ranges::find(kGenerators, section, &Generator::section);
  if (generator == std::end(kGenerators))
    throw std::invalid_argument(fmt::format("no generator for section \"{}\"", section));
  spec::Case c = mode == Mode::directed ? directed(*generator, choose, blocks) : generator->make(choose, blocks);
  c.section = section;
  if (mode == Mode::unrestricted) return unrestricted(choose, std::move(c), blocks);
  choose_keys(choose, c);
  choose_program_parameters(choose, c.setup);
  put_retraction(choose, c);
  return c;
}

spec::Case generate_with_slip(std::string_view section, ChoiceSource& source) {
  spec::Case c = generate(section, Mode::directed, source);
  Choices choose(source);
  slip(choose, c);
  if (!choose.chance(kFaultsAnywhere)) put_fault_last(c);
  return c;
}

}  // namespace toolcomp::fuzz
