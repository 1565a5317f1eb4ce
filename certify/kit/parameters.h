// SPDX-License-Identifier: Apache-2.0
// The parameters that a kit changes, and those that it leaves as they are on the machine.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "spec/language/parameter.h"
#include "spec/language/setup.h"

namespace toolcomp::certify::kit {

// Parameters with values other than those of the machine.
using Overlay = std::map<spec::ParameterId, spec::Decimal>;

// Why a kit never changes the parameter; empty if it may. Only listed parameters may be changed. A kit changes how
// compensation is computed, and never a parameter that describes or protects the machine.
std::string_view why_left_alone(spec::ParameterId id);

// The changes that make the machine compute as in `wanted`: all parameters that may be changed and whose effective
// values differ.
Overlay overlay_for(const spec::Setup& machine, const spec::Setup& wanted);

// The effective value: from the setup, or else the default of the registry.
spec::Decimal value_in_force(const spec::Setup& setup, spec::ParameterId id);

// The machine with these parameters.
spec::Setup with_parameters(spec::Setup machine, const Overlay& overlay);

// "5003#0 = 1, 5010 = 4.5"; "as on the machine" if it is empty.
std::string to_string(const Overlay& overlay);

}  // namespace toolcomp::certify::kit
