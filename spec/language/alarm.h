// SPDX-License-Identifier: Apache-2.0
// The alarms: causes, and what the control of a setup shows for each (spec/alarms.toml).
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "spec/language/name.h"
#include "spec/language/setup.h"
#include "spec/parameters/alarm_causes.h"

namespace toolcomp::spec {

// A cause, as the table gives it.
struct AlarmInfo {
  AlarmCause cause;
  std::string_view name;        // of the cause: "arc-without-center"
  std::string_view number_16i;  // "PS0022"; empty: that series does not raise it
  std::string_view number_30i;
  const char* text;
  std::string_view source;
};

// In the order of the table, which is that of AlarmCause after `none`. Causes that are no alarms (is_beyond) are left
// out.
std::span<const AlarmInfo> alarms();
// Of a cause other than `none`.
const AlarmInfo& info(AlarmCause cause);
// std::nullopt if no cause has this name.
std::optional<AlarmCause> find_alarm(std::string_view name);
// The number that the control of a setup shows: its own one ([alarms]), or else that of its series.
class AlarmNumbers {
 public:
  explicit AlarmNumbers(const Setup& setup) : series_(setup.series), own_(setup.alarms) {}
  [[nodiscard]] Name operator()(AlarmCause cause) const;

 private:
  Series series_;
  std::map<AlarmCause, std::string> own_;
};
// Whether the run ends only here and not at a control: not_supported and not_judged, which are no alarms.
constexpr bool is_beyond(AlarmCause cause) {
  return cause == AlarmCause::not_supported || cause == AlarmCause::not_judged;
}
// The word of the program in the message of such an end: "G81" of "G81 (drilling, a canned cycle) is not supported".
std::string_view code_of(std::string_view text);
// The message of such an end, if a block has one; nullptr otherwise.
template <class Block>
const char* beyond(const Block& block) {
  return block.alarm && is_beyond(block.alarm->cause) ? block.alarm->message : nullptr;
}
// Whether a setup may give this as its own number: 1 to 32 letters, digits and _ - / .
bool is_alarm_number(std::string_view text);

}  // namespace toolcomp::spec
