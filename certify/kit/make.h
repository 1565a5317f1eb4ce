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
  std::uint32_t generated = 0;     // so many programs made for this machine are candidates besides (machine_program())
  std::uint64_t seed = 1;          // of these
  std::uint32_t first_offset = 1;  // offset numbers from here on are used
  // Positions of recordings are judged with no more than this, in the units of the setup and in degrees: what moves a
  // path by less shows nothing.
  spec::Decimal tolerance{5, 2, false, false};
  std::size_t cases_a_program = 12;
  // Of a control that says beforehand why it cannot run a program, or is known to run it otherwise; empty where it can.
  // For such a control parameters stay as they are, and no program is made to end in an alarm.
  WhyNot why_not;
  std::function<void(const std::string&)> progress;  // what is being done
};

// The same options and the same corpus give the same kit. Throws spec::InputError for options that nothing can be made
// of, std::runtime_error where the engines do not agree on a program of the kit.
Kit make(const MakeOptions& options);

}  // namespace toolcomp::certify::kit
