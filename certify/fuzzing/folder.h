// SPDX-License-Identifier: Apache-2.0
// The folder of a campaign:
//   state.json        what it has done (state.h)
//   corpus/TARGET     inputs that reached something new
//   asked             inputs of the corpus that the formal specification has had
//   work/NUMBER       a slice that is running, or was running when the campaign was killed
//   findings/NAME     a finding (dossier.h); findings/new: sightings nobody has looked at; open/NAME: not decided
//   log               what happened, a line each
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "certify/fuzzing/state.h"

namespace toolcomp::certify::fuzzing {

class Folder {
 public:
  explicit Folder(std::filesystem::path root) : root_(std::move(root)) {}

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  [[nodiscard]] std::filesystem::path corpus(const std::string& target = {}) const {
    return target.empty() ? root_ / "corpus" : root_ / "corpus" / target;
  }
  [[nodiscard]] std::filesystem::path work(std::uint64_t slice) const;
  [[nodiscard]] std::filesystem::path findings() const { return root_ / "findings"; }
  [[nodiscard]] std::filesystem::path open() const { return root_ / "open"; }
  [[nodiscard]] std::filesystem::path sightings() const { return findings() / "new"; }

  // The state, including the slices that were not counted because the campaign was killed; std::nullopt if the folder
  // has no campaign.
  [[nodiscard]] std::optional<State> load() const;
  // Throws std::runtime_error with the name of the file.
  void save(const State& state, const std::vector<Running>& running) const;
  // One line with the time of day.
  void log(const std::string& line) const;

  // Moves the sightings of a worker so far to the sightings of the campaign. They are renamed, so that each is in
  // exactly one place at any time.
  void take_sightings(std::uint64_t slice) const;
  // Counts a slice that has ended, saves, and only then removes its folder, so that a kill in between counts nothing
  // twice.
  void close(State& state, std::uint64_t slice, std::uint64_t milliseconds, const std::vector<Running>& running) const;
  // Removes the slices that load() has counted, after they are saved.
  void remove_work() const;

  struct Sighting {
    std::filesystem::path file;  // SLICE--TARGET--NAME
    std::string target;
  };
  // The oldest first.
  [[nodiscard]] std::vector<Sighting> waiting() const;

 private:
  std::filesystem::path root_;
};

}  // namespace toolcomp::certify::fuzzing
