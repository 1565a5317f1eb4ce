// SPDX-License-Identifier: Apache-2.0
#include "certify/block_words.h"

#include <fmt/format.h>

#include "model/basis/number.h"
#include "model/basis/print.h"

namespace toolcomp::certify {
namespace {

using exact::Rational;
using exact::Real;

std::string text(const Real& value, int digits) {
  std::string out;
  model::append_number(out, value, digits);
  return out;
}

// "X50 Y10 (vector X10 Y10)": the linear axes with a vector, or nothing where no axis has one.
std::string head(const model::Event& event, const spec::Axes& axes, int digits) {
  std::string point;
  std::string vector;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!event.point.has(i) || !event.programmed.has(i)) continue;
    const std::string part = text(event.point[i] - event.programmed[i], digits);
    if (part == "0") continue;
    vector += fmt::format("{}{}{}", vector.empty() ? "" : " ", axes.letter(i), part);
  }
  if (vector.empty()) return {};
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (event.point.has(i))
      point += fmt::format("{}{}{}", point.empty() ? "" : " ", axes.letter(i), text(event.point[i], digits));
  return fmt::format("{} (vector {})", point, vector);
}

}  // namespace

std::string corner_words(std::span<const model::Event> events, std::size_t own, const spec::Axes& axes, int digits) {
  std::string heads = head(events[own], axes, digits);
  std::size_t count = heads.empty() ? 0 : 1;
  std::uint64_t next = 0;
  for (std::size_t i = own + 1; i < events.size(); ++i) {
    if (events[i].kind != spec::EventKind::move) continue;
    // Under tool side compensation the corner moves up to the stop point belong to the block itself.
    const bool before_stop = events[i].line == events[own].line;
    if (!before_stop && next == 0) next = events[i].line;
    if (!before_stop && events[i].line != next) break;
    if (events[i].cause != spec::Cause::corner || events[i].arc) {
      if (before_stop) continue;
      break;
    }
    const std::string more = head(events[i], axes, digits);
    if (more.empty()) break;
    heads += (heads.empty() ? "" : ", ") + more;
    ++count;
  }
  if (count == 0) return {};
  const std::string to = next == 0 ? "the end" : fmt::format("line {}", next);
  return fmt::format("{} to {}: {}", count == 1 ? "one head" : fmt::format("{} heads", count), to, heads);
}

std::string measuring_words(const spec::Setup& setup, int digits) {
  const auto feed = setup.parameters.find({6241, -1});
  if (feed == setup.parameters.end()) return {};
  const Rational a_second = model::plain(feed->second) / 60;
  const std::string_view unit = setup.units == spec::Units::mm ? "mm" : "inch";
  return fmt::format(
      "at the measuring feed {0} {1}/min the position is off by {2} {1} at most (read every 2 ms), and the tool runs "
      "on "
      "by {3} {1} at most (stopped within 16 ms)",
      spec::to_string(feed->second), unit, text(a_second * Rational(2, 1000), digits),
      text(a_second * Rational(16, 1000), digits));
}

}  // namespace toolcomp::certify
