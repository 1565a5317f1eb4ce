// SPDX-License-Identifier: Apache-2.0
// Runs a batch of programs through a trace adapter, and judges each as a recorded run.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "certify/adapter.h"
#include "certify/occasion.h"
#include "certify/trace/trace.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

enum class RunOutcome : std::uint8_t {
  conforms,        // the recording follows the exact path
  both_refuse,     // the controller and the model both raise an alarm
  known,           // every finding is a known difference
  differs,         // a new difference
  not_applicable,  // the controller does not have what the program needs
  undecided,       // the model could not decide, or nothing was judged
  failed,          // no recording, because the adapter failed
  not_run,         // interrupted before it was judged
};
inline constexpr std::size_t kRunOutcomes = 8;
// "conforms", "both refuse", …
std::string_view name(RunOutcome outcome);

struct AdapterRun {
  spec::Case c;          // as judged
  std::string machine;   // of a generated program: the name of its setup
  std::string expected;  // of a program from the known differences: its id
  RunOutcome outcome = RunOutcome::failed;
  std::string why;                 // for people, one line
  std::vector<std::string> known;  // ids of the known differences that explain findings
  TraceResult result;              // of a recording
  std::filesystem::path folder;    // of the batch: program, setup, what the adapter wrote
};

struct AdapterCertificationOptions {
  Adapter adapter;
  std::vector<spec::Case> cases;  // judged first
  bool show_known = false;        // then the programs of the known differences
  std::uint32_t generated = 0;    // then programs, the machines of the adapter in turn
  std::uint64_t seed = 1;
  std::optional<double> tolerance;            // positive; without it that of the adapter
  std::optional<double> rotary_tolerance;     // positive, degrees; without it the number of the other
  std::string report;                         // folder; the batch is its subfolder runs
  std::chrono::milliseconds timeout{10'000};  // for each program; the batch has six times that in addition
  // A test of the judge: only the judge gets this value of a parameter, in setups that have the parameter. It must then
  // find a difference.
  std::map<spec::ParameterId, spec::Decimal> altered;
  std::function<void(const std::string&)> progress;  // gets the lines of the adapter and of toolcomp
  // Asked repeatedly. Returns why to stop, or an empty text to go on. If it stops, the adapter is killed, and its
  // recordings so far are judged.
  std::function<std::string()> stop;
};

struct AdapterCertificate {
  std::vector<AdapterRun> runs;
  double tolerance = 0;
  double seconds_run = 0;     // by the adapter
  double seconds_judged = 0;  // by the model
  std::string errors;         // last lines of an adapter that ended with a fault; otherwise empty
  std::string interrupted;    // why not everything was run or judged; otherwise empty
  Occasion occasion;
};

// Throws spec::InputError for programs that no control could read, and if the adapter cannot be run at all. Folders of
// programs that conform are removed.
AdapterCertificate certify_adapter(const AdapterCertificationOptions& certification);

// 1 if there is a new difference; 3 if nothing was judged, or if something was undecided or interrupted, or the adapter
// failed; otherwise 0.
int exit_status(const AdapterCertificate& certificate);

}  // namespace toolcomp::certify
