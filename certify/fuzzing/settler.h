// SPDX-License-Identifier: Apache-2.0
// Examines sightings, one at a time and in a separate process. If this process dies, one finding is not shrunk, and the
// campaign goes on.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "certify/fuzzing/folder.h"
#include "certify/fuzzing/settle.h"
#include "host/process.h"

namespace toolcomp::certify::fuzzing {

// The result for a sighting: its folder and its stage.
struct Settled {
  std::string name;         // of the folder below findings/, or below open/
  bool fresh = false;       // the first sighting in its folder
  bool open = false;        // could not be decided
  bool everywhere = false;  // settle.h
  std::string words;        // one line on it, for people
};

// Reads the sighting, settles it and writes its dossier, in this process. `as_seen`: do not examine it, because a
// process that did so was ended by it.
Settled settle_file(const Folder& folder, const std::filesystem::path& file, const std::string& target,
                    const std::string& why_as_seen, const SettleOptions& options);
// Writes the result as a line of text, and reads it.
std::string write_settled(const Settled& settled);
std::optional<Settled> read_settled(const std::string& line);

class Settler {
 public:
  // `stopped`: whether an end was asked for, which ends the process too.
  Settler(const Folder& folder, std::filesystem::path program, double timeout, std::function<bool()> stopped)
      : folder_(folder), program_(std::move(program)), timeout_(timeout), stopped_(std::move(stopped)) {}

  // Checks whether the current sighting is done, and begins the next. Of a group that occurs repeatedly only some
  // sightings are examined (fuzz::worth_keeping), enough to distinguish two bugs of one clause; if every program fails,
  // only the first. The others are dropped.
  void step(State& state, const std::function<void(const Settled&)>& on_settled);
  [[nodiscard]] bool busy() const { return process_ != nullptr; }
  void stop() { process_.reset(); }

 private:
  void begin();
  void done(State& state, const Settled& settled, const std::function<void(const Settled&)>& on_settled);

  const Folder& folder_;
  std::filesystem::path program_;
  double timeout_;
  std::function<bool()> stopped_;
  std::map<std::string, std::uint64_t> looked_;  // sightings by group, since this start
  std::unique_ptr<host::Process> process_;
  Folder::Sighting at_;
  host::Clock::time_point begun_;
  bool as_seen_ = false;
  bool everywhere_ = false;
  std::string failed_;  // why examining it was given up; then it is kept as it was seen
};

}  // namespace toolcomp::certify::fuzzing
