// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/program/calls.h"

namespace toolcomp::model::klartext {

using spec::klartext::Statement;

void record_call(Recorder& recorder, const spec::klartext::Block& block) {
  switch (block.statement) {
    case Statement::label:
      // heidenhain.program.subprogram-end: LBL 0 ends the subprogram that was called last, and the program continues
      // after the call. Without a call LBL 0 means nothing.
      if (block.label == spec::Name("0")) recorder.decide(Clause::heidenhain_program_subprogram_end, block.jumps);
      break;
    case Statement::call_label:
      // heidenhain.program.subprogram-call: CALL LBL without REP continues at the label of the same program, up to LBL
      // 0.
      if (block.repeats == 0) recorder.reach(Clause::heidenhain_program_subprogram_call);
      // heidenhain.program.section-repeat: CALL LBL with REP n goes back to the label n times and then continues, so
      // the blocks between label and call run n + 1 times in all. When the call is reached again later, the count
      // starts again.
      else
        recorder.decide(Clause::heidenhain_program_section_repeat, block.jumps);
      break;
    case Statement::call_program:
      // heidenhain.program.program-call: CALL PGM continues after the BEGIN PGM of the called program.
      recorder.reach(Clause::heidenhain_program_program_call);
      break;
    case Statement::program_return:
      // heidenhain.program.called-program-end: END PGM of a called program returns to the block after the call,
      // whatever subprograms are running.
      recorder.reach(Clause::heidenhain_program_called_program_end);
      break;
    default:
      break;
  }
}

}  // namespace toolcomp::model::klartext
