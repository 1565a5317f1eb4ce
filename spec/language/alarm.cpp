// SPDX-License-Identifier: Apache-2.0
#include "spec/language/alarm.h"

#include <algorithm>
#include <cstddef>

#include "spec/parameters/alarm_table.h"

namespace toolcomp::spec {

// The table ends with what is no alarm.
constexpr std::size_t kBeyond = 2;
static_assert(std::ranges::count_if(kAlarms, is_beyond, &AlarmInfo::cause) == kBeyond &&
              std::all_of(kAlarms.end() - kBeyond, kAlarms.end(),
                          [](const AlarmInfo& alarm) { return is_beyond(alarm.cause); }));

std::span<const AlarmInfo> alarms() { return std::span(kAlarms).first(kAlarms.size() - kBeyond); }

const AlarmInfo& info(AlarmCause cause) { return kAlarms.at(static_cast<std::size_t>(cause) - 1); }

std::optional<AlarmCause> find_alarm(std::string_view name) {
  const std::span all(kAlarms);
  const auto found = std::ranges::find(all, name, &AlarmInfo::name);
  if (found == all.end()) return std::nullopt;
  return found->cause;
}

bool is_alarm_number(std::string_view text) {
  constexpr std::size_t kLongest = 32;
  return !text.empty() && text.size() <= kLongest &&
         text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-/.") ==
             std::string_view::npos;
}

std::string_view code_of(std::string_view text) {
  for (const std::string_view behind : {" (", " is ", " are "}) text = text.substr(0, text.find(behind));
  return text;
}

Name AlarmNumbers::operator()(AlarmCause cause) const {
  if (const auto own = own_.find(cause); own != own_.end()) return {own->second};
  return series_ == Series::series_30i ? info(cause).number_30i : info(cause).number_16i;
}

}  // namespace toolcomp::spec
