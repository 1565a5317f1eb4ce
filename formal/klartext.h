// Klartext programs by the formal specification.
#pragma once

#include "formal/engine.h"

namespace toolcomp::formal {

// As run(), of a program of this dialect.
Run run_klartext(const spec::Case& c);

// As an answer that there is none.
std::string not_said_yet(const std::string& what);

}  // namespace toolcomp::formal
