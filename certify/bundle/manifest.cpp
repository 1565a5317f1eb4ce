// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/manifest.h"

#include <nlohmann/json.hpp>

#include "certify/bundle/refused.h"
#include "spec/language/input_error.h"
#include "spec/language/outside_json.h"

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

Manifest read_manifest(std::string_view text) {
  Manifest m;
  try {
    const auto json = spec::read_outside_json(text, std::string(kManifest));
    if (!json.at("evidence").is_number_integer() || json.at("evidence") != kFormat)
      throw Refused("manifest.json: is of format " + json.at("evidence").dump() + "; this toolcomp reads format " +
                    std::to_string(kFormat));
    m.tool = json.at("tool").get<std::string>();
    m.made = json.at("made").get<std::string>();
    m.command = json.at("command").get<std::vector<std::string>>();
    m.directory = json.at("directory").get<std::string>();
    m.sections = json.at("sections").get<std::vector<std::string>>();
    m.adapter = json.at("adapter").get<std::string>();
    m.interrupted = json.at("interrupted").get<std::string>();
    m.cases = json.at("cases").get<std::uint64_t>();
    for (const auto& input : json.at("inputs"))
      m.inputs.push_back({input.at("given").get<std::string>(), input.at("file").get<std::string>()});
    for (const auto& file : json.at("files"))
      m.files.push_back({file.at("file").get<std::string>(), file.at("size").get<std::uint64_t>(),
                         file.at("sha256").get<std::string>()});
  } catch (const spec::InputError& error) {
    throw Refused("manifest.json: " + error.message());
  } catch (const nlohmann::json::exception& error) {
    throw Refused(std::string("manifest.json: ") + error.what());
  }
  return m;
}

}  // namespace toolcomp::certify::bundle
