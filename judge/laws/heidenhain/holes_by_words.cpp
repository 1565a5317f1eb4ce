// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/heidenhain/holes_by_words.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "judge/laws/numbers.h"
#include "spec/language/byte_source.h"
#include "spec/language/heidenhain/klartext_reader.h"

namespace toolcomp::judge::laws {
namespace {

using spec::klartext::Block;
using spec::klartext::Parameter;
using spec::klartext::ParameterKind;
using spec::klartext::Statement;
using spec::klartext::Value;

constexpr std::string_view kLetters = spec::klartext::kAxisLetters;
constexpr std::uint32_t kDatumShift = 7;
constexpr std::uint32_t kPreset = 247;

bool is_line(const Block& b) { return b.statement == Statement::line || b.statement == Statement::line_with_vectors; }

// Members that a statement does not have keep what they held.
bool has_functions(const Block& b) {
  return is_line(b) || b.statement == Statement::stop || b.statement == Statement::miscellaneous;
}

bool ends_program(const Block& b) {
  return b.statement == Statement::end_program || (has_functions(b) && (b.has_function(2) || b.has_function(30)));
}

bool leaves_open(const model::Event& event) {
  return spec::ends_run(event.kind) || event.kind == spec::EventKind::undecided;
}

// Values of Q parameters, by the words.
class Parameters {
 public:
  void set(const Parameter& target, const std::optional<Rational>& value) {
    if (value)
      values_[key(target)] = *value;
    else
      values_.erase(key(target));
  }
  [[nodiscard]] std::optional<Rational> value(const Value& word) const {
    if (word.parameter.kind == ParameterKind::none) return rational(word.number);
    auto found = value(word.parameter);
    if (found && word.number.negative) *found = -*found;
    return found;
  }
  [[nodiscard]] std::optional<Rational> value(const Parameter& parameter) const {
    const auto found = values_.find(key(parameter));
    return found == values_.end() ? std::nullopt : std::optional(found->second);
  }
  // Those of a program called may be its own.
  void forget_local() {
    std::erase_if(values_, [](const auto& entry) { return entry.first.first == ParameterKind::ql; });
  }

 private:
  using Key = std::pair<ParameterKind, std::uint16_t>;
  static Key key(const Parameter& parameter) { return {parameter.kind, parameter.index}; }

  std::map<Key, Rational> values_;
};

class Follower {
 public:
  explicit Follower(const KlartextScene& scene) : scene_(scene), axes_(scene.c.setup.axes) {
    shift_.fill(Rational(0));
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      if (!spec::is_linear_axis(axes_.letter(i))) continue;
      const auto start = scene.c.setup.position.find(axes_.letter(i));
      at_.set(i, start == scene.c.setup.position.end() ? Real(0) : Real(rational(start->second)));
    }
  }

  KlartextHoles read() {
    spec::klartext::Reader reader(spec::text_source(scene_.c.program), scene_.c.setup, {.file = "program"});
    const auto block = std::make_unique<Block>();
    for (const KlartextBlock& k : scene_.klartext.blocks()) {
      if (!reader.next(*block)) break;
      if (next_ < scene_.events.size() && scene_.events[next_].line < k.line) break;
      const std::size_t first = next_;
      while (next_ < scene_.events.size() && scene_.events[next_].line == k.line) ++next_;
      follow(*block, k, first);
      if (ends_program(*block)) break;
    }
    return std::move(found_);
  }

 private:
  // The events of the block begin with `first`.
  void follow(const Block& b, const KlartextBlock& k, std::size_t first) {
    take_words(b);
    count(b, first);
    for (std::size_t i = first; i < next_; ++i) {
      const model::Event& event = scene_.events[i];
      if (event.kind == spec::EventKind::hole && event.hole) stand_at_hole(k, i);
      if (event.kind == spec::EventKind::move) stand_at_end(k, i);
    }
  }

  void take_words(const Block& b) {
    switch (b.statement) {
      case Statement::begin_program:
        if (b.unit != scene_.c.setup.units) at_ = {};  // of the setup
        break;
      case Statement::assignment:
        parameters_.set(b.target, parameters_.value(b.value));
        break;
      case Statement::cycle:
        take_cycle(b);
        break;
      case Statement::without_effect:
        forget_shift();
        break;
      case Statement::call_program:
        parameters_.forget_local();
        break;
      case Statement::tool_call:
      case Statement::correction_row:
      case Statement::reset_corrections:
        length_.reset();
        break;
      case Statement::line:
      case Statement::line_with_vectors:
        lead(b);
        break;
      default:
        break;
    }
  }

  void take_cycle(const Block& b) {
    for (std::size_t slot = 0; b.cycle == kDatumShift && slot < kLetters.size(); ++slot) {
      if (!b.has_axis(slot)) continue;
      std::optional<Rational>& shift = shift_.at(slot);
      const auto value = parameters_.value(b.axis.at(slot));
      if (!value || (b.is_incremental(slot) && !shift))
        shift.reset();
      else
        shift = b.is_incremental(slot) ? Rational(*shift + *value) : *value;
    }
    for (const spec::klartext::Assignment& each : b.cycle_values)
      parameters_.set(each.target, parameters_.value(each.value));
    if (b.cycle == kPreset) forget_shift();
  }

  void forget_shift() {
    for (auto& shift : shift_)
      if (shift && *shift != 0) shift.reset();
  }

  // Where the words of a line lead.
  void lead(const Block& b) {
    if (b.statement == Statement::line && (b.retraction != spec::klartext::Retraction::none || b.departs)) {
      at_ = {};
      return;
    }
    const bool of_machine = b.has_function(91) || b.has_function(92);
    for (std::size_t slot = 0; slot < kLetters.size(); ++slot) {
      const char letter = kLetters[slot];
      const std::size_t axis = axes_.index(letter);
      if (!b.has_axis(slot) || !spec::is_linear_axis(letter) || axis == spec::Axes::kNone) continue;
      const auto value = parameters_.value(b.axis.at(slot));
      const auto& shift = shift_.at(slot);
      if (value && b.is_incremental(slot) && at_.has(axis))
        at_.set(axis, at_[axis] + Real(*value));
      else if (value && !b.is_incremental(slot) && !of_machine && shift)
        at_.set(axis, Real(Rational(*value + *shift)));
      else
        at_.clear(axis);
    }
  }

  void count(const Block& b, std::size_t first) {
    const auto depth = parameters_.value(spec::klartext::kDepth);
    const bool may_drill = b.calls_cycle && (!depth || *depth != 0);
    const std::span<const model::Event> events = scene_.events.subspan(first, next_ - first);
    const auto holes =
        static_cast<std::uint64_t>(std::ranges::count(events, spec::EventKind::hole, &model::Event::kind));
    const bool ended = std::ranges::any_of(events, leaves_open) ||
                       (next_ == scene_.events.size() && spec::ends_run(scene_.events.back().kind));
    found_.blocks.push_back({std::min(first, scene_.events.size() - 1), holes, may_drill ? 1U : 0U,
                             may_drill && depth && !ended ? 1U : 0U});
  }

  void stand_at_hole(const KlartextBlock& k, std::size_t i) {
    const std::size_t axis = axes_.index(k.axis);
    using namespace spec::klartext;  // NOLINT(google-build-using-namespace): the names of the parameters
    found_.holes.push_back({i,
                            &k,
                            axis,
                            at_,
                            {parameters_.value(kSetUpClearance), parameters_.value(kDepth), parameters_.value(kSurface),
                             parameters_.value(kSecondClearance), shift_.at(kLetters.find(k.axis))},
                            length_});
    at_.set(axis, scene_.events[i].hole->level);
    hole_ = axis;
  }

  void stand_at_end(const KlartextBlock& k, std::size_t i) {
    const model::Event& event = scene_.events[i];
    if (hole_) found_.moves.push_back({i, *hole_, at_});
    hole_.reset();
    for (std::size_t axis = 0; axis < axes_.size(); ++axis)
      if (event.programmed.has(axis) && !at_.has(axis)) at_.set(axis, event.programmed[axis]);
    const std::size_t along = axes_.index(k.axis);
    if (!k.tcpm && event.axes.has(along) && event.point.has(along)) length_ = event.axes[along] - event.point[along];
  }

  const KlartextScene& scene_;
  const spec::Axes& axes_;
  Parameters parameters_;
  std::array<std::optional<Rational>, kLetters.size()> shift_;  // of the datum, by slot
  LinearPlaces at_;                                             // as programmed, from the preset
  std::optional<std::size_t> hole_;                             // no move since one along this axis
  std::optional<Real> length_;
  std::size_t next_ = 0;  // the first event that is not read
  KlartextHoles found_;
};

}  // namespace

KlartextHoles holes_by_words(const KlartextScene& scene) {
  const bool holes = std::ranges::any_of(scene.events, [](const model::Event& e) { return e.hole.has_value(); });
  const bool drills = std::ranges::any_of(scene.klartext.blocks(), &KlartextBlock::drills);
  if ((!holes && !drills) || scene.events.empty()) return {};
  return Follower(scene).read();
}

}  // namespace toolcomp::judge::laws
