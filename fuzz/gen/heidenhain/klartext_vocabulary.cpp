// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/heidenhain/klartext_vocabulary.h"

#include <fmt/format.h>

#include "fuzz/gen/heidenhain/klartext_writer.h"

namespace toolcomp::fuzz {
namespace {

std::string number(Choices& choose) {
  if (choose.chance(35))
    return choose.one_of({"0",
                          "+0",
                          "-0",
                          "1",
                          "-1",
                          "+0.5",
                          "-.5",
                          "+10.",
                          "99999.9999",
                          "-99999.9999",
                          "99999.99999",
                          "100000",
                          "0.0001",
                          "+9.99999999",
                          "9.99999999",
                          "-10",
                          "+45",
                          "90",
                          "-180",
                          "0.0000001",
                          "1,5",
                          "+0.00045007",
                          "123456789.012345678",
                          "+Q1",
                          "-QL2",
                          "QR3",
                          "Q1999"});
  const int decimals = static_cast<int>(choose.between(0, 5));
  const std::int64_t count = choose.between(-2'000'000, 2'000'000);
  return klartext_number(choose, count, decimals);
}

std::string component(Choices& choose) {
  if (choose.chance(40)) return choose.one_of({"+0", "1", "-1", "+0.6", "-0.8", "0.0000001", "+0.5773503"});
  const std::int64_t count = choose.between(-100'000'000, 100'000'000);
  return klartext_number(choose, count, 8);
}

std::string vector(Choices& choose, char kind) {
  std::string text;
  for (const char axis : {'X', 'Y', 'Z'}) text += fmt::format(" {}{}{}", kind, axis, component(choose));
  return text;
}

std::string position(Choices& choose, const char* letters) {
  std::string text;
  for (const char* letter = letters; *letter != '\0'; ++letter) text += fmt::format(" {}{}", *letter, number(choose));
  return text;
}

}  // namespace

std::string any_klartext_word(Choices& choose) {
  switch (choose.weighted({30, 14, 16, 10, 14, 10, 6})) {
    case 0: {
      const char letter = choose.one_of({'X', 'Y', 'Z', 'X', 'Y', 'Z', 'A', 'B', 'C', 'U'});
      const bool incremental = choose.chance(15);
      return fmt::format("{}{}{}", incremental ? "I" : "", letter, number(choose));
    }
    case 1: {
      const char kind = choose.one_of({'N', 'T'});
      const char letter = choose.one_of({'X', 'Y', 'Z'});
      return fmt::format("{}{}{}", kind, letter, component(choose));
    }
    case 2:
      return choose.one_of({"R0", "RL", "RR"});
    case 3:
      return choose.one_of({"F100", "FMAX", "F MAX", "FAUTO", "F AUTO", "FZ0.1", "FU0.5", "F+Q1", "F"});
    case 4:
      return choose.one_of({"M107", "M108", "M128", "M129", "M3", "M30", "M2", "M91", "M92", "M0", "M8", "M9999",
                            "M140 MB MAX", "M140 MB4", "M99", "M89"});
    case 5:
      return choose.one_of({"DL+0.1", "DR-0.1", "DR2:+0.3", "DR2-0.1", "DR:0", "S5000", "Z"});
    default:
      return choose.one_of({"L",  "LN",      "TOOL", "CALL", "FUNCTION", "TCPM", "REFPNT", "CNT-CNT", "PROG", "PATH",
                            "IS", "CONTOUR", "OFF",  "~",    "; C",      "/",    "MM",     "INCH",    "END",  "PGM"});
  }
}

std::string any_klartext_statement(Choices& choose, const spec::Setup& setup) {
  switch (choose.weighted({18, 22, 12, 12, 30})) {
    case 0: {
      std::string text = "L" + position(choose, choose.one_of({"X", "XY", "XYZ", "Z", "XB", "XYZBC", "C"}));
      for (std::size_t n = choose.below(3); n > 0; --n) text += " " + any_klartext_word(choose);
      return text;
    }
    case 1: {
      std::string text = "LN" + position(choose, "XYZ");
      const std::size_t vectors = choose.weighted({3, 5, 4, 1});
      if (vectors == 0 || vectors == 1) text += vector(choose, 'N');
      if (vectors == 1 || vectors == 2) text += vector(choose, 'T');
      for (std::size_t n = choose.below(3); n > 0; --n) text += " " + any_klartext_word(choose);
      return text;
    }
    case 2: {
      const std::size_t row = choose.below(setup.tools.size() + 1);
      const std::uint32_t tenths = row < setup.tools.size() ? setup.tools[row].number : 990;
      std::string text = fmt::format("TOOL CALL {}.{} Z", tenths / 10, tenths % 10);
      if (choose.chance(70)) text = fmt::format("TOOL CALL {} Z", tenths / 10);
      for (std::size_t n = choose.below(3); n > 0; --n)
        text += choose.one_of({" DL+0.1", " DR-0.1", " DR2:+0.1", " S1", " F5"});
      return text;
    }
    case 3: {
      std::string text;
      for (std::size_t n = choose.below(5) + 1; n > 0; --n)
        text += (text.empty() ? "" : " ") + (choose.chance(12) ? odd_klartext(choose) : any_klartext_word(choose));
      return text;
    }
    default:
      return choose.one_of({"M128",
                            "M129",
                            "M107",
                            "M108",
                            "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT",
                            "FUNCTION TCPM F CONT AXIS SPAT PATHCTRL VECTOR",
                            "FUNCTION RESET TCPM",
                            "FUNCTION TCPM OFF",
                            "FUNCTION PROG PATH IS CONTOUR",
                            "FUNCTION PROG PATH OFF",
                            "FUNCTION CORRDATA TCS #1",
                            "FUNCTION CORRDATA RESET",
                            "SEL CORR-TABLE TCS \"A\"",
                            "TOOL CALL DR-0.1",
                            "TOOL CALL 0 Z",
                            "TOOL CALL QS3 Z",
                            "CYCL DEF 7.0 DATUM SHIFT",
                            "CYCL DEF 7.1 X+10 IY-2",
                            "CYCL DEF 200 DRILLING Q200=+2 Q201=-20 Q203=+0 Q204=+50",
                            "CYCL DEF 207 Q201=-5.5 Q200=Q1",
                            "CYCL DEF 240 CENTERING Q343=+0",
                            "CYCL CALL",
                            "CYCL CALL M3",
                            "M99",
                            "L X+1 R0 M99",
                            "Q201 = Q201 - 1",
                            "Q204 = -Q200",
                            "PLANE RESET STAY",
                            "STOP M8",
                            "Q1 = +2.5",
                            "QL2=-1",
                            "FN 0: QR3 = Q1",
                            "BEGIN PGM A INCH",
                            "END PGM A MM",
                            "* - structure",
                            "; comment",
                            "M30"});
  }
}

std::string odd_klartext(Choices& choose) {
  return choose.one_of({"X",
                        "X++1",
                        "X1.2.3",
                        "X1e3",
                        "X0x10",
                        "X1-",
                        "NX",
                        "NX+Q1",
                        "TX",
                        "R1",
                        "RL RR",
                        "F F",
                        "M",
                        "M-1",
                        "M10000",
                        "DR2",
                        "DR3+1",
                        "Q",
                        "Q2000=1",
                        "QL500=1",
                        "G01",
                        "N10",
                        "%",
                        "X\u22121",
                        "Y\u20132",
                        "\u00e4",
                        "\"open",
                        "LNX+1",
                        "L X",
                        "#1",
                        "IX",
                        "12345678901234567890",
                        "FN 1: Q1 = 2",
                        "TOOL CALL 32768",
                        "~",
                        "/ /",
                        "\t",
                        "CYCL DEF 7.1 A+1",
                        "CYCL DEF 200 Q200=",
                        "CYCL DEF 201 QL200=+1",
                        "CYCL CALL 5"});
}

}  // namespace toolcomp::fuzz
