// SPDX-License-Identifier: Apache-2.0
#include "certify/adapter.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "host/data_folder.h"
#include "host/process.h"
#include "spec/language/byte_source.h"
#include "spec/language/document.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

namespace fs = std::filesystem;
using spec::document::Kind;
using spec::document::Node;
using spec::document::Reader;

constexpr std::string_view kManifest = "manifest.toml";

// A path beside the manifest, of a file that is there.
fs::path file_beside(const Reader& reader, const Node& node, std::string_view name, const fs::path& folder) {
  fs::path path = folder / reader.string(node, name);
  std::error_code none;
  if (!fs::is_regular_file(path, none)) reader.fail(node.at, std::string(name) + ": there is no file " + path.string());
  return path;
}

std::vector<KnownDifference> read_known(const fs::path& file, const fs::path& folder) {
  const Reader reader(file.string());
  const Node document = spec::document::parse_toml(spec::read_file(file.string()), file.string());
  reader.keys(document, "the file", {"difference"});
  std::vector<KnownDifference> known;
  const Node& list = reader.needed(document, "difference");
  reader.expect(list, Kind::array, "difference");
  for (const Node& node : list.items) {
    reader.keys(node, "a difference", {"id", "reason", "recognised", "program", "setup", "alarms"});
    KnownDifference one{reader.string(reader.needed(node, "id"), "id"),
                        reader.string(reader.needed(node, "reason"), "reason"),
                        reader.string(reader.needed(node, "recognised"), "recognised"),
                        reader.string(reader.needed(node, "program"), "program"),
                        file_beside(reader, reader.needed(node, "setup"), "setup", folder),
                        {}};
    if (const Node* alarms = node.find("alarms")) one.alarms = reader.strings(*alarms, "alarms");
    if (std::ranges::any_of(known, [&](const KnownDifference& k) { return k.id == one.id; }))
      reader.fail(node.at, "a second difference with the id \"" + one.id + "\"");
    known.push_back(std::move(one));
  }
  return known;
}

double read_tolerance(const Reader& reader, const Node& tolerance) {
  const spec::Decimal width = reader.decimal(tolerance, "tolerance");
  if (width.negative || width.is_zero()) reader.fail(tolerance.at, "tolerance: expected a positive length");
  return std::stod(tolerance.text);
}

std::vector<fs::path> read_setups(const Reader& reader, const Node& setups, const fs::path& folder) {
  reader.expect(setups, Kind::array, "setups");
  if (setups.items.empty()) reader.fail(setups.at, "setups: expected at least one");
  std::vector<fs::path> files;
  files.reserve(setups.items.size());
  for (const Node& setup : setups.items) files.push_back(file_beside(reader, setup, "setups", folder));
  return files;
}

Adapter read_adapter(const Reader& reader, const Node& node, const fs::path& folder) {
  reader.keys(node, "an adapter",
              {"name", "kind", "command", "packages", "programs", "tolerance", "setups", "known_differences"});
  Adapter adapter;
  adapter.folder = folder;
  const Node& name = reader.needed(node, "name");
  adapter.name = reader.string(name, "name");
  if (!is_adapter_name(adapter.name)) reader.fail(name.at, "name: expected lower case letters, digits and hyphens");
  adapter.kind = static_cast<AdapterKind>(reader.choice(reader.needed(node, "kind"), "kind", {"pipe", "trace"}));
  const Node& command = reader.needed(node, "command");
  adapter.command = reader.string(command, "command");
  if (adapter.command.empty()) reader.fail(command.at, "command: must not be empty");
  if (const Node* packages = node.find("packages")) adapter.packages = reader.strings(*packages, "packages");
  if (const Node* programs = node.find("programs")) adapter.programs = reader.strings(*programs, "programs");
  if (const Node* known = node.find("known_differences"))
    adapter.known = read_known(file_beside(reader, *known, "known_differences", folder), folder);
  const bool trace = adapter.kind == AdapterKind::trace;
  const Node* tolerance = trace ? &reader.needed(node, "tolerance") : node.find("tolerance");
  if (!trace && tolerance != nullptr) reader.fail(tolerance->at, "tolerance: allowed only with kind \"trace\"");
  if (trace) adapter.tolerance = read_tolerance(reader, *tolerance);
  if (const Node* setups = trace ? &reader.needed(node, "setups") : node.find("setups"))
    adapter.setups = read_setups(reader, *setups, folder);
  return adapter;
}

bool on_path(const std::string& program) {
  const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

}  // namespace

std::string Adapter::shell_command(const std::vector<std::string>& arguments) const {
  std::string line = "cd " + host::shell_quoted(folder.string()) + " && " + command;
  for (const std::string& argument : arguments) line += " " + host::shell_quoted(argument);
  return line;
}

const KnownDifference* Adapter::known_difference(std::string_view id) const {
  const auto found = std::ranges::find_if(known, [&](const KnownDifference& k) { return k.id == id; });
  return found == known.end() ? nullptr : &*found;
}

const KnownDifference* Adapter::without_alarm(std::string_view number) const {
  const auto found = std::ranges::find_if(
      known, [&](const KnownDifference& k) { return std::ranges::find(k.alarms, number) != k.alarms.end(); });
  return found == known.end() ? nullptr : &*found;
}

std::vector<Adapter> read_manifest(const fs::path& file) { return read_manifest(spec::read_file(file.string()), file); }

std::vector<Adapter> read_manifest(std::string_view text, const fs::path& file) {
  const Reader reader(file.string());
  const Node document = spec::document::parse_toml(text, file.string());
  reader.keys(document, "the manifest", {"adapter"});
  const Node& list = reader.needed(document, "adapter");
  reader.expect(list, Kind::array, "adapter");
  std::vector<Adapter> adapters;
  std::set<std::string> names;
  for (const Node& node : list.items) {
    adapters.push_back(read_adapter(reader, node, fs::absolute(file).parent_path()));
    if (!names.insert(adapters.back().name).second)
      reader.fail(node.at, "a second adapter with the name \"" + adapters.back().name + "\"");
  }
  return adapters;
}

std::vector<fs::path> adapter_folders(const std::vector<std::string>& named) {
  std::vector<fs::path> folders(named.begin(), named.end());
  // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing here sets variables
  if (const char* variable = std::getenv("TOOLCOMP_ADAPTERS")) {
    std::istringstream list(variable);
    for (std::string folder; std::getline(list, folder, ':');)
      if (!folder.empty()) folders.emplace_back(folder);
  }
  folders.push_back(host::data_folder() / "adapters");
  return folders;
}

std::optional<Adapter> find_adapter(std::string_view name, const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    std::error_code none;
    std::vector<fs::path> manifests;
    for (const auto& entry : fs::directory_iterator(folder, none))
      if (fs::is_regular_file(entry.path() / kManifest)) manifests.push_back(entry.path() / kManifest);
    std::ranges::sort(manifests);
    for (const fs::path& manifest : manifests)
      for (Adapter& adapter : read_manifest(manifest))
        if (adapter.name == name) return std::move(adapter);
  }
  return std::nullopt;
}

bool is_adapter_name(std::string_view text) {
  return !text.empty() && text.size() <= 64 &&
         std::ranges::all_of(text, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

void expect_programs(const Adapter& adapter) {
  for (const std::string& program : adapter.programs) {
    if (on_path(program)) continue;
    std::string packages;
    for (const std::string& package : adapter.packages) packages += " " + package;
    throw spec::InputError(
        "--controller " + adapter.name, 0, 0,
        program + " is not on PATH; packages that provide it:" + (packages.empty() ? " none named" : packages));
  }
}

}  // namespace toolcomp::certify
