// SPDX-License-Identifier: Apache-2.0
// Other origins, and the same places: what the machine does is the same.
#include <algorithm>
#include <set>

#include "judge/laws/fanuc/changed.h"
#include "judge/laws/fanuc/fanuc_program.h"
#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

// How far the origin of a system is moved along an axis: for every system and axis another way, a decimal in both
// units.
Rational way(bool inches, int system, std::size_t axis) {
  const auto steps = static_cast<int>(spec::kMaxAxes) * system + static_cast<int>(axis);
  return Rational(inches ? 5 : 127) * Rational(steps);
}

bool is_linear(const spec::Axes& axes, std::size_t axis) { return spec::is_linear_axis(axes.letter(axis)); }

// A place, in all linear axes or in those that the table has; false where a number cannot be written.
bool move(const spec::Setup& setup, spec::AxisTable& table, int system, int sign, bool all) {
  for (std::size_t i = 0; i < setup.axes.size(); ++i) {
    const char letter = setup.axes.letter(i);
    if (!is_linear(setup.axes, i) || (!all && !table.contains(letter))) continue;
    const auto moved =
        decimal(rational(table[letter]) + Rational(sign) * way(setup.units == spec::Units::inch, system, i));
    if (!moved) return false;
    table[letter] = *moved;
  }
  return true;
}

std::optional<int> whole(const spec::Decimal* value) {
  if (value == nullptr || value->decimals != 0 || value->digits > spec::kAdditionalWorkpieces) return std::nullopt;
  return static_cast<int>(value->digits);
}

const spec::Decimal* last(const spec::Block& block, char address) {
  const spec::Decimal* found = nullptr;
  for (const spec::Word& w : block.words())
    if (w.address == address) found = &w.value;
  return found;
}

// The system whose origin G10 L2 or L20 writes; nothing where it is another G10, or the origin added to all.
std::optional<int> written_system(const spec::Block& block) {
  const auto l = whole(last(block, 'L'));
  const auto p = whole(last(block, 'P'));
  if (!p || *p == 0) return std::nullopt;
  if (l == 2) return p;
  if (l == 20) return kSystems + *p;
  return std::nullopt;
}

// Number of a word as the program has it, and `by` more.
std::optional<spec::Decimal> shifted(const spec::Setup& setup, bool inches, const spec::Decimal& word,
                                     const Rational& by) {
  // More digits are an alarm (PS0003).
  constexpr std::uint64_t too_many = 100'000'000'000'000;
  const auto sum = decimal(programmed_length(setup, inches, word) + by);
  return sum && sum->digits < too_many ? sum : std::nullopt;
}

std::optional<spec::Word> moved(const spec::Setup& setup, const FanucBlock& b, const spec::Block& block,
                                const spec::Word& word) {
  // Point R is a place along the drilling axis.
  const bool is_point_r = word.address == 'R' && b.drills && b.has('R');
  const std::size_t axis = setup.axes.index(is_point_r ? b.drilling->axis : word.address);
  if (axis == spec::Axes::kNone || !is_linear(setup.axes, axis)) return word;
  Rational by;
  if (!b.has(word.address)) {
    const auto system = b.has_code(kG10) ? written_system(block) : std::nullopt;
    if (!system || !b.absolute) return word;
    by = way(b.inches, *system, axis);
  } else if (b.has_code(kG53) || b.has_code(kG52) || !(b.absolute || b.has_code(kG92))) {
    return word;  // of the machine, from the origin, from the position
  } else {
    by = -way(b.inches, *b.system, axis);
  }
  const auto value = shifted(setup, b.inches, word.value, by);
  if (!value) return std::nullopt;
  spec::Word other = word;
  other.value = *value;
  return other;
}

// A coordinate that is kept from one system for another is another place there.
bool keeps_coordinates(const FanucProgram& program) {
  std::set<std::optional<int>> intermediate;
  std::set<std::optional<int>> measured;
  for (const FanucBlock& b : program.blocks()) {
    if (b.has_code(kG28) || b.has_code(kG30) || b.has_code(kG30_1)) intermediate.insert(b.system);
    if (b.has_code(kG29) && intermediate.size() > intermediate.count(b.system)) return true;
    if (b.has_code(kG37)) measured.insert(b.system);
  }
  return measured.size() > 1;
}

// So is a level that is kept, or a length of a hole; one that no block gave may be no place at all.
bool keeps_levels(const FanucProgram& program) {
  return std::ranges::any_of(program.blocks(), [&program](const FanucBlock& b) {
    if (!b.drilling) return false;
    const DrillingMode& mode = *b.drilling;
    return !mode.clear || b.system != program.blocks()[mode.begun].system ||
           (b.drills && (!mode.point_r || !mode.bottom));
  });
}

// The setup with its origins elsewhere; nothing where it cannot be written.
std::optional<spec::Setup> moved(const spec::Setup& setup, const FanucProgram& program) {
  std::set<int> systems;
  for (int i = 1; i <= kSystems; ++i) systems.insert(i);
  int measured = 1;
  for (const FanucBlock& b : program.blocks()) {
    if (!b.system) return std::nullopt;
    systems.insert(*b.system);
    if (b.has_code(kG37)) measured = *b.system;
  }
  spec::Setup other = setup;
  for (const int system : systems) {
    const int additional = system - kSystems;
    if (additional > static_cast<int>(spec::kAdditionalWorkpieces)) continue;
    spec::AxisTable& table = additional > 0 ? other.additional_workpiece[static_cast<std::uint32_t>(additional)]
                                            : other.workpiece.at(static_cast<std::size_t>(system - 1));
    if (!move(setup, table, system, 1, true)) return std::nullopt;
  }
  if (!move(setup, other.position, 1, -1, true) || !move(setup, other.measurement, measured, -1, false))
    return std::nullopt;
  return other;
}

struct Comparison {
  const spec::Setup& setup;
  std::optional<int> system;  // nothing: the machine itself
  std::size_t event;
  Holding& holding;

  void operator()(const spec::AxisValues<Real>& values, const spec::AxisValues<Real>& other,
                  std::string_view what) const {
    for (std::size_t i = 0; i < setup.axes.size(); ++i) {
      holding.holds(values.has(i) == other.has(i), event, what);
      if (values.has(i) && other.has(i)) compare(values[i], other[i], i, what);
    }
  }
  void operator()(const spec::Hole<Real>& hole, const spec::Hole<Real>& other, std::string_view what) const {
    holding.holds(hole.axis == other.axis, event, "the same drilling axis with other origins");
    for (const auto member : {&spec::Hole<Real>::point_r, &spec::Hole<Real>::bottom, &spec::Hole<Real>::level})
      compare(hole.*member, other.*member, hole.axis, what);
  }

 private:
  void compare(const Real& value, const Real& other, std::size_t axis, std::string_view what) const {
    Real change = other - value;
    if (system && is_linear(setup.axes, axis)) change += Real(way(setup.units == spec::Units::inch, *system, axis));
    holding.zero(change, event, what);
  }
};

void compare(const spec::Setup& setup, const FanucProgram& program, const model::Event& event,
             const model::Event& other, std::size_t index, Holding& holding) {
  holding.holds(is_alike(event, other), index, "the same kind of event with other origins");
  holding.zero(other.value - event.value, index, "value set, less that with other origins");
  Comparison{setup, std::nullopt, index, holding}(event.machine, other.machine,
                                                  "place in the machine, less that with other origins");
  const std::size_t block = program.index(event.line);
  if (block == program.blocks().size()) return;
  const Comparison same{setup, program.blocks()[block].system, index, holding};
  same(event.programmed, other.programmed, "place programmed, less that with other origins");
  same(event.point, other.point, "place of the point, less that with other origins");
  same(event.axes, other.axes, "place of the axes, less that with other origins");
  if (event.hole && other.hole) same(*event.hole, *other.hole, "level of a hole, less that with other origins");
  if (event.arc && other.arc) same(event.arc->center, other.arc->center, "centre, less that with other origins");
}

}  // namespace

bool selects_a_system(const spec::Case& c) {
  const FanucProgram program(c);
  return std::ranges::any_of(program.blocks(), [](const FanucBlock& b) { return b.system != 1; });
}

void moved_origins(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding) {
  const FanucProgram program(c);
  if (keeps_coordinates(program) || keeps_levels(program)) return;
  const auto setup = moved(c.setup, program);
  if (!setup) return;
  const auto text = rewritten(c, [&](std::size_t i, const spec::Block& block, const spec::Word& word) {
    return moved(c.setup, program.blocks().at(i), block, word);
  });
  if (!text) return;
  spec::Case changed = c;
  changed.setup = *setup;
  changed.program = *text;
  const std::vector<model::Event> other = run(changed);
  const std::size_t both = std::min(events.size(), other.size());
  for (std::size_t i = 0; i < both; ++i) {
    // What is left open may be open for its numbers.
    if (events[i].kind == spec::EventKind::undecided || other[i].kind == spec::EventKind::undecided) return;
    compare(c.setup, program, events[i], other[i], i, holding);
  }
  holding.holds(events.size() == other.size(), both, "as many events with other origins");
}

}  // namespace toolcomp::judge::laws
