// SPDX-License-Identifier: Apache-2.0
// The list of the stages of compensation.
#pragma once

#include "fast/basis/event.h"
#include "fast/fanuc/control/control.h"
#include "fast/fanuc/control/stage.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Those of a setup. Throws spec::InputError for parameters no control could have.
Stages make_stages(const spec::Setup& setup, Control& control, EventSink& sink);

}  // namespace toolcomp::fast
