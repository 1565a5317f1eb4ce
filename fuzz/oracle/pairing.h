// One run of the model against one list of events, pair by pair.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fuzz/oracle/compare.h"
#include "fuzz/oracle/condition.h"
#include "fuzz/oracle/pose_fit.h"

namespace toolcomp::fuzz {

// `Number` is double or exact::Rational.
template <class Number>
class Pairing {
 public:
  // Both are kept by reference, and so are `facts`.
  Pairing(const Rules& rules, const spec::Setup& setup, const ProgramFacts* facts)
      : rules_(rules), conditions_(setup, facts), fit_(rules, setup, facts) {}

  // The first difference between window[0] and `actual`, or nothing; `window` as for Conditions::next. Pairs are given
  // in order, none behind a difference.
  std::optional<Difference> next(std::span<const model::Event> window, const spec::Event<Number>& actual,
                                 Tally& tally) {
    Scale scale = conditions_.next(window);
    scale.carried = fit_.carried();
    double direction = 0;
    Tally judged = tally;
    std::optional<Difference> difference = compare(rules_, window.front(), scale, actual, judged);
    if (difference) {
      if (const auto seen = fit_.seen(window, actual, scale)) {
        judged = tally;
        direction = seen->direction;
        // A vector made with that tool axis is off with it.
        scale.condition *= std::max(1.0, direction / policy::ulp(1));
        difference = compare(rules_, seen->event, scale, actual, judged);
      }
    }
    tally = judged;
    if (!difference) fit_.follow(window.front(), actual, direction);
    return difference;
  }

  // Of the controller's rotary positions.
  [[nodiscard]] const std::vector<Deviation>& deviations() const { return fit_.deviations(); }

 private:
  const Rules& rules_;
  Conditions conditions_;
  PoseFit<Number> fit_;
};

}  // namespace toolcomp::fuzz
