// SPDX-License-Identifier: Apache-2.0
#include "cli/notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "fast/arithmetic/count.h"

namespace toolcomp::cli {
namespace {

constexpr std::uint64_t kMost = 3;  // of a kind that are told one by one

// What the notes of a kind are about, for the summary.
constexpr std::array<const char*, 7> kAbout{"compensation without a radius",
                                            "compensation with H",
                                            "G10 without R",
                                            "G53 under G91",
                                            "start-up moves shorter than the radius",
                                            "cutting without F",
                                            "moves that run against their programmed direction"};

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Of the ways from one place to another and from a third to a fourth; below 0: they run against each other.
double product(const std::array<double, 3>& from, const std::array<double, 3>& to, const std::array<double, 3>& from2,
               const std::array<double, 3>& to2) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (to.at(i) - from.at(i)) * (to2.at(i) - from2.at(i));
  return sum;
}

bool is_zero(const spec::Word* word) { return word != nullptr && word->value.is_zero(); }

}  // namespace

Notes::Notes(const spec::Setup& setup)
    : setup_(setup), axes_(setup.axes), radii_(setup), watches_(setup.control == spec::Control::fanuc) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto given = setup.position.find("XYZ"[i]);
    if (given != setup.position.end()) point_.at(i) = programmed_.at(i) = std::stod(spec::to_string(given->second));
  }
}

void Notes::add(Kind kind, std::uint64_t line, std::string text) {
  if (++count_.at(kind) <= kMost) waiting_.push_back({line, std::move(text)});
}

void Notes::read(const spec::Block& block) {
  if (!watches_ || block.alarm) return;
  const spec::Word* d = nullptr;
  const spec::Word* h = nullptr;
  const spec::Word* l = nullptr;
  const spec::Word* r = nullptr;
  bool axis = false;
  unsigned side = 0;
  bool data = false;
  bool machine = false;
  for (const spec::Word& word : block.words()) {
    const bool whole = word.value.decimals == 0;
    switch (word.address) {
      case 'D':
        d = &word;
        break;
      case 'H':
        h = &word;
        break;
      case 'L':
        l = &word;
        break;
      case 'R':
        r = &word;
        break;
      case 'F':
        feed_given_ = feed_given_ || !word.value.is_zero();
        break;
      case 'G':
        if (!whole) break;
        if (word.value.digits <= 3) cutting_ = word.value.digits != 0;
        if (word.value.digits == 90 || word.value.digits == 91) incremental_ = word.value.digits == 91;
        if (word.value.digits == 41 || word.value.digits == 42) side = static_cast<unsigned>(word.value.digits);
        data = data || word.value.digits == 10;
        machine = machine || word.value.digits == 53;
        break;
      default:
        axis = axis || axes_.has(word.address);
    }
  }
  if (d != nullptr) d_given_ = !d->value.is_zero();
  if (side != 0 && !setup_.bit(5001, 2)) {
    if (d == nullptr && h != nullptr && !is_zero(h))
      add(kRadiusByH, block.line, fmt::format("G{} with H: the radius is that of D, unless 5001#2 (OFH) is 1", side));
    else if (!d_given_)
      add(kNoRadius, block.line, fmt::format("G{} without a D other than 0: the radius is 0", side));
  }
  const bool origin = l != nullptr && l->value.decimals == 0 && (l->value.digits == 2 || l->value.digits == 20);
  if (data && !origin && r == nullptr) add(kG10, block.line, "G10 without R");
  if (machine && incremental_) add(kMachine, block.line, "G53 under G91 is ignored, together with its axis words");
  if (!data && axis && cutting_ && !feed_given_) {
    const auto at_start = setup_.parameter(1411);
    if (at_start && !at_start->is_zero())
      add(kFeed, block.line, fmt::format("no F yet: the feed is {}, from parameter 1411", spec::to_string(*at_start)));
    feed_given_ = true;
  }
}

void Notes::moved(std::uint64_t line, spec::Cause cause, spec::MoveType type, const Place& programmed,
                  const Place& point) {
  const Place from = std::exchange(programmed_, programmed);
  const Place tool = std::exchange(point_, point);
  if (!watches_ || type == spec::MoveType::arc) return;
  const double along = product(from, programmed, tool, point);
  // Most moves run forward, and their lengths are asked of none.
  if (cause != spec::Cause::start_up && along >= 0) return;
  const double way = distance(from, programmed);
  const double radius = distance(programmed, point);
  constexpr double kNothing = 0.001;  // of the setup's units: less is not worth a word
  if (cause == spec::Cause::start_up && way > kNothing && way < radius - kNothing)
    add(kShort, line, fmt::format("the start-up move of {:.6g} is shorter than the radius {:.6g}", way, radius));
  if (cause != spec::Cause::programmed || way < kNothing || distance(from, tool) < kNothing) return;
  if (along < -kNothing * way)
    add(kBackwards, line,
        fmt::format("the tool runs {:.6g} against the programmed direction in this block", -along / way));
}

bool Notes::passes(fast::LineMoves& moves) {
  if (!watches_) return true;
  if (moves.event.cause != spec::Cause::programmed) return false;
  const auto [programmed, point] = places(moves.at(0), std::identity());
  if (product(programmed_, programmed, point_, point) < 0) return false;
  if (moves.by_vector && run_back(moves, programmed, point)) return false;
  const spec::Event<double>& last = moves.at(moves.size - 1);
  radii_.on(last, std::identity());
  std::tie(programmed_, point_) = places(last, std::identity());
  return true;
}

// Whether a move but the first runs against its programmed direction: as in moved(), all of them side by side.
bool Notes::run_back(const fast::LineMoves& moves, const Place& programmed, const Place& point) const {
  constexpr auto kPerOne = static_cast<double>(fast::Count::kSmallPerOne);
  std::array<double, fast::LineChunk::kMost + 1> along{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = axes_.index("XYZ"[i]);
    if (axis == spec::Axes::kNone || (moves.moving >> axis & 1U) == 0 || moves.word.at(axis) == nullptr) continue;
    double from = programmed.at(i) * kPerOne;
    double tool = point.at(i);
    for (std::size_t k = 1; k < moves.size; ++k) {
      const double to = moves.word.at(axis)[moves.line_of(k)];
      const double tool_to = moves.sent.at(axis)[k];
      along.at(k) += (to - from) * (tool_to - tool);
      from = to;
      tool = tool_to;
    }
  }
  return std::ranges::any_of(along, [](double each) { return each < 0; });
}

std::vector<Note> Notes::take() { return std::exchange(waiting_, {}); }

std::vector<Note> Notes::summary() const {
  std::vector<Note> all;
  for (std::size_t kind = 0; kind < kKinds; ++kind)
    if (count_.at(kind) > kMost)
      all.push_back({0, fmt::format("{} more notes on {}", count_.at(kind) - kMost, kAbout.at(kind))});
  if (radii_.first_line() != 0) all.push_back({radii_.first_line(), radii_.text()});
  return all;
}

}  // namespace toolcomp::cli
