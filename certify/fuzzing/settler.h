// SPDX-License-Identifier: Apache-2.0
// Sightings looked at, one at a time and in a process of its own: what ends it costs one finding its shrinking, and the
// campaign nothing.
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
#include "certify/process.h"

namespace toolcomp::certify::fuzzing {

// What became of a sighting: the folder it came to, and how far it got.
struct Settled {
  std::string name;         // of the folder below findings/, or below open/
  bool fresh = false;       // the first of its folder
  bool open = false;        // could not be decided
  bool everywhere = false;  // settle.h
  std::string words;        // one line on it, for people
};

// In this process: reads the sighting, settles it and writes its dossier. `as_seen`: without looking at it again, after
// a process that did so was ended by it.
Settled settle_file(const Folder& folder, const std::filesystem::path& file, const std::string& target,
                    const std::string& why_as_seen, const SettleOptions& options);
// As a line of text, and back.
std::string write_settled(const Settled& settled);
std::optional<Settled> read_settled(const std::string& line);

class Settler {
 public:
  // `stopped`: an end was asked for, which ends the process too.
  Settler(const Folder& folder, std::filesystem::path program, double timeout, std::function<bool()> stopped)
      : folder_(folder), program_(std::move(program)), timeout_(timeout), stopped_(std::move(stopped)) {}

  // Looks whether the one at work is done and begins the next. Of a group that comes again and again only some are
  // looked at (fuzz::worth_keeping), which tells two bugs of one clause apart; where every program fails only the
  // first. The others are dropped.
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
  std::unique_ptr<Process> process_;
  Folder::Sighting at_;
  Clock::time_point begun_;
  bool as_seen_ = false;
  bool everywhere_ = false;
  std::string failed_;  // why looking at it was given up; then it is kept as seen
};

}  // namespace toolcomp::certify::fuzzing
