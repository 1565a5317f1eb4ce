// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/control/cutter_value.h"

namespace toolcomp::fast {

CutterValue::CutterValue(const spec::Setup& setup, const OffsetMemory& memory)
    : memory_(memory), by_h_(setup.bit(5001, 2)), edited_at_next_block_(setup.bit(5001, 4)) {}

}  // namespace toolcomp::fast
