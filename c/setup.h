// SPDX-License-Identifier: Apache-2.0
// What a setup's handle is.
#pragma once

#include "c/include/toolcomp.h"
#include "spec/language/setup.h"

struct toolcomp_setup {
  toolcomp::spec::Setup value;
};
