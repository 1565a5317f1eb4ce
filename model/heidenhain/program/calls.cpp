// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/program/calls.h"

namespace toolcomp::model::klartext {

using spec::klartext::Statement;

void record_call(Recorder& recorder, const spec::klartext::Block& block) {
  switch (block.statement) {
    case Statement::label:
      // heidenhain.program.subprogram-end: LBL 0 ends the subprogram that was called last, and the program goes on
      // behind its call; without a call it means nothing.
      if (block.label == spec::Name("0")) recorder.decide(Clause::heidenhain_program_subprogram_end, block.jumps);
      break;
    case Statement::call_label:
      // heidenhain.program.subprogram-call: CALL LBL without REP goes on at the label of the same program, up to LBL 0.
      if (block.repeats == 0) recorder.reach(Clause::heidenhain_program_subprogram_call);
      // heidenhain.program.section-repeat: CALL LBL with REP n goes back to the label n times and then on, so that the
      // blocks between run n + 1 times in all; reached anew, it counts anew.
      else
        recorder.decide(Clause::heidenhain_program_section_repeat, block.jumps);
      break;
    case Statement::call_program:
      // heidenhain.program.program-call: CALL PGM goes on behind the BEGIN PGM of the program called.
      recorder.reach(Clause::heidenhain_program_program_call);
      break;
    case Statement::program_return:
      // heidenhain.program.called-program-end: END PGM of a program that was called goes back behind the call, whatever
      // subprograms are under way.
      recorder.reach(Clause::heidenhain_program_called_program_end);
      break;
    default:
      break;
  }
}

}  // namespace toolcomp::model::klartext
