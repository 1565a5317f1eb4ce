// SPDX-License-Identifier: Apache-2.0
// Events of the fast engine for a function of C.
#pragma once

#include "c/include/toolcomp.h"
#include "fast/basis/event.h"

namespace toolcomp::c {

// Hands each event on; none where there is no function.
class CallbackSink final : public fast::EventSink {
 public:
  CallbackSink(toolcomp_on_event on_event, void* user) : on_event_(on_event), user_(user) {}
  void on(const fast::Event& event) override;

 private:
  toolcomp_on_event on_event_;
  void* user_;
};

}  // namespace toolcomp::c
