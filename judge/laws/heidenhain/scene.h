// SPDX-License-Identifier: Apache-2.0
// What every law of Klartext programs is given: the case, the events, and what is read from both once.
#pragma once

#include <span>
#include <vector>

#include "judge/laws/heidenhain/klartext_program.h"
#include "judge/laws/holding.h"
#include "model/basis/event.h"
#include "spec/language/case.h"

namespace toolcomp::judge::laws {

// A move of a Klartext program with what its block says.
struct SpaceMove {
  const model::Event* event = nullptr;
  std::size_t index = 0;
  const KlartextBlock* block = nullptr;
  Vector programmed;
  Vector tip;
  Vector tool;
  Vector side;  // normal × tool, where there is a contact
};

struct KlartextScene {
  const spec::Case& c;
  std::span<const model::Event> events;
  KlartextProgram klartext;
  std::vector<SpaceMove> moves;

  KlartextScene(const spec::Case& made, std::span<const model::Event> given);
};

}  // namespace toolcomp::judge::laws
