// SPDX-License-Identifier: Apache-2.0
// A planted fault in the model: it takes G44 for G43. The linker puts this function in the place of judge::run_model
// (CMakeLists.txt), whose symbol it asks for by its own.
#include <string>

#include "judge/oracle/verdict.h"

namespace {

using toolcomp::judge::Forced;
using toolcomp::judge::ModelRun;
using toolcomp::spec::Case;

#define TOOLCOMP_RUN_MODEL \
  "_ZN8toolcomp5judge9run_modelERKNS_4spec4CaseERKSt3mapImNS_5exact4SignESt4lessImESaISt4pairIKmS7_EEE"

}  // namespace

ModelRun sound_model(const Case& c, const Forced& forced) asm("__real_" TOOLCOMP_RUN_MODEL);
ModelRun wrong_model(const Case& c, const Forced& forced) asm("__wrap_" TOOLCOMP_RUN_MODEL);

ModelRun wrong_model(const Case& c, const Forced& forced) {
  Case other = c;
  for (std::size_t at = 0; (at = other.program.find("G44", at)) != std::string::npos; ++at) other.program[at + 2] = '3';
  return sound_model(other, forced);
}
