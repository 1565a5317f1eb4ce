// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <utility>

#include "spec/language/parameter.h"
#include "spec/language/setup_format.h"
#include "spec/language/setup_key.h"

namespace toolcomp::spec {
namespace {

constexpr std::string_view kFanucHead =
    R"toml(# A FANUC machining centre with a head that turns the tool about Z (C) and then about Y (B).
# Every key may be left out; the values shown in brackets are then used. Decimals are exact, quoted or not.

control = "fanuc"                     # [fanuc]
)toml";

constexpr std::string_view kFanucAxes =
    R"toml(axes = ["X", "Y", "Z", "B", "C"]      # [X Y Z] controlled axes 1, 2, 3, …: parameters such as 19681 and 19686 use these numbers
)toml";

constexpr std::string_view kParametersHead =
    R"toml(
[parameters]                          # by number; bits as "number#bit"; `toolcomp spec parameters` lists all
)toml";

constexpr std::string_view kFanucTables =
    R"toml(
[offsets]                             # tool offset memory
memory = "C"                          # A: one value; B: geometry and wear; C: as B, separate for H and D [A, or C if an entry has both]
count = 400                           # [400] number of entries

[offsets.H]
1 = "-4.0"
2 = { geometry = 120, wear = "-0.25" }

[offsets.D]
1 = 5

[workpiece.G54]                       # G54 to G59: workpiece origins in machine coordinates [0]
X = 0
Y = 0
Z = 0

[workpiece.P1]                        # G54.1 P1 to P48 [0]; workpiece.external is added to all of them [0]
X = 400

[position]                            # where the program starts, workpiece coordinates without offsets [0]
Z = 100

[reference.1]                         # G28: machine coordinates [0]; G30 has 2, 3 and 4
Z = 300

[reference.floating]                  # G30.1
Z = 250

[measurement]                         # G37: axis positions at which the approach-end signal comes on, workpiece coordinates
Z = "198.0"
)toml";

constexpr std::string_view kHeidenhainHead =
    R"toml(# A Heidenhain control with 3D tool compensation: two re-worked ball cutters and a toroid.
# Every key but control may be left out; the values shown in brackets are then used. Decimals are exact, quoted or not.

control = "heidenhain"                # programs are Klartext
)toml";

constexpr std::string_view kHeidenhainAxes =
    R"toml(axes = ["X", "Y", "Z", "B", "C"]      # [X Y Z A B C] axes that a program may name; X, Y and Z must be among them
)toml";

constexpr std::string_view kHeidenhainTables =
    R"toml(
[position]                            # where the program starts: workpiece coordinates [0]
Z = 100

[[tool]]                              # tool table, always in mm; all but the number may be left out [0]
number = 1                            # 1 to 32767; "5.1" is an indexed tool
name = "BALL_6"                       # for TOOL CALL "BALL_6"
R = 3                                 # tool radius
R2 = 3                                # corner radius: 0 for an end mill, R for a ball cutter, in between for a toroid
L = "80.25"                           # overall length up to the tip [unknown: events then have no carrier]
DL = 0                                # deltas of the tool table; those of TOOL CALL and [[correction.tcs]] are added
DR = "-0.1"
DR2 = "-0.1"

[[tool]]
number = 2
R = 6
R2 = 1

[[tool]]
number = "5.1"
R = 3
R2 = 3
DR2TABLE = "BALL_6_MEASURED"          # 3D-ToolComp: replaces DR2 in blocks with a surface normal

[[correction.tcs]]                    # rows of the compensation table (.tco), mm: FUNCTION CORRDATA TCS #1
number = 1
DL = "-0.005"
DR = "0.01"
DR2 = "0.01"

[[dr2table]]                          # deviation of the radius for each contact angle: 0 at the tip, 90 at the equator
name = "BALL_6_MEASURED"
points = [[0, 0], [40, "0.03"], [50, "-0.02"], [90, "0.01"]]  # [degrees, mm], interpolated linearly
)toml";

constexpr std::size_t kCommentColumn = 38;

std::string line(std::string text, const std::string& default_value, std::string_view comment) {
  text.resize(std::max(kCommentColumn, text.size() + 1), ' ');
  text += "# ";
  if (!default_value.empty()) text += '[' + default_value + "] ";
  return text.append(comment) + '\n';
}

// A line for each key of the control, all at their defaults, with its axes among them.
std::string key_lines(Control control, std::string_view axes) {
  std::string text;
  for (const KeyInfo& key : keys()) {
    if (key.is_of(control))
      text += line(std::string(key.id) + " = " + value_text(key, key.default_value),
                   std::string(key.values[key.default_value]), key.comment[static_cast<std::size_t>(control)]);
    if (key.id == kKeyBeforeAxes) text += axes;
  }
  return text;
}

// A line for each parameter of the registry that has an example.
std::string parameter_lines() {
  std::string text;
  for (const ParameterInfo& p : parameters()) {
    if (p.example.empty()) continue;
    const std::string id = p.id.bit < 0 ? to_string(p.id) : '"' + to_string(p.id) + '"';
    const std::string quote = p.example.find('.') == std::string_view::npos ? "" : "\"";
    std::string setting = id + " = ";
    setting.append(quote).append(p.example).append(quote);
    text += line(std::move(setting), p.default_value ? to_string(*p.default_value) : std::string(), p.text);
  }
  return text;
}

}  // namespace

std::string_view setup_example(Control control) {
  static const std::string fanuc = std::string(kFanucHead) + key_lines(Control::fanuc, kFanucAxes) +
                                   std::string(kParametersHead) + parameter_lines() + std::string(kFanucTables);
  static const std::string heidenhain =
      std::string(kHeidenhainHead) + key_lines(Control::heidenhain, kHeidenhainAxes) + std::string(kHeidenhainTables);
  return control == Control::heidenhain ? heidenhain : fanuc;
}

}  // namespace toolcomp::spec
