// SPDX-License-Identifier: Apache-2.0
// The formal specification runs in one thread for ever (spec_engine/engine.h), whichever thread of Python asks.
#pragma once

#include <functional>

namespace toolcomp::python {

// Does `work` in that thread and waits for it, without the GIL held. What it throws is thrown here.
void in_formal_thread(const std::function<void()>& work);

}  // namespace toolcomp::python
