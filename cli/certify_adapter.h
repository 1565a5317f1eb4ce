// SPDX-License-Identifier: Apache-2.0
// Controllers that are recorded: programs through an adapter.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/adapter.h"
#include "certify/occasion.h"
#include "cli/verbs.h"
#include "spec/language/case.h"

namespace toolcomp::cli {

// Those that the command line names: positive; the linear one in setup units, the rotary one in degrees.
struct Tolerances {
  std::optional<double> linear, rotary;
};

// Writes the file of --badge, where there is one.
void write_badge(const CertifyOptions& options, const std::string& badge);

// `cases`: the programs named; without them, and with --cases, generated ones.
int certify_adapter(const CertifyOptions& options, const certify::Adapter& adapter, std::vector<spec::Case> cases,
                    const Tolerances& tolerances, const certify::Occasion& occasion);

}  // namespace toolcomp::cli
