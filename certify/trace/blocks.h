// SPDX-License-Identifier: Apache-2.0
// A program that the model runs step by step on request.
#pragma once

#include <memory>

#include "model/basis/event.h"
#include "model/fanuc/program/motion.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

// The program, read and run block by block.
class Blocks {
 public:
  virtual ~Blocks() = default;
  // Runs the next block, or the end of the program; false if that was before.
  virtual bool next() = 0;
};

// `c`, `events` and `motions` must outlive them. Throws spec::InputError for a setup that the control could not have.
// Only FANUC programs give motions.
std::unique_ptr<Blocks> blocks_of(const spec::Case& c, model::EventSink& events, model::MotionSink& motions);

}  // namespace toolcomp::certify
