// SPDX-License-Identifier: Apache-2.0
// Adapters: controllers that have a name. Each is a folder with a manifest (docs/adapters.md).
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

// A known difference: something that a controller does differently by design.
struct KnownDifference {
  std::string id;
  std::string reason;
  std::string recognised;           // how the adapter recognises it, in words
  std::string program;              // the shortest program that shows it
  std::filesystem::path setup;      // the setup of that program
  std::vector<std::string> alarms;  // alarms of the model at which the controller runs on, such as "PS0041"
};

struct Adapter {
  std::string name;
  AdapterKind kind{};
  std::filesystem::path folder;       // of the manifest; the command runs there
  std::string command;                // for /bin/sh
  std::vector<std::string> packages;  // Debian packages that it needs
  std::vector<std::string> programs;  // commands that must be installed
  double tolerance = 0;               // of a trace adapter, in setup units: the tolerance if the user gives none
  // The machines that the controller can be. Programs are generated for each of them (machine_program()). A trace
  // adapter names at least one.
  std::vector<std::filesystem::path> setups;
  std::vector<KnownDifference> known;

  // The shell command: the command in its folder, followed by `arguments`.
  [[nodiscard]] std::string shell_command(const std::vector<std::string>& arguments = {}) const;
  [[nodiscard]] const KnownDifference* known_difference(std::string_view id) const;
  // The known difference that the controller runs on if the model raises this alarm, or nullptr.
  [[nodiscard]] const KnownDifference* without_alarm(std::string_view number) const;
};

// The adapters of a manifest. Throws spec::InputError, with the position of the fault, for anything that is not a
// manifest: unknown and missing keys, wrong types, two adapters or known differences with one name, missing files.
std::vector<Adapter> read_manifest(const std::filesystem::path& file);
// The same for a text that is, or would be, in `file`.
std::vector<Adapter> read_manifest(std::string_view text, const std::filesystem::path& file);

// Folders whose subfolders are adapters, in the order in which they are searched: `named`, those of the environment
// variable TOOLCOMP_ADAPTERS (separated by colons), adapters/ in the share folder next to an installed command,
// adapters/ of the source tree.
std::vector<std::filesystem::path> adapter_folders(const std::vector<std::string>& named);

// The first adapter of this name. Throws as read_manifest() does for a manifest that is read before it is found.
std::optional<Adapter> find_adapter(std::string_view name, const std::vector<std::filesystem::path>& folders);

// Whether a text can be the name of an adapter: lower case letters, digits and hyphens.
bool is_adapter_name(std::string_view text);

// Throws spec::InputError that names the packages if a program that the adapter needs is not on the path.
void expect_programs(const Adapter& adapter);

}  // namespace toolcomp::certify
