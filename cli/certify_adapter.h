// Controllers that are recorded: programs through an adapter.
#pragma once

#include <vector>

#include "certify/adapter.h"
#include "cli/verbs.h"
#include "spec/language/case.h"

namespace toolcomp::cli {

// `cases`: the programs named; without them, and with --cases, generated ones. `tolerance`: 0 for the adapter's own.
int certify_adapter(const CertifyOptions& options, const certify::Adapter& adapter, std::vector<spec::Case> cases,
                    double tolerance);

}  // namespace toolcomp::cli
