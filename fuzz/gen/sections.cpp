#include "fuzz/gen/sections.h"

#include <fmt/format.h>

#include <stdexcept>

namespace toolcomp::fuzz {
namespace {

constexpr std::string_view kSections[] = {"fanuc/tool-length-offset", "fanuc/leading-edge-offset"};
constexpr std::int64_t kFewest = 4;
constexpr std::int64_t kMost = 8;

}  // namespace

std::span<const std::string_view> sections() { return kSections; }

spec::Case generate(std::string_view section, Mode mode, ChoiceSource& source, std::uint32_t blocks) {
  Choices choose(source);
  if (blocks == 0) blocks = static_cast<std::uint32_t>(choose.between(kFewest, kMost));
  spec::Case c;
  if (section == kSections[0])
    c = tool_length_offset(choose, blocks);
  else if (section == kSections[1])
    c = leading_edge_offset(choose, blocks);
  else
    throw std::invalid_argument(fmt::format("no generator for section \"{}\"", section));
  if (mode == Mode::unrestricted) c = unrestricted(choose, std::move(c), blocks);
  c.section = section;
  return c;
}

}  // namespace toolcomp::fuzz
