// SPDX-License-Identifier: Apache-2.0
// Judges the recordings and the noted alarms of a kit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "certify/kit/alarm_form.h"
#include "certify/kit/kit.h"
#include "certify/trace/trace.h"

namespace toolcomp::certify::kit {

struct JudgeKitOptions {
  std::filesystem::path folder;                   // of the kit
  std::vector<std::filesystem::path> recordings;  // files, and folders of .csv files
  std::filesystem::path alarms;                   // the form; empty: that of the kit
  std::optional<spec::Decimal> tolerance;         // setup units, and degrees; std::nullopt: the tolerance of the kit
  bool machine_coordinates = false;               // the recordings are in machine coordinates
  bool rapids_by_axis = false;                    // only the ends of rapid moves are judged
};

enum class ProgramVerdict : std::uint8_t { conforms, differs, undecided, missing };

// One program, once for each of its recordings; once with `missing` if it was never recorded.
struct JudgedProgram {
  unsigned number = 0;
  ProgramVerdict verdict = ProgramVerdict::missing;
  std::string file;                    // recording
  std::string why;                     // of `missing` and `undecided`
  TraceResult trace;                   // without the data for pictures
  std::vector<std::size_t> cases_off;  // cases with a finding, by index
};

struct JudgedAlarm {
  unsigned number = 0;
  AlarmVerdict verdict = AlarmVerdict::not_noted;
  std::string noted;
};

struct KitVerdict {
  Kit kit;
  double tolerance = 0;
  std::vector<JudgedProgram> programs;
  std::vector<JudgedAlarm> alarms;
  std::vector<std::string> strangers;  // marks of programs that the kit does not have
  std::size_t shown = 0;               // clause outcomes of cases that conform and of alarms as expected
};

// Throws spec::InputError if the kit was changed, if a recording or the form cannot be read, and for a tolerance that
// is not positive.
KitVerdict judge_kit(const JudgeKitOptions& options);

// 1 if something differs; 3 if something is missing or could not be decided; otherwise 0: the certificate is complete.
int exit_status(const KitVerdict& verdict);

// certificate.json and index.html in the folder.
void write_certificate(const KitVerdict& verdict, const std::filesystem::path& folder);

std::string_view name(ProgramVerdict verdict);
std::string_view name(AlarmVerdict verdict);

}  // namespace toolcomp::certify::kit
