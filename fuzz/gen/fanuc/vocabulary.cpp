// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/vocabulary.h"

#include <fmt/format.h>

namespace toolcomp::fuzz {

// As many digits as a number may have (15), but none of a length no control has (fuzz/gen/mutate.cpp).
std::string boundary_number(Choices& choose) {
  return choose.one_of({"0",
                        "-0",
                        "0.",
                        "-0.",
                        ".0",
                        "0.0",
                        "0.001",
                        "-0.001",
                        "0.0001",
                        "1",
                        "-1",
                        "1.",
                        "-1.",
                        ".5",
                        "10.",
                        "45.",
                        "90.",
                        "-90.",
                        "180.",
                        "360.",
                        "359.999",
                        "999.999",
                        "1000.",
                        "99999.999",
                        "-99999.999",
                        "999999.999",
                        "0.00000001",
                        "99999999",
                        "123456789.012345",
                        "1.00000000000001"});
}

namespace {

std::string tool_side_word(Choices& choose) {
  return choose.one_of({"G41.2", "G42.2", "G41.2", "G42.2", "G41.6", "G42.6", "G40",  "D1",  "D2",  "Q1",  "Q2",
                        "Q3",    "Q0",    "Q4",    "G43.5", "G49",   "I1.",   "J-1.", "K1.", "G05", "G96", "G97"});
}

std::string tip_control_word(Choices& choose) {
  return choose.one_of({"G43.4", "G43.4", "G43.5", "G43.5",  "H1",   "H2",      "P0",    "P1",    "P1",
                        "P2",    "Q2.",   "Q-3.",  "G49",    "I1.",  "J-1.",    "K1.",   "K-1.",  "A30.",
                        "B30.",  "B-30.", "C90.",  "C-180.", "B0",   "C360.",   "G41.2", "G42.6", "G41.6",
                        "G41.3", "G40",   "D1",    "G02",    "R20.", "K100000."});
}

std::string cycle_word(Choices& choose) {
  return choose.one_of({"G81", "G73", "G74", "G76", "G82",  "G83", "G84", "G85", "G86", "G87", "G88", "G89",
                        "G80", "G98", "G99", "R2.", "R-3.", "Q1.", "Q0",  "K0",  "K2",  "K3",  "L2",  "Z-5."});
}

// Whether the section is about programs under G43.4 and G43.5.
bool controls_the_tip(std::string_view section) {
  return section == "fanuc/tool-center-point-control" || section == "fanuc/tool-posture-control";
}

}  // namespace

// One choice a statement: the order in which arguments are evaluated differs between compilers.
std::string any_word(Choices& choose, const spec::Setup& setup, std::string_view section) {
  if (section == "fanuc/tool-side-compensation" && choose.chance(25)) return tool_side_word(choose);
  if (section == "fanuc/canned-cycle" && choose.chance(35)) return cycle_word(choose);
  if (controls_the_tip(section) && choose.chance(40)) return tip_control_word(choose);
  switch (choose.weighted({30, 30, 12, 10, 8, 10})) {
    case 0:
      return fmt::format(
          "G{}", choose.one_of({"00",   "01", "02",   "03",   "04", "10", "17", "18", "19", "20", "21",   "28",
                                "29",   "30", "30.1", "37",   "39", "40", "41", "41", "42", "42", "41.3", "43",
                                "43.5", "44", "45",   "46",   "47", "48", "49", "53", "54", "52", "54.1", "80",
                                "64",   "93", "95",   "05.1", "55", "59", "90", "91", "92", "94", "0",    "1"}));
    case 1: {
      const std::string& letters = setup.axes.letters();
      const char letter = letters[choose.below(letters.size())];
      if (choose.chance(30)) return letter + boundary_number(choose);
      const auto whole = choose.between(-200, 200);
      const auto decimals = choose.chance(60) ? 0 : choose.between(0, 999);
      return fmt::format("{}{}.{}", letter, whole, decimals);
    }
    case 2: {
      const char letter = choose.one_of({'I', 'J', 'K', 'R'});
      return letter + (choose.chance(40) ? boundary_number(choose) : fmt::format("{}.", choose.between(-20, 20)));
    }
    case 3: {
      const char letter = choose.one_of({'H', 'D', 'P', 'L'});
      return fmt::format("{}{}", letter, choose.between(0, 13));
    }
    case 4:
      return fmt::format("F{}", choose.between(0, 5000));
    default:
      return choose.one_of({"M00", "M01", "M02", "M30", "M08", "S1000", "T1", "Q1", "N5", "O1", "M98", "M99", "L20"});
  }
}

std::string odd_word(Choices& choose) {
  const char letter = static_cast<char>('A' + choose.below(26));
  return letter + std::string(choose.one_of({"",
                                             "-",
                                             ".",
                                             "-.",
                                             "--1",
                                             "1-",
                                             "1.2.3",
                                             "+5",
                                             "1e3",
                                             "12345678901234567890",
                                             "0x10",
                                             " 1",
                                             "1,5",
                                             "#1",
                                             "[1+2]",
                                             "-0",
                                             "00000000001",
                                             "G",
                                             "99",
                                             "4.",
                                             "43.4",
                                             "41.2",
                                             "1000000000",
                                             ".0000000000001",
                                             "(",
                                             ")",
                                             "/",
                                             ";X1"}));
}

}  // namespace toolcomp::fuzz
