// SPDX-License-Identifier: Apache-2.0
// How a law is checked: its input and its result.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "judge/laws/certainty.h"
#include "model/basis/event.h"

namespace toolcomp::judge::laws {

// A law that the events break.
struct Violation {
  std::string_view law;
  std::uint64_t line = 0;
  std::size_t event = 0;  // index in the list of events
  std::string text;       // what should hold
  std::string amount;     // by how much it is violated: the exact value, to 20 decimals
};

// The checks of one law on one list of events. Counts the checks, and keeps the first certain violation. After it there
// are no more checks.
class Holding {
 public:
  Holding(std::string_view law, std::span<const model::Event> events) : law_(law), events_(events) {}

  // `residual` is zero.
  void zero(const Real& residual, std::size_t event, std::string_view what) {
    ask(certainly_not_zero, residual, event, what, " = 0");
  }
  // `value` is not negative.
  void not_negative(const Real& value, std::size_t event, std::string_view what) {
    ask(certainly_negative, value, event, what, " >= 0");
  }
  // All three components are zero; the amount is the length.
  void zero(const Vector& residual, std::size_t event, std::string_view what) {
    if (violation_) return;
    ++checks_;
    if (std::ranges::any_of(residual, certainly_not_zero))
      fail(event, std::string(what).append(" = 0"), amount(length(residual)));
  }
  // A fact that needs no number.
  void holds(bool fact, std::size_t event, std::string_view what) {
    if (violation_) return;
    ++checks_;
    if (!fact) fail(event, std::string(what), "");
  }

  [[nodiscard]] std::uint64_t checks() const { return checks_; }
  [[nodiscard]] const std::optional<Violation>& violation() const { return violation_; }

 private:
  void ask(bool (*broken)(const Real&), const Real& value, std::size_t event, std::string_view what,
           std::string_view expected) {
    if (violation_) return;
    ++checks_;
    if (broken(value)) fail(event, std::string(what).append(expected), amount(value));
  }
  void fail(std::size_t event, std::string text, std::string by) {
    violation_ = {law_, event < events_.size() ? events_[event].line : 0, event, std::move(text), std::move(by)};
  }

  std::string_view law_;
  std::span<const model::Event> events_;
  std::uint64_t checks_ = 0;
  std::optional<Violation> violation_;
};

}  // namespace toolcomp::judge::laws
