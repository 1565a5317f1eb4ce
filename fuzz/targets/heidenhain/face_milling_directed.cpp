// SPDX-License-Identifier: Apache-2.0
#include "fuzz/targets/twin.h"

TOOLCOMP_TWIN_TARGET("heidenhain/face-milling", toolcomp::fuzz::Mode::directed)
