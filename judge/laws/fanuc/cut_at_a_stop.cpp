// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "judge/laws/fanuc/changed.h"
#include "judge/laws/numbers.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/input_error.h"

namespace toolcomp::judge::laws {
namespace {

// Each one is a run of the model.
constexpr std::size_t kMostStops = 2;

bool has_code(const spec::Block& block, std::uint64_t code) {
  return std::ranges::any_of(block.words(), [code](const spec::Word& word) {
    return word.address == 'M' && word.value.digits == code && word.value.decimals == 0;
  });
}

// The lines of the first blocks with M00 or M01; none where lines do not tell blocks apart, or programs are called.
std::vector<std::uint64_t> stops_of(const spec::Case& c) {
  std::vector<std::uint64_t> stops;
  try {
    spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes, spec::reader_options(c.setup));
    const auto block = std::make_unique<spec::Block>();
    std::uint64_t latest = 0;
    while (reader.next(*block)) {
      if (block->line <= latest || has_code(*block, 98) || has_code(*block, 99)) return {};
      latest = block->line;
      if (block->alarm) break;
      if ((has_code(*block, 0) || has_code(*block, 1)) && stops.size() < kMostStops) stops.push_back(latest);
    }
  } catch (const spec::InputError&) {
    return {};
  }
  return stops;
}

void compare(const spec::Hole<Real>& hole, const spec::Hole<Real>& other, std::size_t event, Holding& holding) {
  holding.holds(hole.axis == other.axis, event, "the drilling axis before a stop, whatever follows");
  for (const auto member : {&spec::Hole<Real>::point_r, &spec::Hole<Real>::bottom, &spec::Hole<Real>::level})
    holding.zero(hole.*member - other.*member, event, "a level before a stop, less that with nothing after it");
}

std::string up_to_line(const std::string& text, std::uint64_t line) {
  std::size_t end = 0;
  for (; line > 0 && end < text.size(); --line) end = std::min(text.find('\n', end), text.size() - 1) + 1;
  return text.substr(0, end);
}

}  // namespace

void cut_at_a_stop(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding) {
  for (const std::uint64_t line : stops_of(c)) {
    spec::Case cut = c;
    cut.program = up_to_line(c.program, line);
    const std::vector<model::Event> other = run(cut);
    for (std::size_t i = 0; i < other.size(); ++i) {
      holding.holds(i < events.size() && is_alike(events[i], other[i]), i, "an event before a stop, whatever follows");
      if (i >= events.size()) return;
      const auto& point = events[i].point;
      const auto& without = other[i].point;
      for (std::size_t axis = 0; axis < c.setup.axes.size(); ++axis)
        if (point.has(axis) && without.has(axis))
          holding.zero(point[axis] - without[axis], i, "a point before a stop, less that with nothing after it");
      if (events[i].hole && other[i].hole) compare(*events[i].hole, *other[i].hole, i, holding);
    }
    holding.holds(events.size() <= other.size() || events[other.size()].line > line, other.size(),
                  "the events before a stop, whatever follows");
  }
}

bool stops_in_compensation(const spec::Case& c) {
  const auto has = [&c](std::string_view word) { return c.program.find(word) != std::string::npos; };
  return (has("M00") || has("M01")) && (has("G41") || has("G42"));
}

}  // namespace toolcomp::judge::laws
