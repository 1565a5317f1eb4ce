// SPDX-License-Identifier: Apache-2.0
#include "cli/manual_setup.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/roff.h"
#include "spec/language/setup_format.h"

namespace toolcomp::cli {
namespace {

using Json = nlohmann::ordered_json;

// "fast", 1, "0.5": as somebody would write it in a setup.
std::string shown(const Json& value) { return value.dump(); }

// "Values: 0, 1; default 0.", "Values: 1 to 999.", …
std::string values(const Json& property) {
  std::string text;
  if (property.contains("enum"))
    for (const Json& value : property.at("enum"))
      // A number stands there in quotes too.
      if (!value.is_string() || property.at("enum").front().is_string())
        text += (text.empty() ? "" : ", ") + shown(value);
  if (property.contains("minimum")) text = shown(property.at("minimum")) + " to " + shown(property.at("maximum"));
  if (property.value("type", "") == "boolean") text = "true, false";
  const std::string usual = property.contains("default") ? shown(property.at("default")) : "";
  if (text.empty()) return usual.empty() ? "" : "Default: " + usual + '.';
  return "Values: " + text + (usual.empty() ? "" : "; default " + usual) + '.';
}

void add_properties(roff::Page& page, const Json& properties) {
  page.line(".Bl -tag -width Ds");
  for (const auto& [name, property] : properties.items()) {
    page.line(".It Cm " + roff::word(name));
    page.text(property.value("description", "A value of its own."));
    if (const std::string taken = values(property); !taken.empty()) page.text(taken);
    // A table of keys, or an array of such; that of parameters has a section of its own.
    const Json& inner = property.contains("items") ? property.at("items") : property;
    if (name != "parameters" && inner.contains("properties")) add_properties(page, inner.at("properties"));
  }
  page.line(".El");
}

}  // namespace

std::string setup_page(const std::string& date) {
  const Json schema = Json::parse(spec::setup_schema());
  const Json& controls = schema.at("$defs");
  const Json& fanuc = controls.at("fanuc").at("properties");
  roff::Page page("TOOLCOMP-SETUP", 5, date);
  page.section("NAME");
  page.line(".Nm setup.toml");
  page.line(".Nd setup of a control for toolcomp");
  page.section("DESCRIPTION");
  page.text(
      "A setup says what a program does not: which control runs it, its axes, parameters, offsets, tools and where the "
      "program starts. It is TOML, or JSON as in a case. Decimals are exact: they are read as they are written, quoted "
      "or not, without exponent and with at most 18 digits. What is not known is refused, with its place.");
  page.line(".Pp");
  page.text("Lengths are in the units of the setup, angles in degrees.");
  page.section("KEYS OF FANUC CONTROLS");
  add_properties(page, fanuc);
  page.section("PARAMETERS OF FANUC CONTROLS");
  page.text("In the table parameters, by number; a bit by number#bit, in quotes.");
  add_properties(page, fanuc.at("parameters").at("properties"));
  page.section("KEYS OF HEIDENHAIN CONTROLS");
  add_properties(page, controls.at("heidenhain").at("properties"));
  page.section("FILES");
  page.line(".Bl -tag -width Ds");
  page.line(".It Pa setup.toml");
  page.text("Beside a program: its setup, where the command line names none.");
  page.line(".It Pa /usr/share/toolcomp/setup.schema.json");
  page.text("The JSON Schema of setups, for editors.");
  page.line(".El");
  page.section("EXAMPLES");
  page.text("The smallest setup of a milling machine:");
  page.line(".Bd -literal -offset indent");
  for (const char* const row : {"control = \"fanuc\"", "[offsets.H]", "1 = \"-4.0\""}) page.literal(row);
  page.line(".Ed");
  page.line(".Pp");
  page.text("A commented one with every table:");
  page.line(".Bd -literal -offset indent");
  page.literal("$ toolcomp config example --control heidenhain");
  page.line(".Ed");
  page.section("SEE ALSO");
  page.line(".Xr toolcomp 1 ,");
  page.line(".Xr toolcomp-config 1");
  return page.take();
}

}  // namespace toolcomp::cli
