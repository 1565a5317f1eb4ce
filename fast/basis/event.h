// SPDX-License-Identifier: Apache-2.0
// The events that the engine gives.
#pragma once

#include "spec/language/event.h"

namespace toolcomp::fast {

using Event = spec::Event<double>;
using EventSink = spec::EventSink<double>;

}  // namespace toolcomp::fast
