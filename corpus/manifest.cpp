// SPDX-License-Identifier: Apache-2.0
#include "corpus/manifest.h"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/sha256.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"
#include "spec/language/outside_json.h"

namespace toolcomp::corpus {

std::string to_string(const Version& version) {
  return fmt::format("{}.{}.{}", version.major, version.minor, version.patch);
}

Version parse_version(std::string_view text) {
  Version version;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto number = [&](unsigned& value) {
    const auto [next, error] = std::from_chars(at, end, value);
    const bool padded = next - at > 1 && *at == '0';
    if (error != std::errc() || padded) throw std::invalid_argument("expected a version MAJOR.MINOR.PATCH");
    at = next;
  };
  const auto point = [&] {
    if (at == end || *at != '.') throw std::invalid_argument("expected a version MAJOR.MINOR.PATCH");
    ++at;
  };
  number(version.major);
  point();
  number(version.minor);
  point();
  number(version.patch);
  if (at != end) throw std::invalid_argument("expected a version MAJOR.MINOR.PATCH");
  return version;
}

Manifest read_manifest(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "manifest.json";
  const std::string text = spec::read_file(file);
  Manifest manifest;
  try {
    const auto json = spec::read_outside_json(text, file.string());
    if (json.at("corpus") != 1) throw spec::InputError(file.string(), 0, 0, "corpus: expected format 1");
    manifest.version = json.at("version").get<std::string>();
    parse_version(manifest.version);
    manifest.generator = json.at("generator").get<std::string>();
    manifest.seed = json.at("seed").get<std::string>();
    for (const auto& entry : json.at("files"))
      manifest.files.push_back({entry.at("file").get<std::string>(), entry.at("section").get<std::string>(),
                                entry.at("vectors").get<std::size_t>(), entry.at("sha256").get<std::string>()});
  } catch (const nlohmann::json::exception& error) {
    throw spec::InputError(file.string(), 0, 0, error.what());
  } catch (const std::invalid_argument& error) {
    throw spec::InputError(file.string(), 0, 0, error.what());
  }
  manifest.hash = host::sha256(text);
  return manifest;
}

std::string write_manifest(const Manifest& manifest) {
  nlohmann::ordered_json json{
      {"corpus", 1}, {"version", manifest.version}, {"generator", manifest.generator}, {"seed", manifest.seed}};
  for (const Flag& flag : kFlags)
    json["flags"][std::string(flag.name)] = {{"description", flag.description}, {"effect", flag.effect}};
  json["files"] = nlohmann::ordered_json::array();
  for (const ManifestFile& file : manifest.files)
    json["files"].push_back(nlohmann::ordered_json{
        {"file", file.file}, {"section", file.section}, {"vectors", file.vectors}, {"sha256", file.sha256}});
  return json.dump(2) + '\n';
}

}  // namespace toolcomp::corpus
