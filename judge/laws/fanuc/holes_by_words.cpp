// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/holes_by_words.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>

#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

// The axes go elsewhere than words say, or words name a place.
bool goes_elsewhere(const FanucBlock& b) {
  constexpr std::array kCodes{kG28, kG29, kG30, kG30_1, kG31, kG37, kG39, kG52, kG53, kG92};
  return std::ranges::any_of(kCodes, [&b](int code) { return b.has_code(code); });
}

bool ends_program(const FanucBlock& b) {
  return std::ranges::any_of(
      b.words, [](const spec::Word& w) { return w.address == 'M' && (w.value.digits == 2 || w.value.digits == 30); });
}

bool is_end_of_block(const model::Event& event) {
  return event.kind == spec::EventKind::move &&
         (event.cause == spec::Cause::programmed || event.cause == spec::Cause::start_up ||
          event.cause == spec::Cause::cancel);
}

bool leaves_open(const model::Event& event) {
  return spec::ends_run(event.kind) || event.kind == spec::EventKind::undecided;
}

bool is_known_zero(const Places& values, std::size_t axis) {
  return values.has(axis) && !certainly_not_zero(values[axis]);
}

class Follower {
 public:
  explicit Follower(const FanucScene& scene)
      : scene_(scene),
        axes_(scene.c.setup.axes),
        compensates_(
            std::ranges::any_of(scene.program.blocks(), [](const FanucBlock& b) { return b.compensation != kG40; })),
        may_shift_(compensates_ || scene.program.has_code({kG45, kG46, kG47, kG48})) {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const auto start = scene.c.setup.position.find(axes_.letter(i));
      at_.set(i, start == scene.c.setup.position.end() ? Real(0) : Real(rational(start->second)));
      if (is_linear(i)) shift_.set(i, Real(0));
    }
  }

  HolesByWords read() {
    const auto& blocks = scene_.program.blocks();
    for (std::size_t k = 0; k < blocks.size() && !ends_program(blocks[k]); ++k) {
      if (next_ < scene_.events.size() && scene_.events[next_].line < blocks[k].line) break;
      const std::size_t first = next_;
      while (next_ < scene_.events.size() && scene_.events[next_].line == blocks[k].line) ++next_;
      follow(k, first);
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool is_linear(std::size_t axis) const { return spec::is_linear_axis(axes_.letter(axis)); }

  // The block with this index; its events begin with `first`.
  void follow(std::size_t k, std::size_t first) {
    const FanucBlock& b = scene_.program.blocks()[k];
    const bool alone = scene_.program.index(b.line) == k;
    if (!alone || goes_elsewhere(b)) {
      forget();
      shifts_ = !may_shift_;
      return;
    }
    if (scene_.program.renames_at(k)) forget();
    if (b.drilling && b.drilling->begun == k) initial_level_ = level_before(axes_.index(b.drilling->axis));
    const bool clear = !b.drilling || b.drilling->clear;
    if (clear) count(b, first);
    if (clear && b.drills)
      follow_holes(k, first);
    else
      follow_moves(b, first, clear);
  }

  void forget() {
    at_ = {};
    initial_level_.reset();
    behind_hole_ = false;
  }

  [[nodiscard]] std::optional<Real> level_before(std::size_t axis) const {
    if (axis == spec::Axes::kNone || !at_.has(axis) || !shifts_ || !is_known_zero(shift_, axis)) return std::nullopt;
    return at_[axis];
  }

  void count(const FanucBlock& b, std::size_t first) {
    const std::optional<std::uint64_t> times = b.drills ? b.repeats() : std::uint64_t{0};
    const std::span<const model::Event> events = scene_.events.subspan(first, next_ - first);
    const auto holes =
        static_cast<std::uint64_t>(std::ranges::count(events, spec::EventKind::hole, &model::Event::kind));
    const bool ended = std::ranges::any_of(events, leaves_open) || (next_ == scene_.events.size() && !ran_through());
    const std::uint64_t most = times.value_or(std::numeric_limits<std::uint64_t>::max());
    found_.blocks.push_back(
        {first < scene_.events.size() ? first : scene_.events.size() - 1, holes, most, ended ? 0 : times.value_or(0)});
  }

  [[nodiscard]] bool ran_through() const {
    return scene_.program.complete() && std::ranges::none_of(scene_.events, leaves_open);
  }

  // Where the words of the block lead. Of a word that stands twice nobody knows.
  [[nodiscard]] Places led_by(const FanucBlock& b) const {
    Places to = at_;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const char letter = axes_.letter(i);
      const spec::Decimal* const word = b.value(letter);
      if (word == nullptr) continue;
      to.clear(i);
      if (std::ranges::count(b.words, letter, &spec::Word::address) > 1) continue;
      // Of degrees in least increments nothing is known here.
      if (!is_linear(i) && !word->point && !scene_.c.setup.bit(3401, 0, true)) continue;
      const Real value = is_linear(i) ? Real(length_of(scene_.c.setup, b.inches, *word)) : Real(rational(*word));
      if (b.absolute)
        to.set(i, value);
      else if (at_.has(i))
        to.set(i, at_[i] + value);
    }
    return to;
  }

  void follow_holes(std::size_t k, std::size_t first) {
    const FanucBlock& b = scene_.program.blocks()[k];
    bool drilled = false;
    for (std::size_t i = first; i < next_; ++i) {
      const model::Event& event = scene_.events[i];
      if (event.kind != spec::EventKind::hole || !event.hole) continue;
      drilled = true;
      Places to = led_by(b);
      if (const std::size_t axis = axes_.index(b.drilling->axis); axis != spec::Axes::kNone) to.clear(axis);
      found_.holes.push_back({i, k, to, shift_, shifts_, initial_level_});
      stand_at_hole(event);
      if (!initial_level_ && !b.to_point_r) initial_level_ = event.hole->level;
    }
    // K0 moves nothing.
    if (!drilled && b.repeats() != 0) forget_places(b);
  }

  void stand_at_hole(const model::Event& event) {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      at_.clear(i);
      if (!is_linear(i)) {
        if (event.axes.has(i)) at_.set(i, event.axes[i]);
      } else if (i == event.hole->axis) {
        if (shifts_ && is_known_zero(shift_, i)) at_.set(i, event.hole->level);
      } else if (shifts_ && event.point.has(i)) {
        at_.set(i, event.point[i] - shift_[i]);
      }
    }
    behind_hole_ = true;
  }

  void follow_moves(const FanucBlock& b, std::size_t first, bool clear) {
    const Places to = led_by(b);
    bool stands = false;
    for (std::size_t i = first; i < next_; ++i) {
      const model::Event& event = scene_.events[i];
      if (event.kind == spec::EventKind::hole && event.hole) {
        stand_at_hole(event);
        stands = true;
      }
      if (!is_end_of_block(event)) continue;
      const bool last = std::none_of(scene_.events.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                     scene_.events.begin() + static_cast<std::ptrdiff_t>(next_), is_end_of_block);
      if (last && clear && behind_hole_) found_.ends.push_back({i, to});
      if (last) stand_at_end(event);
      stands = true;
    }
    if (!stands) forget_places(b);
  }

  // Those that a block names which has no event: its run may have ended, or been left open.
  void forget_places(const FanucBlock& b) {
    for (std::size_t i = 0; i < axes_.size(); ++i)
      if (b.has(axes_.letter(i))) at_.clear(i);
  }

  void stand_at_end(const model::Event& event) {
    shifts_ = true;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      at_.clear(i);
      const Places& places = is_linear(i) ? event.programmed : event.axes;
      if (places.has(i)) at_.set(i, places[i]);
      if (!is_linear(i) || !may_shift_) continue;
      if (!event.programmed.has(i) || !event.point.has(i)) {
        shifts_ = false;
        continue;
      }
      shift_.set(i, event.point[i] - event.programmed[i]);
      // A vector of compensation is none of G45 to G48.
      if (compensates_ && certainly_not_zero(shift_[i])) shifts_ = false;
    }
    behind_hole_ = false;
  }

  const FanucScene& scene_;
  const spec::Axes& axes_;
  bool compensates_;
  bool may_shift_;  // a vector may stand between the commanded place and that of the tool
  Places at_;       // commanded
  Places shift_;    // from there to the axes, before length offset
  bool shifts_ = true;
  bool behind_hole_ = false;
  std::optional<Real> initial_level_;
  std::size_t next_ = 0;  // the first event that is not read
  HolesByWords found_;
};

}  // namespace

HolesByWords holes_by_words(const FanucScene& scene) {
  const bool holes = std::ranges::any_of(scene.events, [](const model::Event& e) { return e.hole.has_value(); });
  if ((!holes && !scene.program.drills()) || scene.events.empty() || scene.program.has_code({kG43_4, kG43_5}))
    return {};
  return Follower(scene).read();
}

}  // namespace toolcomp::judge::laws
