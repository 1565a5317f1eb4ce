// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/screen.h"

#include <algorithm>
#include <array>
#include <optional>

#include "spec/language/byte_source.h"
#include "spec/language/decimal_order.h"
#include "spec/language/fanuc/g_codes.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::kit {
namespace {

using enum spec::GCode;

// A code in tenths: 412 for G41.2.
std::optional<std::uint64_t> code_of(const spec::Word& word) {
  if (word.value.negative || word.value.decimals > 1) return std::nullopt;
  return word.value.decimals == 1 ? word.value.digits : word.value.digits * 10;
}

// What neither leaves a trace behind the case nor needs what a bare machine does not have. G20, G21, G28, G30 and G37
// are asked about by themselves.
constexpr std::array<std::uint64_t, 35> kCodes = {kG00, kG01,   kG02,   kG03,   kG10,   kG17,   kG18, kG19,   kG29,
                                                  kG39, kG40,   kG41,   kG41_2, kG41_3, kG41_6, kG42, kG42_2, kG42_6,
                                                  kG43, kG43_4, kG43_5, kG44,   kG45,   kG46,   kG47, kG48,   kG49,
                                                  kG53, kG54,   kG90,   kG91,   kG94,   kG37,   kG28, kG30};

std::string g(std::uint64_t code) {
  return "G" + std::to_string(code / 10) + (code % 10 != 0 ? "." + std::to_string(code % 10) : "");
}

const spec::Word* find(const spec::Block& block, char address) {
  const spec::Word* found = nullptr;
  for (const spec::Word& word : block.words())
    if (word.address == address) found = &word;
  return found;
}

std::string refuse_code(const Machine& machine, const spec::Block& block, std::uint64_t code) {
  const spec::Setup& setup = machine.setup;
  if (code == kG20 || code == kG21) {
    const bool same = (code == kG20) == (setup.units == spec::Units::inch);
    return same ? "" : g(code) + " changes the units of the control";
  }
  if (code == kG28 && !setup.reference.contains(1)) return "the setup does not give reference position 1";
  if (code == kG30) {
    const spec::Word* const p = find(block, 'P');
    const int number = p != nullptr ? static_cast<int>(std::min<std::uint64_t>(p->value.digits, 9)) : 2;
    if (number >= 1 && number <= 4 && !setup.reference.contains(number))
      return "the setup does not give reference position " + std::to_string(number) + " is";
  }
  if (code == kG30_1)
    return setup.floating_reference.empty() ? "the setup does not give the floating reference position" : "";
  if (code == kG37 && setup.measurement.empty()) return "the setup has no measuring signal ([measurement])";
  if (code == kG10) {
    const spec::Word* const l = find(block, 'L');
    const bool offsets = l != nullptr && l->value.is_integer() &&
                         (l->value.digits == 1 || (l->value.digits >= 10 && l->value.digits <= 13));
    if (!offsets) return "G10 without L1 or L10 to L13 may write anything";
  }
  // It is G54.1 then.
  if (code == kG54 && find(block, 'P') != nullptr) return "G54 with P: the other workpiece systems belong to the user";
  if (std::ranges::find(kCodes, code) != kCodes.end()) return {};
  if (code >= kG55 && code <= kG59) return g(code) + ": the other workpiece systems belong to the user";
  if (code == kG04) return "a dwell inside it would look like a mark";
  if (code == kG92) return "G92 leaves the coordinates shifted";
  return g(code) + " may have a meaning in the control, and has none in the model";
}

std::string refuse_feed(const spec::Setup& setup, const spec::Decimal& value) {
  const spec::Decimal most = spec::decimal(setup.units == spec::Units::inch ? 400 : 10000);
  if (value.negative || value.is_zero()) return "a feed of 0 or below";
  return spec::compare(value, most) == std::strong_ordering::greater ? "a feed above " + spec::to_string(most) : "";
}

std::string refuse_number(const Machine& machine, const spec::Word& word) {
  constexpr std::uint64_t kMostDigits = 99'999'999;  // eight
  const bool rotary = spec::is_rotary_axis(word.address) || word.address == 'Q';
  if (std::string_view("FGHDPNL").find(word.address) != std::string_view::npos) return {};
  if (word.value.digits > kMostDigits) return "a number with more than eight digits";
  if (!is_enterable(word.value, decimals_of(machine.setup, !rotary)))
    return "a number finer than the least increment of the machine";
  return {};
}

std::string refuse_word(const Machine& machine, const spec::Block& block, const spec::Word& word) {
  switch (word.address) {
    case 'M':
    case 'S':
    case 'T':
      return std::string(1, word.address) + " words may start something that is not safe on an empty machine";
    case 'O':
      return "a program number inside it";
    case 'L':
      return find(block, 'G') == nullptr ? "L words may repeat a block" : "";
    case 'F':
      return refuse_feed(machine.setup, word.value);
    case 'G':
      if (const auto code = code_of(word)) return refuse_code(machine, block, *code);
      return "a G code that does not exist";
    default:
      return refuse_number(machine, word);
  }
}

// Whether the block ends the program and does nothing else.
bool only_ends(const spec::Block& block) {
  return block.size == 1 && block.word[0].address == 'M' && block.word[0].value.is_integer() &&
         (block.word[0].value.digits == 2 || block.word[0].value.digits == 30);
}

std::vector<spec::Block> read_blocks(const spec::Case& vector, const spec::Axes& axes) {
  std::vector<spec::Block> blocks;
  spec::ProgramReader reader(spec::text_source(vector.program), axes, {.file = vector.id});
  spec::Block block;
  while (reader.next(block)) blocks.push_back(block);
  return blocks;
}

spec::Decimal range_of(const spec::Setup& setup, bool wear) {
  // 999.999 at IS-B: six digits, five for wear; inches have one digit more behind the point.
  const int decimals = decimals_of(setup, true);
  std::uint64_t digits = 0;
  for (int i = decimals + (wear ? 2 : 3) - (setup.units == spec::Units::inch ? 1 : 0); i > 0; --i)
    digits = digits * 10 + 9;
  return {digits, static_cast<std::uint8_t>(decimals), false, false};
}

}  // namespace

int decimals_of(const spec::Setup& setup, bool length) {
  const int decimals = setup.increment == spec::IncrementSystem::is_a   ? 2
                       : setup.increment == spec::IncrementSystem::is_b ? 3
                                                                        : 4;
  return length && setup.units == spec::Units::inch ? decimals + 1 : decimals;
}

bool is_enterable(const spec::Decimal& value, int decimals) {
  std::uint64_t digits = value.digits;
  int behind = value.decimals;
  for (; behind > decimals && digits % 10 == 0; --behind) digits /= 10;
  return behind <= decimals;
}

bool fits_memory(const spec::Setup& setup, const spec::OffsetEntry& entry) {
  const auto fits = [&](spec::Decimal value, bool wear) {
    value.negative = false;
    return is_enterable(value, decimals_of(setup, true)) &&
           spec::compare(value, range_of(setup, wear)) != std::strong_ordering::greater;
  };
  return fits(entry.geometry, false) && fits(entry.wear, true);
}

Screened screen(const Machine& machine, const spec::Case& vector) {
  if (std::ranges::find(vector.flags, "generated-unrestricted") != vector.flags.end())
    return {{}, "its words are random"};
  if (vector.program.find('/') != std::string::npos) return {{}, "it depends on the block skip switch of the panel"};
  Screened screened;
  try {
    screened.blocks = read_blocks(vector, machine.setup.axes);
  } catch (const spec::InputError& error) {
    return {{}, "its text cannot be read: " + error.message()};
  }
  while (!screened.blocks.empty() && only_ends(screened.blocks.back())) screened.blocks.pop_back();
  if (screened.blocks.empty()) return {{}, "it has no block"};
  for (const spec::Block& block : screened.blocks) {
    if (block.alarm)
      return {{},
              block.alarm->cause == spec::AlarmCause::unknown_address
                  ? "it names an axis that the machine does not have"
                  : "a block that cannot be read"};
    for (const spec::Word& word : block.words())
      if (std::string why = refuse_word(machine, block, word); !why.empty()) return {{}, std::move(why)};
  }
  return screened;
}

}  // namespace toolcomp::certify::kit
