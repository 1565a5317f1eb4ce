// SPDX-License-Identifier: Apache-2.0
// The image of a program under a map of space: mirrored, turned, a tenth as large.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "judge/laws/fanuc/changed.h"
#include "judge/laws/fanuc/fanuc_program.h"
#include "judge/laws/numbers.h"
#include "spec/language/parameter.h"

namespace toolcomp::judge::laws {
namespace {

// Image of X, Y, Z: component i is sign[i] times component from[i], or a tenth of that.
struct Map {
  std::array<std::size_t, 3> from{0, 1, 2};
  std::array<int, 3> sign{1, 1, 1};
  bool mirrors = false;  // exchanges left and right
  bool tenth = false;
};
constexpr Map kMirror{{0, 1, 2}, {-1, 1, 1}, true, false};
constexpr Map kQuarterTurn{{1, 0, 2}, {-1, 1, 1}, false, false};  // X is -Y, Y is X
constexpr Map kTenth{{0, 1, 2}, {1, 1, 1}, false, true};

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
std::size_t component(char letter) {
  return letter >= 'X' && letter <= 'Z' ? static_cast<std::size_t>(letter - 'X') : kNone;
}
std::size_t vector_component(char letter) {
  return letter >= 'I' && letter <= 'K' ? static_cast<std::size_t>(letter - 'I') : kNone;
}
std::size_t image_of(const Map& map, std::size_t component) {
  return static_cast<std::size_t>(std::ranges::find(map.from, component) - map.from.begin());
}

// A tenth has one decimal more; nothing where that cannot be read, or would be another number (3401#0 = 0).
std::optional<spec::Decimal> image_of(const Map& map, spec::Decimal value, int sign) {
  if (sign < 0) value.negative = !value.negative;
  if (!map.tenth) return value;
  constexpr std::uint64_t largest = 99'999'999'999;
  constexpr int most = 10;
  if (value.digits > largest || value.decimals >= most) return std::nullopt;
  ++value.decimals;
  value.point = true;
  return value;
}

bool change(const Map& map, spec::AxisTable& table) {
  spec::AxisTable image;
  for (const auto& [letter, value] : table) {
    const std::size_t source = component(letter);
    if (source == kNone) {
      const auto scaled = spec::is_linear_axis(letter) ? image_of(map, value, 1) : value;
      if (!scaled) return false;
      image[letter] = *scaled;
      continue;
    }
    const std::size_t target = image_of(map, source);
    const auto scaled = image_of(map, value, map.sign.at(target));
    if (!scaled) return false;
    image["XYZ"[target]] = *scaled;
  }
  table = std::move(image);
  return true;
}

bool change_all(const Map& map, spec::Setup& setup) {
  for (spec::AxisTable& table : setup.workpiece)
    if (!change(map, table)) return false;
  for (auto& [number, table] : setup.additional_workpiece)
    if (!change(map, table)) return false;
  for (auto& [number, table] : setup.reference)
    if (!change(map, table)) return false;
  return change(map, setup.position) && change(map, setup.floating_reference) && change(map, setup.measurement);
}

bool is_length(spec::ParameterId id) {
  const spec::ParameterInfo* const p = spec::find_parameter(id);
  return p != nullptr && p->type == spec::ParameterType::length;
}

bool shorten(const Map& map, spec::Setup& setup) {
  for (auto& [id, value] : setup.parameters) {
    if (!is_length(id)) continue;
    const auto scaled = image_of(map, value, 1);
    if (!scaled) return false;
    value = *scaled;
  }
  for (auto* offsets : {&setup.h, &setup.d})
    for (auto& [number, entry] : *offsets) {
      const auto geometry = image_of(map, entry.geometry, 1);
      const auto wear = image_of(map, entry.wear, 1);
      if (!geometry || !wear) return false;
      entry = {*geometry, *wear};
    }
  return true;
}

// How often a hole is drilled (K), or a depth of cut or a shift at the bottom (Q). Nothing where it may be another
// word.
std::optional<bool> is_of_a_cycle(const FanucBlock& b) {
  if (b.cancels_its_cycle() || (b.drilling && !b.drilling->clear)) return std::nullopt;
  return b.drilling.has_value();
}

// Lengths at other addresses than X Y Z I J K.
bool is_further_length(const FanucBlock& b, char address) {
  return address == 'R' || (address >= 'U' && address <= 'W') || (address == 'Q' && b.drilling);
}

// A word of this block in the image; nothing where it cannot be written.
std::optional<spec::Word> change(const Map& map, const FanucBlock& b, const spec::Word& word) {
  spec::Word image = word;
  if (map.tenth && (word.address == 'K' || word.address == 'Q')) {
    const auto of_a_cycle = is_of_a_cycle(b);
    if (!of_a_cycle) return std::nullopt;
    if (*of_a_cycle && word.address == 'K') return image;
  }
  const std::size_t axis = component(word.address);
  const std::size_t vector = vector_component(word.address);
  if (axis != kNone || vector != kNone) {
    const std::size_t target = image_of(map, axis != kNone ? axis : vector);
    const auto value = image_of(map, word.value, map.sign.at(target));
    if (!value) return std::nullopt;
    image.address = axis != kNone ? "XYZ"[target] : "IJK"[target];
    image.value = *value;
  } else if (map.tenth && is_further_length(b, word.address)) {
    const auto value = image_of(map, word.value, 1);
    if (!value) return std::nullopt;
    image.value = *value;
  } else if (map.mirrors && word.address == 'G') {
    // G41.0 is G41.
    const int code = code_of(word.value);
    if (code == kG41 || code == kG42) image.value = spec::decimal(83 - code / 10);
    if (code == kG02 || code == kG03) image.value = spec::decimal(5 - code / 10);
  }
  return image;
}

using Values = spec::AxisValues<Real>;
using Hole = spec::Hole<Real>;

// `image` is the image of `original`.
void compare(const Map& map, const spec::Axes& axes, const Values& original, const Values& image, std::size_t event,
             std::string_view what, Holding& holding) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::size_t target = component(axes.letter(i));
    std::size_t source = i;
    Rational factor = map.tenth && spec::is_linear_axis(axes.letter(i)) ? Rational(1, 10) : Rational(1);
    if (target != kNone) {
      source = axes.index("XYZ"[map.from.at(target)]);
      factor *= map.sign.at(target);
    }
    if (source == spec::Axes::kNone) continue;
    holding.holds(original.has(source) == image.has(i), event, what);
    if (original.has(source) && image.has(i)) holding.zero(image[i] - Real(factor) * original[source], event, what);
  }
}

void compare(const Map& map, const spec::Axes& axes, const Hole& original, const Hole& image, std::size_t event,
             Holding& holding) {
  const std::size_t source = component(axes.letter(original.axis));
  const std::size_t target = source == kNone ? kNone : image_of(map, source);
  holding.holds(image.axis == (target == kNone ? original.axis : axes.index("XYZ"[target])), event,
                "image of the drilling axis");
  Rational factor = map.tenth ? Rational(1, 10) : Rational(1);
  if (target != kNone) factor *= map.sign.at(target);
  for (const auto member : {&Hole::point_r, &Hole::bottom, &Hole::level})
    holding.zero(image.*member - Real(factor) * original.*member, event, "image of a level of the hole");
}

void compare(const Map& map, const spec::Axes& axes, const model::Event& original, const model::Event& image,
             std::size_t event, Holding& holding) {
  holding.holds(is_alike(original, image), event, "the same kind of event, at the same place");
  compare(map, axes, original.programmed, image.programmed, event, "image of the programmed point", holding);
  compare(map, axes, original.point, image.point, event, "image of the point", holding);
  compare(map, axes, original.axes, image.axes, event, "image of the axes", holding);
  if (original.hole && image.hole) compare(map, axes, *original.hole, *image.hole, event, holding);
  if (!original.arc || !image.arc) return;
  compare(map, axes, original.arc->center, image.arc->center, event, "image of the centre", holding);
  // An arc that ends in its centre has no sense.
  if (original.arc->sweep)
    holding.holds((original.arc->direction == image.arc->direction) != map.mirrors, event, "image of the sense");
  holding.holds(original.arc->sweep.has_value() == image.arc->sweep.has_value(), event, "image of the sweep");
  if (original.arc->sweep && image.arc->sweep)
    holding.zero(*image.arc->sweep - *original.arc->sweep, event, "the same sweep");
}

void image(const Map& map, const spec::Case& c, std::span<const model::Event> events, const Runner& run,
           Holding& holding) {
  if (is_open(events)) return;
  const FanucProgram program(c);
  if (map.tenth) {
    if (program.has_code({kG10, kG37}) || !c.setup.bit(3401, 0, true)) return;
  } else {
    if (!c.setup.axes.has('X') || !c.setup.axes.has('Y')) return;
    if (program.has_code({kG37, kG41_2, kG42_2, kG41_3, kG41_6, kG42_6, kG43_4, kG43_5})) return;
    if (program.has_code({kG18, kG19}) || (c.setup.bit(5001, 0) && program.has_code({kG43, kG44}))) return;
    if (std::ranges::any_of(events, [](const model::Event& e) { return e.tool_axis.has_value(); })) return;
  }
  spec::Case changed = c;
  const auto text = rewritten(c, [&](std::size_t i, const spec::Block&, const spec::Word& w) {
    return change(map, program.blocks().at(i), w);
  });
  if (!text || !change_all(map, changed.setup) || (map.tenth && !shorten(map, changed.setup))) return;
  changed.program = *text;
  const std::vector<model::Event> other = run(changed);
  if (is_open(other)) return;
  for (std::size_t i = 0; i < std::min(events.size(), other.size()); ++i)
    compare(map, c.setup.axes, events[i], other[i], i, holding);
  holding.holds(events.size() == other.size(), std::min(events.size(), other.size()), "as many events as in the image");
}

}  // namespace

void mirrored(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding) {
  image(kMirror, c, events, run, holding);
}

void quarter_turn(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding) {
  image(kQuarterTurn, c, events, run, holding);
}

void a_tenth(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding) {
  image(kTenth, c, events, run, holding);
}

}  // namespace toolcomp::judge::laws
