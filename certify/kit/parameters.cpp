// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/parameters.h"

#include <algorithm>
#include <array>

#include "spec/language/decimal_order.h"

namespace toolcomp::certify::kit {
namespace {

struct Range {
  std::uint32_t first, last;
  std::string_view why;
};

// Numbers left alone, the first row that fits. The last says what holds where nothing is listed.
constexpr std::array kLeftAlone = {
    Range{1260, 1260, "no position depends on it"},
    Range{1403, 1403, "no position depends on it"},
    Range{3401, 3401, "it changes how the machine reads every program"},
    Range{6241, 6254, "it belongs to the machine's probe"},
    Range{19610, 19623, "it describes the machine's kinematics"},
    Range{19666, 19666, "it describes the machine's tool holder"},
    Range{19680, 19690, "it describes the machine's kinematics"},
    Range{19696, 19696, "it shares its number with bits that describe the machine's kinematics"},
    Range{19697, 19714, "it describes the machine's kinematics"},
    Range{19741, 19744, "it protects the machine's rotary axes"},
    Range{19745, 19746, "no position depends on it"},
    Range{0, 99999, "it is not on the list of what a kit may change"},
};

// Settings of compensation: how vectors are made, which number counts, what is checked. To our recollection none needs
// the power to be switched off.
constexpr std::array kMayChange = {
    spec::ParameterId{5001, 0},   spec::ParameterId{5001, 1},   spec::ParameterId{5001, 2},
    spec::ParameterId{5001, 3},   spec::ParameterId{5001, 4},   spec::ParameterId{5001, 5},
    spec::ParameterId{5001, 6},   spec::ParameterId{5003, 0},   spec::ParameterId{5003, 1},
    spec::ParameterId{5003, 2},   spec::ParameterId{5008, 0},   spec::ParameterId{5008, 1},
    spec::ParameterId{5008, 3},   spec::ParameterId{5010, -1},  spec::ParameterId{6261, -1},
    spec::ParameterId{19604, 0},  spec::ParameterId{19605, 5},  spec::ParameterId{19608, 5},
    spec::ParameterId{19630, -1}, spec::ParameterId{19631, -1}, spec::ParameterId{19738, -1},
    spec::ParameterId{19739, -1},
};

}  // namespace

std::string_view why_left_alone(spec::ParameterId id) {
  if (std::ranges::find(kMayChange, id) != kMayChange.end()) return {};
  return std::ranges::find_if(kLeftAlone,
                              [id](const Range& range) { return range.first <= id.number && id.number <= range.last; })
      ->why;
}

spec::Decimal value_in_force(const spec::Setup& setup, spec::ParameterId id) {
  const spec::Decimal otherwise = spec::default_value(id, setup.units).value_or(spec::Decimal{});
  if (id.bit >= 0) return spec::decimal(setup.bit(id.number, id.bit, !otherwise.is_zero()) ? 1 : 0);
  return setup.parameter(id.number).value_or(otherwise);
}

Overlay overlay_for(const spec::Setup& machine, const spec::Setup& wanted) {
  Overlay overlay;
  for (const spec::ParameterId id : kMayChange) {
    const spec::Decimal value = value_in_force(wanted, id);
    if (spec::compare(value, value_in_force(machine, id)) != std::strong_ordering::equal) overlay[id] = value;
  }
  return overlay;
}

spec::Setup with_parameters(spec::Setup machine, const Overlay& overlay) {
  for (const auto& [id, value] : overlay) machine.parameters[id] = value;
  return machine;
}

std::string to_string(const Overlay& overlay) {
  std::string text;
  for (const auto& [id, value] : overlay)
    text += (text.empty() ? "" : ", ") + spec::to_string(id) + " = " + spec::to_string(value);
  return text.empty() ? "as on the machine" : text;
}

}  // namespace toolcomp::certify::kit
