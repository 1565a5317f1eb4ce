// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/scene.h"

namespace toolcomp::judge::laws {

FanucScene::FanucScene(const spec::Case& made, std::span<const model::Event> given)
    : c(made), events(given), program(made), stops(stops_of(made.setup.axes, program, given)) {
  if (program.has_code({kG43_4, kG43_5})) machine = Machine::of(c.setup);
  if (machine) runs = runs_of(c.setup, program, events, *machine);
}

}  // namespace toolcomp::judge::laws
