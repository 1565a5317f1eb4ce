// SPDX-License-Identifier: Apache-2.0
// Programs that are too long to be tried.
#pragma once

#include "judge/oracle/trial.h"
#include "spec/language/case.h"

namespace toolcomp::fuzz {

// Programs that call others may be as long as they like: whether this one has more than 4,000 blocks as they run.
bool repeats_much(const spec::Case& c);

// try_case() of every other program; of these a trial that says that they are too long.
judge::Trial try_short(const spec::Case& c, const judge::CaseJudge& judged_by = {});

}  // namespace toolcomp::fuzz
