#include <algorithm>
#include <string>

#include "spec/language/parameter.h"
#include "spec/language/setup_format.h"

namespace toolcomp::spec {
namespace {

constexpr std::string_view kFanucKeys =
    R"toml(# A FANUC machining centre with a head that turns the tool about Z (C) and then about Y (B).
# Every key may be left out; the values shown in brackets are then used. Decimals are exact, quoted or not.

control = "fanuc"                     # [fanuc]
units = "mm"                          # [mm] or inch: of this file, the results, and programs before G20 or G21
axes = ["X", "Y", "Z", "B", "C"]      # [X Y Z] controlled axes 1, 2, 3, …: the numbers that 19681 and 19686 mean
increment = "IS-B"                    # [IS-B] least input increment 0.001; IS-A 0.01, IS-C 0.0001
cutter_compensation = "C"             # [C] or B: which section G39 to G42 are
type_b_without_perpendicular = false  # [false] true: type B of tool side compensation has the intersection vectors alone
rotary_angles = "machine"             # [machine] coordinates of rotary axes that turn tool and table; or programmed
block_skip = false                    # [false] true: blocks that begin with / are skipped

[parameters]                          # by number; bits as "number#bit"; `toolcomp spec parameters` lists all
)toml";

constexpr std::string_view kFanucTables =
    R"toml(
[offsets]                             # tool offset memory
memory = "C"                          # A one value; B geometry and wear; C the same, H and D apart [A, or C if an entry has both]
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

[position]                            # where the program starts, workpiece coordinates without offsets [0]
Z = 100

[reference.1]                         # G28: machine coordinates [0]; G30 has 2, 3 and 4
Z = 300

[reference.floating]                  # G30.1
Z = 250

[measurement]                         # G37: axis positions where the approach-end signal comes on, workpiece coordinates
Z = "198.0"
)toml";

constexpr std::string_view kHeidenhain =
    R"toml(# A Heidenhain control with 3D tool compensation: two re-worked ball cutters and a toroid.
# Every key but control may be left out; the values shown in brackets are then used. Decimals are exact, quoted or not.

control = "heidenhain"                # programs are Klartext
units = "mm"                          # [mm] or inch: of [position], and of programs without BEGIN PGM
axes = ["X", "Y", "Z", "B", "C"]      # [X Y Z A B C] axes that a program may name; X, Y and Z must be there
block_skip = false                    # [false] true: blocks with / are skipped

[position]                            # where the program starts: workpiece coordinates [0]
Z = 100

[[tool]]                              # tool table, always in mm; all but the number may be left out [0]
number = 1                            # 1 to 32767; an indexed tool is "5.1"
name = "BALL_6"                       # for TOOL CALL "BALL_6"
R = 3                                 # tool radius
R2 = 3                                # corner radius: 0 end mill, R ball, between the two toroid
L = "80.25"                           # overall length up to the tip [unknown: results have no carrier]
DL = 0                                # deltas of the tool table; TOOL CALL and [[correction.tcs]] add theirs
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

[[dr2table]]                          # deviation of the radius by the angle of the contact: 0 at the tip, 90 at the equator
name = "BALL_6_MEASURED"
points = [[0, 0], [40, "0.03"], [50, "-0.02"], [90, "0.01"]]  # [degrees, mm], straight lines between
)toml";

constexpr std::size_t kCommentColumn = 38;

// A line for each parameter of the registry that has an example.
std::string parameter_lines() {
  std::string text;
  for (const ParameterInfo& p : parameters()) {
    if (p.example.empty()) continue;
    std::string line = p.id.bit < 0 ? to_string(p.id) : '"' + to_string(p.id) + '"';
    const std::string quote = p.example.find('.') == std::string_view::npos ? "" : "\"";
    line.append(" = ").append(quote).append(p.example).append(quote);
    line.resize(std::max(kCommentColumn, line.size() + 1), ' ');
    line += "# ";
    if (p.default_value) line += '[' + to_string(*p.default_value) + "] ";
    text.append(line).append(p.text).append(1, '\n');
  }
  return text;
}

}  // namespace

std::string_view setup_example(Control control) {
  static const std::string fanuc = std::string(kFanucKeys) + parameter_lines() + std::string(kFanucTables);
  return control == Control::heidenhain ? kHeidenhain : std::string_view(fanuc);
}

}  // namespace toolcomp::spec
