// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "judge/oracle/number.h"
#include "spec/language/alarm.h"
#include "spec/language/event_names.h"
#include "spec/language/naming_clause.h"

namespace toolcomp::judge {
namespace {

using exact::Rational;
using exact::Real;
using spec::EventKind;
using spec::name;

constexpr double kHalfTurn = 180;  // degrees

std::string text_of(const std::optional<std::uint64_t>& n) { return n ? fmt::format("{}", *n) : "none"; }

// What an alarm shows, with its cause where the other shows the same.
template <class Event, class Other>
std::string shown(const Event& event, const Other& other) {
  std::string number(event.number.view());
  if (event.alarm == spec::AlarmCause::none || event.number != other.number) return number;
  return fmt::format("{} ({})", number, info(event.alarm).name);
}

std::string text_of(const spec::PermittedOutcomes& outcomes) {
  std::string text;
  const auto add = [&text](bool permitted, std::string_view outcome) {
    if (permitted) text += fmt::format("{}{}", text.empty() ? "" : ", ", outcome);
  };
  add(outcomes.positive, "positive");
  add(outcomes.negative, "negative");
  add(outcomes.tie, "tie");
  return text.empty() ? "none" : text;
}

// What a number measures.
enum class Measure : std::uint8_t { length, angle, direction, other };

constexpr double kRadiansPerDegree = 0.017453292519943295;

// Names a field; text is made only for a difference.
struct Path {
  std::string_view field;
  char letter = 0;  // of an axis
  int index = -1;   // of an array

  [[nodiscard]] std::string text() const {
    if (letter != 0) return fmt::format("{}.{}", field, letter);
    return index >= 0 ? fmt::format("{}[{}]", field, index) : std::string(field);
  }
};

// The comparison of one pair of events. Every step returns true once a difference is found.
template <class Number>
class Comparison {
 public:
  Comparison(const Rules& rules, const model::Event& expected, Scale scale, const spec::Event<Number>& actual,
             Tally& tally)
      : rules_(rules), expected_(expected), actual_(actual), tally_(tally), scale_(std::move(scale)) {}

  std::optional<Difference> run() {
    if (event()) {
      difference_.line = expected_.line;
      difference_.clauses = expected_.clauses;
      difference_.clause = spec::naming_clause(expected_.clauses);
      // The cause of a move comes with the clause applied last.
      if (difference_.kind == "cause" && !expected_.clauses.empty()) difference_.clause = expected_.clauses.back();
      return difference_;
    }
    return std::nullopt;
  }

 private:
  bool event() {
    if (expected_.kind != actual_.kind)
      return differ("kind", "kind", std::string(name(expected_.kind)), std::string(name(actual_.kind)));
    // Alarms first by what they are: "PS5408 instead of PS5407" says more than a line. The cause counts where the
    // controller names it, else the number.
    const bool by_cause = expected_.alarm != spec::AlarmCause::none && actual_.alarm != spec::AlarmCause::none;
    const bool numbered = spec::ends_run(expected_.kind) || expected_.kind == EventKind::warning ||
                          expected_.kind == EventKind::undecided;
    if (numbered && rules_.judges("number")) {
      ++tally_.values;
      if (by_cause ? expected_.alarm != actual_.alarm : expected_.number != actual_.number)
        return differ(std::string(name(expected_.kind)), "number", shown(expected_, actual_),
                      shown(actual_, expected_));
    }
    if (expected_.line != actual_.line)
      return differ("line", "line", fmt::format("{}", expected_.line), fmt::format("{}", actual_.line));
    if (rules_.judges("reason") && expected_.out_of_scope != actual_.out_of_scope)
      return differ("undecided", "reason", expected_.out_of_scope ? "OUT_OF_SCOPE" : "none",
                    actual_.out_of_scope ? "OUT_OF_SCOPE" : "none");
    if (rules_.judges("permitted") && expected_.permitted != actual_.permitted)
      return differ("undecided", "permitted", text_of(expected_.permitted), text_of(actual_.permitted));
    if (rules_.judges("n") && expected_.n != actual_.n)
      return differ("sequence number", "n", text_of(expected_.n), text_of(actual_.n));
    switch (expected_.kind) {
      case EventKind::move:
        return move();
      case EventKind::sample:
        return sample();
      case EventKind::setting:
        return setting();
      case EventKind::hole:
        return hole();
      case EventKind::alarm:
      case EventKind::warning:
      case EventKind::undecided:
      case EventKind::not_supported:
      case EventKind::not_judged:
        return false;
    }
    return false;
  }

  bool move() {
    return named("cause", expected_.cause, actual_.cause) || named("type", expected_.type, actual_.type) ||
           table("programmed", expected_.programmed, actual_.programmed, kProgrammed) ||
           table("point", expected_.point, actual_.point) || table("axes", expected_.axes, actual_.axes) ||
           table("machine", expected_.machine, actual_.machine) || unknown() || tool_axis() || space() || arc() ||
           feed();
  }

  bool unknown() {
    return rules_.judges("unknown") && expected_.unknown != actual_.unknown &&
           differ("unknown position", "unknown", letters_of(expected_.unknown), letters_of(actual_.unknown));
  }
  [[nodiscard]] std::string letters_of(std::uint16_t axes) const {
    std::string letters;
    for (std::size_t i = 0; i < rules_.axes().size(); ++i)
      if ((axes >> i & 1U) != 0) letters += rules_.axes().letter(i);
    return letters.empty() ? "none" : letters;
  }

  // 3D tool compensation. Fields that only one of the two has are judged one by one.
  bool space() {
    if (expected_.unknown != 0) return false;  // whoever knows the limits of travel may say more
    const auto* const e = expected_.space ? &*expected_.space : nullptr;
    const auto* const a = actual_.space ? &*actual_.space : nullptr;
    const auto* const ec = e != nullptr && e->contact ? &*e->contact : nullptr;
    const auto* const ac = a != nullptr && a->contact ? &*a->contact : nullptr;
    return lengths("tool_center", e != nullptr ? &e->tool_center : nullptr, a != nullptr ? &a->tool_center : nullptr) ||
           lengths("contact", ec != nullptr ? &ec->point : nullptr, ac != nullptr ? &ac->point : nullptr) ||
           normal(ec, ac) || lengths("shift", e != nullptr ? &e->shift : nullptr, a != nullptr ? &a->shift : nullptr) ||
           lengths("tool_shift", e != nullptr ? &e->tool_shift : nullptr, a != nullptr ? &a->tool_shift : nullptr) ||
           lengths("carrier", e != nullptr && e->carrier ? &*e->carrier : nullptr,
                   a != nullptr && a->carrier ? &*a->carrier : nullptr) ||
           angle(ec, ac) || flat(ec, ac);
  }

  bool lengths(std::string_view field, const std::array<Real, 3>* e, const std::array<Number, 3>* a) {
    if (!rules_.judges(field) || absent({field}, e != nullptr, a != nullptr)) return found_;
    if (e == nullptr) return false;
    std::array<double, 3> off{};
    if (!scale_.heads.empty())
      for (std::size_t i = 0; i < 3; ++i) off.at(i) = signed_distance((*e)[i], (*a)[i]);
    const bool by_conditions = !scale_.heads.empty() && placed(off);
    for (std::size_t i = 0; i < 3; ++i)
      if (by_conditions)
        by_condition();
      else if (number("coordinate", {field, "XYZ"[i]}, (*e)[i], (*a)[i], rules_.budget().coordinate, head_unit(),
                      Measure::length))
        return true;
    return false;
  }

  bool normal(const spec::Contact<Real>* e, const spec::Contact<Number>* a) {
    if (!rules_.judges("normal") || absent({"normal"}, e != nullptr, a != nullptr)) return found_;
    if (e == nullptr) return false;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (number("normal", {"normal", 0, i}, e->normal[at], a->normal[at], rules_.budget().tool_axis, policy::ulp(1),
                 Measure::direction))
        return true;
    }
    return false;
  }

  bool angle(const spec::Contact<Real>* e, const spec::Contact<Number>* a) {
    const bool expected = e != nullptr && e->angle;
    if (!rules_.judges("angle") || absent({"angle"}, expected, a != nullptr && a->angle)) return found_;
    return expected && number("angle", {"angle"}, *e->angle, *a->angle, rules_.budget().sweep, policy::ulp(kHalfTurn),
                              Measure::angle);
  }

  bool flat(const spec::Contact<Real>* e, const spec::Contact<Number>* a) {
    if (!rules_.judges("flat")) return false;
    const bool expected = e != nullptr && e->flat;
    return expected != (a != nullptr && a->flat) &&
           differ("flat", "flat", expected ? "true" : "absent", expected ? "absent" : "true");
  }

  bool sample() {
    if (rules_.judges("t") &&
        (expected_.t_numerator != actual_.t_numerator || expected_.t_denominator != actual_.t_denominator))
      return differ("sample", "t", fmt::format("{}/{}", expected_.t_numerator, expected_.t_denominator),
                    fmt::format("{}/{}", actual_.t_numerator, actual_.t_denominator));
    const double start = scale_.start;
    return table("point", expected_.point, actual_.point, start) ||
           table("axes", expected_.axes, actual_.axes, start) || tool_axis();
  }

  bool hole() {
    return table("point", expected_.point, actual_.point) ||
           level("r", &spec::Hole<Real>::point_r, &spec::Hole<Number>::point_r) ||
           level("bottom", &spec::Hole<Real>::bottom, &spec::Hole<Number>::bottom) ||
           level("return", &spec::Hole<Real>::level, &spec::Hole<Number>::level) ||
           table("axes", expected_.axes, actual_.axes);
  }

  bool level(std::string_view field, Real spec::Hole<Real>::* e, Number spec::Hole<Number>::* a) {
    if (!rules_.judges(field) || absent({field}, expected_.hole.has_value(), actual_.hole.has_value())) return found_;
    return expected_.hole && number("coordinate", {field}, (*expected_.hole).*e, (*actual_.hole).*a,
                                    rules_.budget().coordinate, length_unit(), Measure::length);
  }

  bool setting() {
    if (rules_.judges("name") && expected_.setting != actual_.setting)
      return differ("setting", "name", std::string(expected_.setting.view()), std::string(actual_.setting.view()));
    return rules_.judges("value") && converted("setting", {"value"}, expected_.value, actual_.value);
  }

  bool tool_axis() {
    if (!rules_.judges("tool_axis") ||
        absent({"tool_axis"}, expected_.tool_axis.has_value(), actual_.tool_axis.has_value()))
      return found_;
    if (!expected_.tool_axis) return false;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (number("tool axis", {"tool_axis", 0, i}, (*expected_.tool_axis)[at], (*actual_.tool_axis)[at],
                 rules_.budget().tool_axis, std::max(policy::ulp(1), scale_.pose.direction), Measure::direction))
        return true;
    }
    return false;
  }

  bool arc() {
    const bool any = rules_.judges("center") || rules_.judges("plane") || rules_.judges("direction") ||
                     rules_.judges("sweep") || rules_.judges("radius");
    if (!any || absent({"center"}, expected_.arc.has_value(), actual_.arc.has_value())) return found_;
    if (!expected_.arc) return false;
    const spec::Arc<Real>& e = *expected_.arc;
    const spec::Arc<Number>& a = *actual_.arc;
    if (named("plane", e.plane, a.plane) || named("direction", e.direction, a.direction) ||
        table("center", e.center, a.center, kCenter))
      return true;
    if (rules_.judges("radius")) {
      const bool same = e.radius.has_value() == a.radius.has_value();
      if (!same && !radii_agree(e.radius) && !radii_agree(a.radius))
        return absent({"radius"}, e.radius.has_value(), a.radius.has_value());
      if (same && e.radius &&
          (radius(0, e.radius->first, a.radius->first, scale_.start) || radius(1, e.radius->second, a.radius->second)))
        return true;
    }
    if (rules_.judges("sweep")) {
      constexpr double degrees = 57.29577951308232;  // in a radian
      const double own = own_head_unit(rules_.budget().sweep) + scale_.center;
      const double turn = scale_.by_own_heads ? scale_.own_turn * own : scale_.turn;
      const double unit = policy::ulp(360) + degrees * turn;
      if (rules_.budget().sweep * unit >= policy::kUnknownSweep) {
        if (expected_.arc->sweep) ++tally_.wide;
        return false;
      }
      if (absent({"sweep"}, e.sweep.has_value(), a.sweep.has_value())) return true;
      if (e.sweep && number("sweep", {"sweep"}, *e.sweep, *a.sweep, rules_.budget().sweep, unit, Measure::angle))
        return true;
    }
    return false;
  }

  bool feed() {
    if (!rules_.judges("feed") || absent({"feed"}, expected_.feed.has_value(), actual_.feed.has_value())) return found_;
    return expected_.feed && converted("feed", {"feed"}, *expected_.feed, *actual_.feed);
  }

  // `error` as in length_unit. A rotary axis of the machine is the sum of its position and an origin.
  bool table(std::string_view field, const spec::AxisValues<Real>& e, const spec::AxisValues<Number>& a,
             double error = 0) {
    if (!rules_.judges(field)) return false;
    const bool head = error >= 0;
    const bool by_conditions = head && placed(e, a, error);
    const double unit = head ? head_unit(error) : programmed_unit() + (error == kCenter ? scale_.center : 0);
    for (std::size_t i = 0; i < rules_.axes().size(); ++i) {
      const char letter = rules_.axes().letter(i);
      if ((!e.has(i) && !a.has(i)) || (expected_.unknown >> i & 1U) != 0) continue;
      const Path path{field, letter};
      if (absent(path, e.has(i), a.has(i))) return true;
      if (!spec::is_linear_axis(letter)) {
        if (number("coordinate", path, e[i], a[i], rules_.budget().rotary,
                   policy::ulp(rotary_scale(e, i)) + scale_.pose.rotary.at(i), Measure::angle))
          return true;
      } else if (by_conditions && letter >= 'X') {
        by_condition();
      } else if (number("coordinate", path, e[i], a[i], rules_.budget().coordinate, unit, Measure::length)) {
        return true;
      }
    }
    return false;
  }

  // Whether X Y Z, in whatever frame parallel to that of the point, lie where two conditions place a head (head.h). Not
  // asked where each is near enough by itself.
  [[nodiscard]] bool placed(const spec::AxisValues<Real>& e, const spec::AxisValues<Number>& a, double error) const {
    if (scale_.heads.empty()) return false;
    std::array<double, 3> off{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t axis = rules_.axes().index("XYZ"[i]);
      if (axis == spec::Axes::kNone) continue;
      if (!e.has(axis) || !a.has(axis)) return false;
      off.at(i) = signed_distance(e[axis], a[axis]);
    }
    return placed(off, error);
  }
  [[nodiscard]] bool placed(const std::array<double, 3>& off, double error = 0) const {
    const double k = rules_.budget().coordinate;
    const auto near = [&](double x) { return std::fabs(x) <= k * head_unit(error) + rules_.resolution(); };
    if (std::ranges::all_of(off, near)) return false;
    const double size = std::hypot(off[0], off[1], off[2]);
    const double rounded = 2 * rules_.resolution();
    const auto within = [&](const HeadBand& band) {
      const double out = off[0] * band.normal[0] + off[1] * band.normal[1] + off[2] * band.normal[2];
      return std::fabs(out) <= k * (band.width + error) + band.curvature * size * size + rounded;
    };
    return std::ranges::any_of(scale_.heads, [&](const Head& head) {
      return size <= k * head.reach + rounded && within(head.bands[0]) && within(head.bands[1]) && within(head.across);
    });
  }

  // A value judged by conditions: the width of the narrowest pair is what it was granted.
  void by_condition() {
    double width = std::numeric_limits<double>::infinity();
    for (const Head& head : scale_.heads) width = std::min(width, std::max(head.bands[0].width, head.bands[1].width));
    count(moves(rules_.budget().coordinate * width, Measure::length));
  }

  [[nodiscard]] double rotary_scale(const spec::AxisValues<Real>& values, std::size_t axis) const {
    const double value = std::fabs(approximate(values[axis]));
    return expected_.axes.has(axis) ? std::max(value, std::fabs(approximate(expected_.axes[axis]))) : value;
  }

  // What is programmed has no part in the compensation, but may once have been made of axes.
  static constexpr double kProgrammed = -1;
  // The same of the centre of an arc, but for what R makes of it.
  static constexpr double kCenter = -2;
  [[nodiscard]] double programmed_unit() const {
    return policy::ulp(scale_.position) + scale_.carried / rules_.budget().coordinate;
  }

  // The same of what holds a head, where its two conditions judge what is farther off.
  [[nodiscard]] double head_unit(double error = 0) const {
    if (scale_.heads.empty()) return length_unit(error);
    return programmed_unit() + std::max(scale_.rest * (scale_.vector > 0 ? policy::ulp(scale_.vector) : 0), error);
  }

  // Of which lengths may be off k. `error`: of what else the length is made of.
  [[nodiscard]] double length_unit(double error = 0) const {
    const double own = scale_.condition * (scale_.vector > 0 ? policy::ulp(scale_.vector) : 0);
    return programmed_unit() + scale_.pose.tip + std::max(own, error);
  }

  // Of a head as the controller tells it, with this k: rounded to its resolution.
  [[nodiscard]] double own_head_unit(double k) const {
    return programmed_unit() + scale_.pose.tip + rules_.resolution() / k;
  }

  bool radius(int index, const Real& e, const Number& a, double error = 0) {
    const double head = scale_.by_own_heads ? own_head_unit(rules_.budget().coordinate) : length_unit(error);
    const double unit = head + scale_.center;
    return number("coordinate", {"radius", 0, index}, e, a, rules_.budget().coordinate, unit, Measure::length);
  }

  // Whether the two radii of an arc are so near that they may as well be one.
  template <class Length>
  bool radii_agree(const std::optional<std::pair<Length, Length>>& radii) const {
    if (!radii) return false;
    double apart = 0;
    if constexpr (std::is_same_v<Length, double>)
      apart = std::fabs(radii->second - radii->first);
    else
      apart = std::fabs(approximate(Real(radii->second) - Real(radii->first)));
    const double unit = length_unit() + length_unit(scale_.start) + 2 * scale_.center;
    return apart <= rules_.budget().coordinate * unit + 2 * rules_.resolution();
  }

  // A number of the program, at most converted to the units of the setup.
  bool converted(std::string_view kind, const Path& path, const Real& e, const Number& a) {
    if constexpr (!std::is_same_v<Number, double>) {
      const exact::DoubleEnclosure doubles = e.double_enclosure();
      if (doubles.lower < doubles.upper)
        return number(kind, path, e, a, policy::kConvertedText, policy::ulp(approximate(e)));
    }
    return number(kind, path, e, a, 0);
  }

  // In micrometres.
  [[nodiscard]] double moves(double width, Measure measure) const {
    switch (measure) {
      case Measure::length:
        return width * rules_.um_per_unit();
      case Measure::angle:
        return width * kRadiansPerDegree * policy::kMicrometresAtOneMetre;
      case Measure::direction:
        return width * policy::kMicrometresAtOneMetre;
      case Measure::other:
        return 0;
    }
    return 0;
  }

  // What a compensation vector is, or ends an arc with, is the business of the section that makes it.
  [[nodiscard]] bool has_vector() const {
    return scale_.vector > 0 || scale_.start > policy::ulp(1) * policy::kNoVector || !scale_.heads.empty();
  }

  // A number that is granted that much.
  void count(double granted_um) {
    tally_.widths.add(granted_um, scale_.pose.hardly || has_vector());
    if (!(granted_um <= rules_.cap_um())) {
      ++tally_.wide;
    } else {
      ++tally_.values;
      ++tally_.numbers;
    }
  }

  // What the controller's rounding grants a number that lies that far outside its enclosure.
  double rounded_off(const Real& e, const Number& a, double distance, Measure measure) {
    const double r = resolution_of(measure);
    if (r == 0) return 0;
    const double off = std::copysign(distance, signed_distance(e, a));
    if (measure == Measure::length && distance <= r) tally_.bias.add(off * rules_.um_per_unit());
    return judge::rounded_off(rules_.rounding(), r, approximate(e), off);
  }

  [[nodiscard]] double resolution_of(Measure measure) const {
    switch (measure) {
      case Measure::angle:
        return rules_.angle_resolution();
      case Measure::direction:
        return rules_.vector_resolution();
      case Measure::length:
      case Measure::other:
        break;
    }
    return rules_.resolution();
  }

  // k·unit (and what the controller rounds) around the enclosure.
  bool number(std::string_view kind, const Path& path, const Real& e, const Number& a, double k, double unit = 0,
              Measure measure = Measure::other) {
    const double granted = moves(k * unit, measure);
    if (measure == Measure::other)
      ++tally_.values, ++tally_.numbers;
    else
      count(granted);
    const bool linear = measure == Measure::length;
    const bool told_in_um = linear && granted <= rules_.cap_um();
    // A distance that is granted and not the worst is of no further interest.
    if (const double most = outside_at_most(e, a); most <= k * unit && most / unit <= tally_.worst_ulp &&
                                                   (!told_in_um || most * rules_.um_per_unit() <= tally_.worst_um))
      return false;
    const double distance = outside(e, a);
    if (distance == 0) return false;
    if (unit > 0) tally_.worst_ulp = std::max(tally_.worst_ulp, distance / unit);
    if (told_in_um) tally_.worst_um = std::max(tally_.worst_um, distance * rules_.um_per_unit());
    const double rounded = rounded_off(e, a, distance, measure);
    if (distance >= 0 && std::isfinite(rounded) && distance <= k * unit + rounded) return false;
    if (linear) difference_.deviation_um = distance * rules_.um_per_unit();
    return differ(std::string(kind), path.text(), judge::text(e), judge::text(a));
  }

  template <class Enumeration>
  bool named(std::string_view field, Enumeration e, Enumeration a) {
    return rules_.judges(field) && e != a &&
           differ(std::string(field), std::string(field), std::string(name(e)), std::string(name(a)));
  }

  bool absent(const Path& path, bool e, bool a) {
    if (e == a) return false;
    return e ? differ("missing field", path.text(), "present", "absent")
             : differ("extra field", path.text(), "absent", "present");
  }

  bool differ(std::string kind, std::string field, std::string expected, std::string actual) {
    difference_.kind = std::move(kind);
    difference_.field = std::move(field);
    difference_.expected = std::move(expected);
    difference_.actual = std::move(actual);
    return found_ = true;
  }

  const Rules& rules_;
  const model::Event& expected_;
  const spec::Event<Number>& actual_;
  Tally& tally_;
  Scale scale_;
  Difference difference_;
  bool found_ = false;
};

// Whether the margin is certainly larger: most are, which is told without a finer enclosure.
bool is_beyond(const model::Decision& decision, double band) {
  const exact::DoubleEnclosure quantity = decision.quantity.rough_enclosure();
  const exact::DoubleEnclosure scale = decision.scale.rough_enclosure();
  const double least = std::max({quantity.lower, -quantity.upper, 0.0});
  const double greatest = std::max(-scale.lower, scale.upper);
  return least > std::nextafter(band * greatest, std::numeric_limits<double>::infinity());
}

}  // namespace

Rules::Rules(const spec::Setup& setup, std::string_view section, const JudgeOptions& options)
    : budget_(policy::budget(section)),
      axes_(setup.axes),
      fields_(options.fields),
      resolution_(options.resolution),
      known_(options.known) {
  units(setup.units);
}

void Rules::units(spec::Units units) {
  constexpr double um_per_mm = 1000;
  constexpr double um_per_inch = 25400;
  inch_ = units == spec::Units::inch;
  um_per_unit_ = units == spec::Units::mm ? um_per_mm : um_per_inch;
}

bool Rules::is_near_tie(const model::Decision& decision, double band, const PositionErrors& positions) const {
  if (policy::compares_positions(decision.clause))
    band = std::max(
        {band, std::min(band * positions.at(decision.line), policy::kWidestBand), positions.deviation(decision.line)});
  if (!rounds() && policy::is_square(decision.clause)) band *= band;
  if (is_beyond(decision, band) || !(margin(decision) <= band)) return false;
  const bool scale_is_one = decision.scale.is_rational() && decision.scale.rational() == 1;
  if (rounds() || !policy::compares_exactly(decision.clause, scale_is_one)) return true;
  if (!decision.quantity.is_rational() || decision.quantity.rational() != 0 || !decision.scale.is_rational())
    return true;
  // The scale is the sum of all numbers compared.
  return !is_decimal(decision.scale.rational());
}

bool Rules::judges(std::string_view field) const {
  return fields_.empty() || std::find(fields_.begin(), fields_.end(), field) != fields_.end();
}

bool Rules::leaves_out(const model::Event& event) const {
  if (known_.is_all()) return false;
  return std::ranges::any_of(event.clauses, [this](spec::Clause clause) { return leaves_out(clause); });
}

bool Rules::judges_undecided() const { return !fields_.empty() && (judges("reason") || judges("permitted")); }

template <class Number>
std::optional<Difference> compare(const Rules& rules, const model::Event& expected, const Scale& scale,
                                  const spec::Event<Number>& actual, Tally& tally) {
  ++tally.events;
  if (expected.kind == EventKind::undecided && tally.open.count++ == 0)
    tally.open = {1, expected.line, expected.out_of_scope};
  if (tally.scope_left) ++tally.out_of_scope;
  tally.scope_left = tally.scope_left || expected.out_of_scope;
  return Comparison<Number>(rules, expected, scale, actual, tally).run();
}
template std::optional<Difference> compare(const Rules&, const model::Event&, const Scale&, const spec::Event<double>&,
                                           Tally&);
template std::optional<Difference> compare(const Rules&, const model::Event&, const Scale&,
                                           const spec::Event<Rational>&, Tally&);

void leave_out(const Rules& rules, const model::Event& event, Tally& tally) {
  ++tally.left_out;
  for (const spec::Clause clause : event.clauses)
    if (rules.leaves_out(clause)) ++tally.left_out_for[clause];
  tally.scope_left = tally.scope_left || event.out_of_scope;
}

void take(Verdict& verdict, const Tally& tally) {
  verdict.values = tally.values;
  verdict.numbers = tally.numbers;
  verdict.wide = tally.wide;
  verdict.widths = tally.widths;
  verdict.events = tally.events;
  verdict.open = tally.open;
  verdict.out_of_scope = tally.out_of_scope;
  verdict.left_out = tally.left_out;
  verdict.left_out_for = tally.left_out_for;
  verdict.worst_ulp = tally.worst_ulp;
  verdict.worst_um = tally.worst_um;
  verdict.bias = tally.bias;
}

bool left_open(const model::Event& event) {
  if (event.kind != EventKind::undecided) return false;
  const auto clause = spec::find_clause(event.number.view());
  return clause && policy::leaves_open(*clause);
}

template <class Number>
std::string describe(const spec::Event<Number>& event) {
  switch (event.kind) {
    case EventKind::move:
      return fmt::format("{} move, {}, line {}", name(event.type), name(event.cause), event.line);
    case EventKind::sample:
      return fmt::format("sample {}/{} of line {}", event.t_numerator, event.t_denominator, event.line);
    case EventKind::setting:
      return fmt::format("setting {} in line {}", event.setting.view(), event.line);
    case EventKind::hole:
      return fmt::format("hole, line {}", event.line);
    case EventKind::alarm:
    case EventKind::warning:
    case EventKind::undecided:
    case EventKind::not_supported:
    case EventKind::not_judged:
      return fmt::format("{} {} in line {}", name(event.kind), event.number.view(), event.line);
  }
  return {};
}
template std::string describe(const spec::Event<Real>&);
template std::string describe(const spec::Event<double>&);
template std::string describe(const spec::Event<Rational>&);

}  // namespace toolcomp::judge
