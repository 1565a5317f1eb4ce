#include "spec/language/setup_format.h"

namespace toolcomp::spec {
namespace {

constexpr std::string_view kFanuc =
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

[parameters]                          # by number; bits as "number#bit"
"3401#0" = 1                          # numbers without decimal point are mm or degrees; 0: least input increments
"5001#0" = 0                          # TLC and TLB: type of tool length offset
"5001#1" = 0
"5001#2" = 0                          # OFH: how G43, G44 and H act
"5001#3" = 0                          # TAL: offset along several axes
"5001#4" = 0                          # EVR: when a changed value of cutter compensation takes effect
"5001#5" = 0                          # TPH: G45 to G48 take their number from D; 1: from H
"5001#6" = 0                          # EVO: when a changed length offset value takes effect
"5003#0" = 0                          # SUP: type A of start-up and cancel in cutter and tool side compensation; 1: type B
"5003#1" = 0                          # SUV: 1: type C, a lone G41, G42, G41.2, G42.2 or G40 moves the tool
"5003#2" = 0                          # CCN: 1: the mode goes on after G28, G30 and G53
"5008#0" = 0                          # CNI: interference check; 1: none
5010 = 0                              # corner movements up to this length are left out (cutter compensation C: on either axis)
6241 = 100                            # G37: measuring feed [F in force] …
6251 = 20                             # … from this distance before the commanded coordinate [20 mm] …
6254 = 5                              # … and the signal may be off by this much [5 mm]
6261 = 45                             # tool side: turns of the tool from this angle on are checked for interference [45]
"19605#5" = 0                         # NIC: the check of 6261; 1: none
19630 = 0                             # tool side: movements shorter than this across the tool count as none
19631 = "1.0"                         # range of angles (degrees) taken as 0, 90 or 180 by the leading edge offset
19680 = 2                             # kinematics: 2 tool rotation, 12 table rotation, 21 mixed, 0 none
19681 = 5                             # master rotary axis: controlled axis 5 (C) …
19682 = 3                             # … about Z
19686 = 4                             # slave rotary axis: controlled axis 4 (B) …
19687 = 2                             # … about Y

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

}  // namespace

std::string_view setup_example(Control control) { return control == Control::heidenhain ? kHeidenhain : kFanuc; }

}  // namespace toolcomp::spec
