// SPDX-License-Identifier: Apache-2.0
// Alarms noted by hand: the form of a kit, and its entries.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "certify/kit/kit.h"

namespace toolcomp::certify::kit {

// CSV: program,alarm,block,note, with one line for each program that must end in an alarm. It does not contain the
// expected alarm, so that the engineer does not know it beforehand.
std::string write_alarm_form(const Kit& kit);

struct NotedAlarm {
  unsigned number = 0;     // of the program
  std::string alarm;       // as noted, in upper case: "PS0041", "41"; empty: not noted; "NONE": no alarm came
  std::string block;       // sequence number noted; empty: none
  std::uint64_t line = 0;  // of the form
};

// Throws spec::InputError, with line and column, for a malformed form: another header, another number of fields, a
// program that the kit does not have or that is listed twice, an alarm that is neither a number, PS and a number, a
// name of letters and _, nor NONE.
std::vector<NotedAlarm> read_alarm_form(std::string_view text, const std::string& file, const Kit& kit);

enum class AlarmVerdict : std::uint8_t { as_expected, other_alarm, none_came, not_noted };
// If the expected alarm has a name of this project (TYPE_C_FORMAT), any alarm is accepted. A noted block must be the
// expected one.
AlarmVerdict judge_alarm(const KitProgram& program, const NotedAlarm& noted);

}  // namespace toolcomp::certify::kit
