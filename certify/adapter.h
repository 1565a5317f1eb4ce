// SPDX-License-Identifier: Apache-2.0
// Adapters: controllers known by name, each a folder with a manifest (docs/adapters.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::certify {

enum class AdapterKind : std::uint8_t {
  pipe,   // speaks the controller protocol (docs/protocol.md)
  trace,  // runs a batch of programs and records the axes
};

// What a controller does otherwise by design.
struct KnownDifference {
  std::string id;
  std::string reason;
  std::string recognised;           // in words: how the adapter tells
  std::string program;              // the shortest that shows it
  std::filesystem::path setup;      // it is run with
  std::vector<std::string> alarms;  // of the model, where the controller runs on: "PS0041"
};

struct Adapter {
  std::string name;
  AdapterKind kind{};
  std::filesystem::path folder;       // of the manifest; the command runs there
  std::string command;                // for /bin/sh
  std::vector<std::string> packages;  // of Debian, that it needs
  std::vector<std::string> programs;  // commands that must be there
  double tolerance = 0;               // of a trace adapter: setup units, where the user names none
  // Machines it can be: programs are generated for each (machine_program()). A trace adapter names one at least.
  std::vector<std::filesystem::path> setups;
  std::vector<KnownDifference> known;

  // What a shell runs: the command in its folder, `arguments` behind it.
  [[nodiscard]] std::string shell_command(const std::vector<std::string>& arguments = {}) const;
  [[nodiscard]] const KnownDifference* known_difference(std::string_view id) const;
  // The one that the controller runs on where the model gives this alarm, or nullptr.
  [[nodiscard]] const KnownDifference* without_alarm(std::string_view number) const;
};

// The adapters of a manifest. Throws spec::InputError, with the position of the fault, for anything that is no
// manifest: unknown and missing keys, wrong types, two adapters or known differences of one name, files that are not
// there.
std::vector<Adapter> read_manifest(const std::filesystem::path& file);
// The same of a text that stands, or would stand, in `file`.
std::vector<Adapter> read_manifest(std::string_view text, const std::filesystem::path& file);

// Folders whose subfolders are adapters, in the order in which they are searched: `named`, those of the environment
// variable TOOLCOMP_ADAPTERS (separated by colons), adapters/ in the share folder beside an installed command,
// adapters/ of the source tree.
std::vector<std::filesystem::path> adapter_folders(const std::vector<std::string>& named);

// The first adapter of this name. Throws as read_manifest() for a manifest that is met before.
std::optional<Adapter> find_adapter(std::string_view name, const std::vector<std::filesystem::path>& folders);

// Whether a text can be the name of an adapter: lower case letters, digits and hyphens.
bool is_adapter_name(std::string_view text);

// Throws spec::InputError that names the packages if a program that the adapter needs is not on the path.
void expect_programs(const Adapter& adapter);

}  // namespace toolcomp::certify
