// SPDX-License-Identifier: Apache-2.0
// Which parameters a kit changes, and which it leaves as they are on the machine.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "spec/language/parameter.h"
#include "spec/language/setup.h"

namespace toolcomp::certify::kit {

// Parameters with other values than the machine has.
using Overlay = std::map<spec::ParameterId, spec::Decimal>;

// Why a kit never changes the parameter; empty where it may. What may be changed is listed, all else is left alone: a
// kit changes only how compensation is computed, never what describes or protects the machine.
std::string_view why_left_alone(spec::ParameterId id);

// What a parameter may be changed to so that it is as in `wanted`: all that may be changed and differs in effect.
Overlay overlay_for(const spec::Setup& machine, const spec::Setup& wanted);

// What counts: as the setup gives it, else the default of the registry.
spec::Decimal value_in_force(const spec::Setup& setup, spec::ParameterId id);

// The machine with these parameters.
spec::Setup with_parameters(spec::Setup machine, const Overlay& overlay);

// "5003#0 = 1, 5010 = 4.5"; "as on the machine" where it is empty.
std::string to_string(const Overlay& overlay);

}  // namespace toolcomp::certify::kit
