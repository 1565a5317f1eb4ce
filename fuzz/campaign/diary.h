// SPDX-License-Identifier: Apache-2.0
// What a worker of a campaign leaves on disk while it works, so that no end of it loses anything.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "fuzz/campaign/black_box.h"
#include "fuzz/campaign/counters.h"

namespace toolcomp::fuzz {

// How a finding was met, for whoever reads it.
struct HowFound {
  std::string target;
  std::uint64_t seed = 0;
  std::uint64_t executions = 0;  // of this worker, this one included
  double seconds = 0;            // since it began
};

// A difference as a finding that `toolcomp replay` reads, before anybody has looked at it again.
std::string seen_text(const spec::Case& input, const judge::Difference& difference, const HowFound& how);

// The files of one worker, in a folder of its own.
class Diary {
 public:
  static constexpr const char* kStatistics = "statistics";  // write_counters()
  static constexpr const char* kBlackBox = "black_box";
  // EXECUTION-DIGEST.json: seen_text(); with other endings: inputs as they are.
  static constexpr const char* kFindings = "findings";
  // The exit status of a worker whose folder cannot be written any more.
  static constexpr int kCannotWrite = 74;

  // Throws std::runtime_error where nothing can be written.
  Diary(std::filesystem::path folder, std::string target, std::uint64_t seed);

  // Before each execution.
  void begin(std::string_view input);
  // One more hit of this group. Of many only some are kept: the first ones, then the one that doubles their number.
  // `text` makes what is written, of the worker's position; `ending` is that of the file.
  void hit(const std::string& group, std::uint64_t executions, const std::function<std::string(const HowFound&)>& text,
           std::string_view ending);
  // Behind each execution: writes the statistics about once a second.
  void tick(const Counters& result);
  void write(Counters result);

  // Something could not be written: the worker must end with kCannotWrite. Nothing is lost before: the black box has
  // it.
  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] double seconds() const;

 private:
  void keep(const std::string& name, const std::string& text);

  std::filesystem::path folder_;
  std::string target_;
  std::uint64_t seed_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point written_ = begun_;
  BlackBox box_;
  std::map<std::string, std::uint64_t> hits_;
  bool failed_ = false;
};

// The group of a difference as far as it is known before it is shrunk: "SECTION|KIND|CLAUSE"; of a law its name.
std::string group_of(std::string_view section, const judge::Difference& difference);
// What could not be decided is looked at again too, as a difference of kind "undecided".
inline constexpr const char* kUndecidedKind = "undecided";
judge::Difference not_decided(const std::string& why);
// Whether the n-th hit of a group is kept.
bool worth_keeping(std::uint64_t hit);
// A short name for bytes.
std::string digest(std::string_view bytes);

}  // namespace toolcomp::fuzz
