#include "fast/fanuc/control/cutter_value.h"

namespace toolcomp::fast {

CutterValue::CutterValue(const spec::Setup& setup, const OffsetMemory& memory)
    : memory_(memory), by_h_(setup.bit(5001, 2)), edited_at_next_block_(setup.bit(5001, 4)) {}

std::optional<CutterValue::Number> CutterValue::commanded(const Words& words) const {
  if (words.has('D')) return Number{whole_number(words['D'], memory_.count()), false};
  if (by_h_ && words.has('H')) return Number{whole_number(words['H'], memory_.count()), true};
  return std::nullopt;
}

}  // namespace toolcomp::fast
