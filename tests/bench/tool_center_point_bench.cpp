// Tool center point control and tool posture control: nanoseconds a block end, and a sample inside a block, around a
// wavy ring with a tool that turns in every block.
#include "tests/bench/leaning_tool.h"

namespace {

using namespace toolcomp::bench;

// C (about Z) carries B, about Y or inclined by 45 degrees.
std::string head(std::string_view axis) {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n"
         "19682 = 3\n19686 = 4\n" +
         std::string(axis) + "[offsets.H]\n1 = 100\n";
}
constexpr std::string_view kUpright = "19687 = 2\n";
constexpr std::string_view kInclined = "19687 = 5\n19688 = 45\n";

template <class Tool>
Program around_with(std::string_view axis, std::string_view mode, const Tool& tool, std::uint32_t samples = 0) {
  Program program{head(axis), "G90 G01 F1000 " + std::string(mode) + "\n", "", samples};
  for (const Place& place : places()) program.body += place.position + tool(place) + "\n";
  return program;
}

Program tip_rotary_words() { return around_with(kUpright, "G43.4 H1 P0", rotary_words); }
Program tip_ijk() { return around_with(kUpright, "G43.5 H1 P0", vector_words); }
Program posture_rotary_words() { return around_with(kUpright, "G43.4 H1 P1", rotary_words); }
Program posture_ijk() { return around_with(kUpright, "G43.5 H1 P1", vector_words); }
Program posture_ijk_inclined() { return around_with(kInclined, "G43.5 H1 P1", vector_words); }
Program tip_samples() { return around_with(kUpright, "G43.5 H1 P0", vector_words, 100); }
Program posture_samples() { return around_with(kUpright, "G43.5 H1 P1", vector_words, 100); }

TOOLCOMP_ROW(tip_rotary_words);
TOOLCOMP_ROW(tip_ijk);
TOOLCOMP_ROW(posture_rotary_words);
TOOLCOMP_ROW(posture_ijk);
TOOLCOMP_ROW(posture_ijk_inclined);
TOOLCOMP_ROW(tip_samples);
TOOLCOMP_ROW(posture_samples);

}  // namespace
