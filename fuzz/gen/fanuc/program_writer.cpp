// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/program_writer.h"

#include <fmt/format.h>

#include <cmath>

#include "fuzz/gen/fanuc/setups.h"

namespace toolcomp::fuzz {
namespace {

std::int64_t converted(std::int64_t counts, bool to_millimetres) {
  constexpr double factor = 25.4;
  const auto value = static_cast<double>(counts);
  return std::llround(to_millimetres ? value * factor : value / factor);
}

}  // namespace

ProgramWriter::ProgramWriter(Choices& choose, const spec::Setup& setup)
    : choose_(choose),
      setup_(setup),
      decimals_(increment_decimals(setup)),
      counts_without_point_(!setup.bit(3401, 0, true)),
      numbered_(choose.chance(60)),
      idles_(choose.chance(10)),
      calls_(choose.chance(5)),
      renames_(choose.chance(4)) {
  for (int i = 0; i < decimals_; ++i) one_ *= 10;
  for (const auto& [letter, value] : setup.position) {
    auto counts = static_cast<std::int64_t>(value.digits);
    for (int i = value.decimals; i < decimals_; ++i) counts *= 10;
    position_[letter] = value.negative ? -counts : counts;
  }
}

ProgramWriter& ProgramWriter::word(std::string_view text) {
  if (!block_.empty()) block_ += ' ';
  block_ += text;
  return *this;
}

ProgramWriter& ProgramWriter::number(char address, std::int64_t counts) {
  const std::int64_t magnitude = counts < 0 ? -counts : counts;
  const std::int64_t whole = magnitude / one_;
  // -0 is a word of its own where the sign of an incremental zero counts.
  const std::string_view sign = counts < 0 || (counts == 0 && choose_.chance(8)) ? "-" : "";
  // Least input increments: of linear words alone, degrees have other ones in inch programs.
  const bool linear = std::string_view("XYZUVWIJKR").find(address) != std::string_view::npos;
  if (linear && counts_without_point_ && choose_.chance(40))
    return word(fmt::format("{}{}{}", address, sign, magnitude));
  std::string fraction = fmt::format("{:0{}}", magnitude % one_, decimals_);
  // Converted lengths of so many places are whole in no small unit of the setup.
  if (linear && other_units_ && decimals_ <= 4 && choose_.chance(8))
    fraction += fmt::format("{}", choose_.between(1, 99'999));
  if (!choose_.chance(10)) fraction.erase(fraction.find_last_not_of('0') + 1);
  const bool no_point = magnitude % one_ == 0 && (address == 'F' || !counts_without_point_) && choose_.chance(50);
  if (no_point) return word(fmt::format("{}{}{}", address, sign, whole));
  if (whole == 0 && !fraction.empty() && choose_.chance(20))
    return word(fmt::format("{}{}.{}", address, sign, fraction));
  return word(fmt::format("{}{}{}.{}", address, sign, whole, fraction));
}

ProgramWriter& ProgramWriter::axis(char letter, std::int64_t counts) {
  std::int64_t& at = position_[letter];
  at += counts;
  return number(letter, incremental_ ? counts : at);
}

void ProgramWriter::units() {
  if (!choose_.chance(9)) return;
  const bool inch = choose_.chance(50);
  word(inch ? "G20" : "G21");
  other_units_ = inch != (setup_.units == spec::Units::inch);
  convert_positions();
}

void ProgramWriter::switch_units() {
  if (!choose_.chance(other_units_ ? 30 : 3)) return;
  if (other_units_) {
    for (auto& [letter, counts] : position_)
      if (spec::is_linear_axis(letter)) counts = converted(counts, setup_.units == spec::Units::mm);
    other_units_ = false;
  } else {
    other_units_ = true;
    convert_positions();
  }
  word((setup_.units == spec::Units::inch) != other_units_ ? "G20" : "G21").end_block();
}

void ProgramWriter::convert_positions() {
  for (auto& [letter, counts] : position_)
    if (spec::is_linear_axis(letter)) counts = in_program(counts);
}

// Near where it is not exact: generators aim with it, and the absolute words that follow are exact.
std::int64_t ProgramWriter::in_program(std::int64_t counts) const {
  return other_units_ ? converted(counts, setup_.units == spec::Units::inch) : counts;
}

void ProgramWriter::end_block() {
  if (block_.empty()) return;
  ++blocks_;
  if (numbered_ && choose_.chance(80)) text_ += fmt::format("N{} ", blocks_ * 10);
  if (calls_ && choose_.chance(12)) {
    text_ += fmt::format("M98 P{}\n", 1000 + ++called_programs_);
    called_ += fmt::format("O{}\n{}{}M99\n", 1000 + called_programs_, block_, choose_.chance(50) ? " " : "\n");
  } else {
    text_ += block_;
    text_ += '\n';
  }
  block_.clear();
  if ((idles_ || renames_) && choose_.chance(8)) idle_words();
}

void ProgramWriter::idle_words() {
  if (idles_ && (!renames_ || choose_.chance(50))) {
    text_ += choose_.one_of(
        {"G64",     "G61",       "G80 G98",  "G80 G69 G50", "G05.1 Q1", "G05.1 Q1 X0 Y0", "G05 P10000",
         "G05 P0",  "G08 P1",    "G94",      "G95 F0.2",    "G93 F3.",  "G50.1 X0 Y0",    "G22 X9. Y9. Z9. I1. J1. K1.",
         "G23",     "G15 G13.1", "G97 S800", "G96 S100",    "G09",      "G62 G67 G40.1",  "G54.1",
         "G94 F300"});
  } else {
    const char axis = choose_.one_of({'X', 'Y', 'Z'});
    if (!setup_.axes.has(axis)) return;
    const std::string value = fmt::format("{}{}.", axis, choose_.between(-30, 30));
    switch (choose_.below(5)) {
      case 0:
        text_ += "G52 " + value;
        break;
      case 1:
        text_ += fmt::format("{} P{}", choose_.chance(70) ? "G54.1" : "G54", choose_.one_of({1, 2, 48, 49}));
        break;
      case 2:
        text_ += fmt::format("G10 L2 P{} {}", choose_.between(0, 7), value);
        break;
      case 3:
        text_ += fmt::format("{} G10 L20 P{} {}", incremental_ ? "G91" : "G90", choose_.between(0, 3), value);
        break;
      default:
        text_ += "G52 X0 Y0 Z0";
    }
  }
  text_ += '\n';
  ++blocks_;
}

std::int64_t ProgramWriter::at(char letter) const {
  const auto found = position_.find(letter);
  return found == position_.end() ? 0 : found->second;
}

Pose ProgramWriter::pose() const {
  Pose pose;
  for (const auto& [letter, counts] : position_)
    if (spec::is_rotary_axis(letter)) pose[letter] = static_cast<double>(counts) / static_cast<double>(one_);
  return pose;
}

}  // namespace toolcomp::fuzz
