// SPDX-License-Identifier: Apache-2.0
// Tool length offset and leading edge offset: nanoseconds a block under the fast engine and the exact model, one
// thread, streaming. Blocks are read once beforehand, except in text_to_path.
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/bench/rows.h"

namespace {

using namespace toolcomp::bench;

// C-B tool rotation head: C (about Z) carries B (about Y).
constexpr std::string_view kSetup = R"(
control = "fanuc"
units = "mm"
axes = ["X", "Y", "Z", "B", "C"]
[parameters]
"19680" = 2
"19681" = 5
"19682" = 3
"19686" = 4
"19687" = 2
[offsets.H]
1 = "100.25"
2 = "87.5"
[offsets.D]
1 = "4.95"
)";
constexpr std::string_view kThreeAxes = R"(
control = "fanuc"
units = "mm"
axes = ["X", "Y", "Z"]
[offsets.H]
1 = "100.25"
2 = "87.5"
[offsets.D]
1 = "4.95"
)";

// A small generator, so that the numbers are the same everywhere.
class Numbers {
 public:
  // A number with three decimals in [-limit, limit).
  std::string next(int limit) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    const auto thousandths =
        static_cast<std::int64_t>((state_ >> 33U) % static_cast<std::uint64_t>(2000 * limit)) - 1000 * limit;
    std::string text = thousandths < 0 ? "-" : "";
    const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
    text += std::to_string(magnitude / 1000) + ".";
    const std::string decimals = std::to_string(magnitude % 1000);
    return text + std::string(3 - decimals.size(), '0') + decimals;
  }

 private:
  std::uint64_t state_ = 1;
};

std::string xyz(Numbers& numbers) {
  return "X" + numbers.next(100) + " Y" + numbers.next(100) + " Z" + numbers.next(100);
}

// `block` gives the words of one block.
template <class Block>
Program repeated(std::string_view setup, std::string head, const Block& block, int blocks = kBlocks) {
  Program program{std::string(setup), std::move(head), ""};
  Numbers numbers;
  for (int i = 0; i < blocks; ++i) program.body += block(numbers, i) + "\n";
  return program;
}

std::string turning(Numbers& numbers, int) {
  const std::string point = xyz(numbers);
  const std::string b = numbers.next(80);
  return point + " B" + b + " C" + numbers.next(180);
}
std::string straight(Numbers& numbers, int) { return xyz(numbers); }

Program tool_length_offset() { return repeated(kThreeAxes, "G90 G01 F1000. G43 Z0 H1\n", straight); }
Program tool_length_offset_new_h() {
  return repeated(kThreeAxes, "G90 G01 F1000. G43 Z0 H1\n",
                  [](Numbers& numbers, int i) { return xyz(numbers) + (i % 2 == 0 ? " H2" : " H1"); });
}
Program leading_edge_fixed_tool() { return repeated(kSetup, "G90 G01 F1000. B30. C20.\nG41.3 D1\n", straight); }
Program leading_edge_rotary_words() { return repeated(kSetup, "G90 G01 F1000.\nG41.3 D1\n", turning); }
Program leading_edge_ijk() {
  return repeated(kThreeAxes, "G90 G01 F1000. G43.5 H1 I0 J0 K1.\nG41.3 D1\n", [](Numbers& numbers, int) {
    const std::string point = xyz(numbers);
    const std::string i = numbers.next(1);
    return point + " I" + i + " J" + numbers.next(1) + " K1.";
  });
}
// Exact ties every block: the tool stands on Z, the movement in X Y.
Program leading_edge_ties() {
  return repeated(kSetup, "G90 G01 F1000.\nG41.3 D1\n", [](Numbers& numbers, int) {
    const std::string x = numbers.next(100);
    return "X" + x + " Y" + numbers.next(100);
  });
}
// Ties that double-double decides: B45 and movements along (1, 0, -1), without a range about 90 degrees.
Program leading_edge_fine_ties() {
  constexpr std::string_view kParameters = "[parameters]\n";
  std::string setup(kSetup);
  setup.insert(setup.find(kParameters) + kParameters.size(), "\"19631\" = 0\n");
  return repeated(setup, "G90 G01 F1000. B45.\nG41.3 D1\n",
                  [](Numbers&, int i) { return std::string(i % 2 == 0 ? "X10.5 Z-10.5" : "X0 Z0"); });
}

TOOLCOMP_ROW(tool_length_offset);
TOOLCOMP_ROW(tool_length_offset_new_h);
TOOLCOMP_ROW(leading_edge_fixed_tool);
TOOLCOMP_ROW(leading_edge_rotary_words);
TOOLCOMP_ROW(leading_edge_ijk);
TOOLCOMP_ROW(leading_edge_ties);
TOOLCOMP_ROW(leading_edge_fine_ties);

}  // namespace
