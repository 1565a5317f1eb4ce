// SPDX-License-Identifier: Apache-2.0
// Chooses vectors of the golden corpus for a machine and makes programs of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "certify/kit/choose.h"
#include "certify/kit/kit.h"

namespace toolcomp::certify::kit {

struct MakeOptions {
  Machine machine;
  std::vector<std::string> sections;  // empty: all of the dialect
  std::filesystem::path corpus;
  std::uint32_t generated = 0;     // number of generated programs as further candidates (machine_program())
  std::uint64_t seed = 1;          // seed of these programs
  std::uint32_t first_offset = 1;  // offset numbers from here on are used
  // The largest tolerance for judging recordings, in the units of the setup and in degrees. An outcome that moves a
  // path by less is not shown.
  spec::Decimal tolerance{5, 2, false, false};
  std::size_t cases_a_program = 12;
  // For a control that can say in advance why it cannot run a program, or which known difference it has; empty text if
  // it can run it. For such a control the kit changes no parameters, and has no program that ends in an alarm.
  WhyNot why_not;
  std::function<void(const std::string&)> progress;  // what is being done
};

// The same options and the same corpus give the same kit. Throws spec::InputError for options from which no kit can be
// made, std::runtime_error if the engines do not agree on a program of the kit.
Kit make(const MakeOptions& options);

}  // namespace toolcomp::certify::kit
