// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/kit_json.h"

#include <nlohmann/json.hpp>

#include "certify/kit/marks.h"
#include "host/sha256.h"
#include "spec/language/byte_source.h"
#include "spec/language/case.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify::kit {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const KitCase& c) {
  return {{"id", c.id},
          {"section", c.section},
          {"machine", c.same_machine ? "same" : "other"},
          {"first_line", c.lines.first},
          {"last_line", c.lines.last},
          {"end_line", c.lines.end},
          {"shows", c.shows}};
}

Json json_of(const KitProgram& program) {
  Json json{{"number", program.number}, {"group", program.group}, {"file", program.file}, {"setup", program.setup}};
  if (program.alarm.empty()) {
    json["mark"] = digits_of(program.number - kFirstProgram);
    json["mark_lines"] = {program.marks.steps, program.marks.first_rest, program.marks.last_rest};
    json["expected"] = program.expected;
  } else {
    json["alarm"] = program.alarm;
    json["alarm_n"] = program.alarm_n;
  }
  json["cases"] = Json::array();
  for (const KitCase& c : program.cases) json["cases"].push_back(json_of(c));
  return json;
}

}  // namespace

std::string write_kit(const Kit& kit) {
  Json json{{"kit", 1},
            {"dialect", std::string(spec::dialect_of(kit.machine.setup.control))},
            {"tool", kit.tool},
            {"corpus", kit.corpus},
            {"corpus_hash", kit.corpus_hash},
            {"sections", kit.sections},
            {"machine", spec::write_setup_toml(kit.machine.setup)},
            {"travels", Json::array()},
            {"tolerance", spec::to_string(kit.tolerance)},
            {"rests", {{"digits", Json::array()}, {"case_end", kCaseEnd}, {"program_end", kProgramEnd}}},
            {"offsets", kit.offsets_program},
            {"groups", Json::array()},
            {"programs", Json::array()},
            {"outcomes", kit.outcomes},
            {"recorded", kit.recorded},
            {"noted", kit.noted},
            {"missing", Json::array()},
            {"files", Json::object()}};
  for (const auto& [axis, travel] : kit.machine.travels)
    json["travels"].push_back(std::string(1, axis) + "=" + spec::to_string(travel.least) + "," +
                              spec::to_string(travel.greatest));
  for (unsigned digit = 0; digit < kBase; ++digit) json["rests"]["digits"].push_back(digit_length(digit));
  for (const KitGroup& group : kit.groups) {
    Json parameters = Json::object();
    for (const auto& [id, value] : group.parameters) parameters[spec::to_string(id)] = spec::to_string(value);
    json["groups"].push_back({{"parameters", parameters}, {"program", group.program}});
  }
  for (const KitProgram& program : kit.programs) json["programs"].push_back(json_of(program));
  for (const NotCovered& missing : kit.missing)
    json["missing"].push_back({{"outcome", missing.outcome}, {"text", missing.text}, {"why", missing.why}});
  for (const auto& [name, text] : kit.files) json["files"][name] = host::sha256(text);
  return json.dump(1) + "\n";
}

Kit read_kit(const std::filesystem::path& folder) {
  const std::string file = (folder / kKitFile).string();
  const std::string json = spec::read_file(file);
  Kit kit = read_kit_json(json, file);
  kit.digest = host::sha256(json);
  for (const auto& [name, digest] : kit.files) {
    const std::string path = (folder / name).string();
    if (name != kAlarmForm && host::sha256_file(path) != digest)
      throw spec::InputError(path, 0, 0, "differs from kit.json: the kit was changed");
  }
  return kit;
}

}  // namespace toolcomp::certify::kit
