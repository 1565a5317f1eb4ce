#include "corpus/proofs/fanuc/corner.h"

#include <algorithm>

namespace toolcomp::corpus {
namespace {

constexpr std::initializer_list<const char*> kBeyond = {"G10", "G28", "G29", "G30", "G30.1", "G37", "G45",
                                                        "G46", "G47", "G48", "G52", "G53",   "G54", "G54.1",
                                                        "G55", "G56", "G57", "G58", "G59",   "G92"};

bool has_any(const spec::Block& block, std::initializer_list<const char*> codes) {
  return std::ranges::any_of(codes, [&](const char* code) { return has(block, code); });
}

}  // namespace

Modal modal_at(const spec::Case& c, const Blocks& blocks, std::uint64_t line, SideCodes left, SideCodes right) {
  Modal modal;
  for (const auto& [number, block] : blocks) {
    if (number > line) break;
    if (has(block, "G00") || has(block, "G01")) modal.straight = true;
    if (has(block, "G02") || has(block, "G03")) modal.straight = false;
    if (has(block, "G40")) modal.side = 0;
    if (has_any(block, left)) modal.side = 1;
    if (has_any(block, right)) modal.side = -1;
    if (const auto d = word(block, 'D')) modal.value = offset_of(c.setup, 'D', d->digits);
  }
  return modal;
}

bool is_beyond_corners(const Blocks& blocks, std::initializer_list<const char*> also) {
  return std::ranges::any_of(
      blocks, [&](const auto& entry) { return has_any(entry.second, kBeyond) || has_any(entry.second, also); });
}

}  // namespace toolcomp::corpus
