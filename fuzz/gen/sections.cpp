#include "fuzz/gen/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>

namespace toolcomp::fuzz {
namespace {

// A section and what makes its directed cases.
struct Generator {
  std::string_view section;
  spec::Case (*make)(Choices& choose, std::uint32_t blocks);
};
constexpr Generator kGenerators[] = {
    {"fanuc/tool-length-offset", tool_length_offset},
    {"fanuc/tool-length-measurement", tool_length_measurement},
    {"fanuc/tool-offset", tool_offset},
    {"fanuc/cutter-compensation-b", cutter_compensation_b},
    {"fanuc/cutter-compensation-c", cutter_compensation_c},
    {"fanuc/tool-side-compensation", tool_side_compensation},
    {"fanuc/leading-edge-offset", leading_edge_offset},
    {"fanuc/tool-center-point-control", tool_center_point_control},
    {"fanuc/tool-posture-control", tool_posture_control},
    {"heidenhain/face-milling", face_milling},
    {"heidenhain/peripheral-milling", peripheral_milling},
    {"heidenhain/programmed-contour", programmed_contour},
};
constexpr auto kSections = [] {
  std::array<std::string_view, std::size(kGenerators)> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kGenerators[i].section;
  return names;
}();
constexpr std::int64_t kFewest = 4;
constexpr std::int64_t kMost = 8;

}  // namespace

std::span<const std::string_view> sections() { return kSections; }

spec::Case generate(std::string_view section, Mode mode, ChoiceSource& source, std::uint32_t blocks) {
  Choices choose(source);
  if (blocks == 0) blocks = static_cast<std::uint32_t>(choose.between(kFewest, kMost));
  const auto* const generator = std::ranges::find(kGenerators, section, &Generator::section);
  if (generator == std::end(kGenerators))
    throw std::invalid_argument(fmt::format("no generator for section \"{}\"", section));
  spec::Case c = generator->make(choose, blocks);
  c.section = section;
  if (mode == Mode::unrestricted) c = unrestricted(choose, std::move(c), blocks);
  return c;
}

}  // namespace toolcomp::fuzz
