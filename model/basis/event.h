// SPDX-License-Identifier: Apache-2.0
// The events that the engines of the model give.
#pragma once

#include <exception>

#include "model/exact/real.h"
#include "spec/language/event.h"

namespace toolcomp::model {

using exact::Real;

using Event = spec::Event<Real>;
using EventSink = spec::EventSink<Real>;

// A forced outcome (Recorder::force) led to a vector that does not exist, so that this outcome is not permitted.
// Engine::block and Engine::end may throw it. The engine cannot be used afterwards.
class NotFinite : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "the forced outcome leads to no finite vector"; }
};

}  // namespace toolcomp::model
