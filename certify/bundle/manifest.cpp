// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/manifest.h"

#include <nlohmann/json.hpp>

#include "spec/language/document.h"

namespace toolcomp::certify::bundle {

using Json = nlohmann::ordered_json;

std::string write_manifest(const Manifest& m) {
  Json json{
      {"evidence", kFormat},      {"tool", m.tool},         {"made", m.made},       {"command", m.command},
      {"directory", m.directory}, {"sections", m.sections}, {"adapter", m.adapter}, {"interrupted", m.interrupted},
      {"cases", m.cases}};
  json["inputs"] = Json::array();
  for (const ManifestInput& input : m.inputs)
    json["inputs"].push_back(Json{{"given", input.given}, {"file", input.file}});
  json["files"] = Json::array();
  for (const ManifestFile& file : m.files)
    json["files"].push_back(Json{{"file", file.file}, {"size", file.size}, {"sha256", file.sha256}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

namespace {

// More than any bundle has of anything.
constexpr std::uint64_t kMostCounted = 1'000'000'000'000;

using spec::document::Kind;
using spec::document::Node;

const std::vector<Node>& list_of(const spec::document::Reader& read, const Node& table, std::string_view key) {
  read.expect(read.needed(table, key), Kind::array, key);
  return read.needed(table, key).items;
}

}  // namespace

Manifest read_manifest(std::string_view text) {
  const Node root = spec::document::parse_json(text, std::string(kManifest));
  const spec::document::Reader read((std::string(kManifest)));
  const Node& format = read.needed(root, "evidence");
  read.expect(format, Kind::number, "evidence");
  if (format.text != std::to_string(kFormat))
    read.fail(format.at, "is of format " + format.text + "; this toolcomp reads format " + std::to_string(kFormat));
  read.keys(root, "the manifest",
            {"evidence", "tool", "made", "command", "directory", "sections", "adapter", "interrupted", "cases",
             "inputs", "files"});
  const auto string = [&read](const Node& table, const char* key) { return read.string(read.needed(table, key), key); };
  const auto strings = [&](const char* key) { return read.strings(read.needed(root, key), key); };
  const auto count = [&read](const Node& table, const char* key) {
    return read.integer(read.needed(table, key), key, 0, kMostCounted);
  };
  Manifest m;
  m.tool = string(root, "tool");
  m.made = string(root, "made");
  m.command = strings("command");
  m.directory = string(root, "directory");
  m.sections = strings("sections");
  m.adapter = string(root, "adapter");
  m.interrupted = string(root, "interrupted");
  m.cases = count(root, "cases");
  for (const Node& input : list_of(read, root, "inputs")) {
    read.keys(input, "an input", {"given", "file"});
    m.inputs.push_back({string(input, "given"), string(input, "file")});
  }
  for (const Node& file : list_of(read, root, "files")) {
    read.keys(file, "a file", {"file", "size", "sha256"});
    m.files.push_back({string(file, "file"), count(file, "size"), string(file, "sha256")});
  }
  return m;
}

}  // namespace toolcomp::certify::bundle
