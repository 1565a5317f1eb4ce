#include "fuzz/laws/changed_program.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "fuzz/laws/scene.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/input_error.h"
#include "spec/language/parameter.h"

namespace toolcomp::fuzz::laws {
namespace {

constexpr std::array<std::string_view, 5> kNames{"value-zero", "mirrored", "quarter-turn", "a-tenth", "reversed"};

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

// A word in the image; nothing where it cannot be written.
std::optional<spec::Word> change(const Map& map, const spec::Word& word) {
  spec::Word image = word;
  const std::size_t axis = component(word.address);
  const std::size_t vector = vector_component(word.address);
  if (axis != kNone || vector != kNone) {
    const std::size_t target = image_of(map, axis != kNone ? axis : vector);
    const auto value = image_of(map, word.value, map.sign.at(target));
    if (!value) return std::nullopt;
    image.address = axis != kNone ? "XYZ"[target] : "IJK"[target];
    image.value = *value;
  } else if (map.tenth && (word.address == 'R' || (word.address >= 'U' && word.address <= 'W'))) {
    const auto value = image_of(map, word.value, 1);
    if (!value) return std::nullopt;
    image.value = *value;
  } else if (map.mirrors && word.address == 'G' && word.value.is_integer()) {
    auto& code = image.value.digits;
    if (code == 41 || code == 42) code = 83 - code;
    if (code == 2 || code == 3) code = 5 - code;
  }
  return image;
}

// The program in the image, every block in its line; nothing where one cannot be read or written, or two share a line.
std::optional<std::string> change(const Map& map, const spec::Case& c) {
  std::string text;
  std::uint64_t line = 1;
  try {
    spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes,
                               {.file = "program", .block_skip = c.setup.block_skip});
    const auto block = std::make_unique<spec::Block>();
    std::uint64_t latest = 0;
    while (reader.next(*block)) {
      if (block->alarm || block->line == latest) return std::nullopt;
      latest = block->line;
      for (; line < block->line; ++line) text += '\n';
      for (std::size_t i = 0; i < block->size; ++i) {
        const auto word = change(map, block->word.at(i));
        if (!word) return std::nullopt;
        block->word.at(i) = *word;
      }
      text += to_string(*block);
    }
  } catch (const spec::InputError&) {
    return std::nullopt;
  }
  return text + '\n';
}

using Values = spec::AxisValues<Real>;

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

void compare(const Map& map, const spec::Axes& axes, const model::Event& original, const model::Event& image,
             std::size_t event, Holding& holding) {
  holding.holds(original.kind == image.kind && original.line == image.line && original.type == image.type &&
                    original.cause == image.cause && original.number == image.number &&
                    original.arc.has_value() == image.arc.has_value(),
                event, "the same kind of event, at the same place");
  compare(map, axes, original.programmed, image.programmed, event, "image of the programmed point", holding);
  compare(map, axes, original.point, image.point, event, "image of the point", holding);
  compare(map, axes, original.axes, image.axes, event, "image of the axes", holding);
  if (!original.arc || !image.arc) return;
  compare(map, axes, original.arc->center, image.arc->center, event, "image of the centre", holding);
  // An arc that ends in its centre has no sense.
  if (original.arc->sweep)
    holding.holds((original.arc->direction == image.arc->direction) != map.mirrors, event, "image of the sense");
  holding.holds(original.arc->sweep.has_value() == image.arc->sweep.has_value(), event, "image of the sweep");
  if (original.arc->sweep && image.arc->sweep)
    holding.zero(*image.arc->sweep - *original.arc->sweep, event, "the same sweep");
}

// Where the run is left open, or ends at a range of the offset memory.
bool is_open(std::span<const model::Event> events) {
  return std::ranges::any_of(events, [](const model::Event& e) {
    return e.kind == spec::EventKind::undecided || e.number == "PS0029" || e.number == "PS0032";
  });
}

void image(const Map& map, const spec::Case& c, std::span<const model::Event> events, const Runner& run,
           Holding& holding) {
  if (c.setup.control != spec::Control::fanuc || is_open(events)) return;
  const FanucProgram program(c);
  if (map.tenth) {
    if (program.has_code({100, 370}) || !c.setup.bit(3401, 0, true)) return;
  } else {
    if (!c.setup.axes.has('X') || !c.setup.axes.has('Y')) return;
    if (program.has_code({370, 412, 422, 413, 416, 426, 434, 435})) return;
    if (program.has_code({180, 190}) || (c.setup.bit(5001, 0) && program.has_code({430, 440}))) return;
    if (std::ranges::any_of(events, [](const model::Event& e) { return e.tool_axis.has_value(); })) return;
  }
  spec::Case changed = c;
  const auto text = change(map, c);
  if (!text || !change_all(map, changed.setup) || (map.tenth && !shorten(map, changed.setup))) return;
  changed.program = *text;
  const std::vector<model::Event> other = run(changed);
  if (is_open(other)) return;
  for (std::size_t i = 0; i < std::min(events.size(), other.size()); ++i)
    compare(map, c.setup.axes, events[i], other[i], i, holding);
  holding.holds(events.size() == other.size(), std::min(events.size(), other.size()), "as many events as in the image");
}

void clear(spec::Setup& setup) {
  for (auto* offsets : {&setup.h, &setup.d})
    for (auto& [number, entry] : *offsets) entry = {};
  setup.parameters.erase({19666, -1});
  for (spec::ToolRow& tool : setup.tools) {
    tool.dl = tool.dr = tool.dr2 = {};
    tool.dr2_table.clear();
  }
  for (auto& [number, row] : setup.tcs) row = {};
}

void value_zero(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding) {
  spec::Case changed = c;
  clear(changed.setup);
  const bool fanuc = c.setup.control == spec::Control::fanuc;
  if (fanuc && FanucProgram(c).has_code({100, 370})) return;
  if (!fanuc) {
    std::string text = c.program;
    std::ranges::transform(text, text.begin(), [](unsigned char ch) { return static_cast<char>(std::toupper(ch)); });
    for (const std::string_view word : {"CONTOUR", "DL", "DR"})
      if (text.find(word) != std::string::npos) return;
  }
  const std::vector<model::Event> other = run(changed);
  const Scene scene(changed, other);
  for (std::size_t i = 0; i < other.size(); ++i) {
    const model::Event& event = other[i];
    if (event.kind != spec::EventKind::move || event.cause == spec::Cause::pre_turn) continue;
    // A turn still to come takes the point along (19696#5 = 1).
    if (i + 1 < other.size() && other[i + 1].cause == spec::Cause::post_turn) continue;
    // Of the given events the place is named, where there is one.
    const std::size_t place = std::min(i, events.size() - 1);
    const auto programmed = xyz(c.setup.axes, event.programmed);
    const auto point = xyz(c.setup.axes, event.point);
    const auto axes = xyz(c.setup.axes, event.axes);
    if (!programmed || !point || !axes) continue;
    if (!fanuc) {
      const KlartextBlock* block = scene.klartext.block(event.line);
      if (block == nullptr || !event.space) continue;
      holding.zero(event.space->shift, place, "shift with deltas of zero");
      holding.zero(*axes - *point, place, "axes, less the tip, with deltas of zero");
      continue;
    }
    if (!scene.names_other_points())
      holding.zero(*point - *programmed, place, "point, less the programmed one, with offsets of zero");
    const std::size_t index = scene.program.index(event.line);
    if (index == scene.program.blocks().size()) continue;
    const int length = scene.program.blocks()[index].length;
    if (length != 434 && length != 435)
      holding.zero(*axes - *point, place, "axes, less the point, with offsets of zero");
  }
}

// A contour of compensated lines in one piece: the stops from start-up to the last before the cancelling move.
struct Contour {
  std::size_t first = 0;
  std::size_t cancel = 0;
};

std::optional<Contour> contour_of(const Scene& s) {
  const auto plain_line = [&](const Stop& stop) {
    const FanucBlock& b = s.block(stop);
    if (stop.own->type == spec::MoveType::arc || (b.motion != 0 && b.motion != 10) || !b.is_plain()) return false;
    // In the plane: Z-X for G18, Y-Z for G19.
    const std::size_t across = b.plane == 190 ? 0 : b.plane == 180 ? 1 : 2;
    bool moves = false;
    for (std::size_t i = 0; stop.displacement && i < 3; ++i)
      moves = moves || (i != across && certainly_not_zero(stop.displacement->at(i)));
    return moves;
  };
  for (std::size_t k = 1; k < s.stops.size(); ++k) {
    const FanucBlock& begun = s.block(s.stops[k]);
    if (s.stops[k].own->cause != spec::Cause::start_up || !begun.d || *begun.d == 0 || !plain_line(s.stops[k]))
      continue;
    if (begun.compensation != 410 && begun.compensation != 420) continue;
    for (std::size_t i = k + 1; i < s.stops.size(); ++i) {
      const Stop& stop = s.stops[i];
      const FanucBlock& b = s.block(stop);
      if (!plain_line(stop) || stop.block != s.stops[i - 1].block + 1 || b.plane != begun.plane || b.d != begun.d)
        break;
      if (stop.own->cause == spec::Cause::cancel && b.compensation == 400 && !b.has('I') && !b.has('J') &&
          !b.has('K')) {
        if (i > k + 1) return Contour{k, i};
        break;
      }
      if (stop.own->cause != spec::Cause::programmed || b.says_compensation()) break;
    }
  }
  return std::nullopt;
}

// "X10. Y-20. Z0."; nothing where a coordinate is no decimal.
std::optional<std::string> words_of(const Vector& point) {
  std::string text;
  for (std::size_t i = 0; i < point.size(); ++i) {
    constexpr int digits = 12;
    std::string number = point.at(i).decimal(digits);
    const auto read = spec::parse_decimal(number);
    if (!point.at(i).is_rational() || !read || rational(*read) != point.at(i).rational()) return std::nullopt;
    if (number.find('.') == std::string::npos) number += '.';
    text += std::string(" ") + "XYZ"[i] + number;
  }
  return text;
}

void reversed(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding) {
  if (c.setup.control != spec::Control::fanuc || !c.setup.bit(5008, 0) || c.setup.bit(5003, 1) ||
      c.setup.bit(5001, 2) || c.setup.cutter_compensation != spec::CutterCompensationType::c)
    return;
  if (const auto limit = c.setup.parameter(5010); limit && !limit->is_zero()) return;
  const Scene scene(c, events);
  if (scene.program.has_code({100, 200, 210, 280, 290, 300, 301, 370, 434, 435, 450, 460, 470, 480, 530, 920})) return;
  const auto contour = contour_of(scene);
  if (!contour) return;
  const FanucBlock& begun = scene.block(scene.stops[contour->first]);
  std::string text = "G90 G01 F100 G" + std::to_string(begun.plane / 10);
  for (std::size_t i = contour->cancel + 1; i-- + 1 > contour->first;) {
    const auto words = words_of(scene.stops[i].programmed);
    if (!words) return;
    if (i + 1 == contour->cancel) text += (begun.compensation == 410 ? "G42 D" : "G41 D") + std::to_string(*begun.d);
    if (i + 1 == contour->first) text += "G40";
    text += *words + '\n';
    if (i + 1 == contour->first) break;
  }
  spec::Case changed = c;
  changed.program = text;
  const std::vector<model::Event> other = run(changed);
  if (is_open(other)) return;
  const Scene image(changed, other);
  for (std::size_t i = contour->first; i < contour->cancel; ++i) {
    const std::vector<Head>& heads = scene.stops[i].heads;
    const std::size_t event = scene.stops[i].event;
    const std::size_t at = contour->cancel - i;
    holding.holds(at < image.stops.size() && image.stops[at].heads.size() == heads.size(), event,
                  "as many heads as at the corner of the reversed contour");
    if (at >= image.stops.size() || image.stops[at].heads.size() != heads.size()) return;
    for (std::size_t k = 0; k < heads.size(); ++k)
      holding.zero(heads[k].vector - image.stops[at].heads[heads.size() - 1 - k].vector, heads[k].event,
                   "head, less that of the reversed contour");
  }
}

std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h ^ h >> 32U;
}

}  // namespace

std::span<const std::string_view> changes() { return kNames; }

Verdict hold_changed(std::string_view law, const spec::Case& c, std::span<const model::Event> events,
                     const Runner& run) {
  const auto* const found = std::ranges::find(kNames, law);
  if (found == kNames.end()) throw std::invalid_argument("no law " + std::string(law));
  Holding holding(*found, events);
  if (events.empty()) return {};
  try {
    switch (found - kNames.begin()) {
      case 0:
        value_zero(c, events, run, holding);
        break;
      case 1:
        image(kMirror, c, events, run, holding);
        break;
      case 2:
        image(kQuarterTurn, c, events, run, holding);
        break;
      case 3:
        image(kTenth, c, events, run, holding);
        break;
      default:
        reversed(c, events, run, holding);
        break;
    }
  } catch (const exact::Undecided&) {
    return {holding.checks(), holding.violation(), 1};
  } catch (const spec::InputError&) {
    return {holding.checks(), holding.violation()};  // the changed setup is one no control could have
  }
  return {holding.checks(), holding.violation()};
}

Verdict hold_changed(const spec::Case& c, std::span<const model::Event> events, const Runner& run) {
  constexpr std::uint64_t share = 16;
  const std::uint64_t h = hash(c.program);
  if (h % share != 0) return {};
  return hold_changed(kNames.at(h / share % kNames.size()), c, events, run);
}

}  // namespace toolcomp::fuzz::laws
