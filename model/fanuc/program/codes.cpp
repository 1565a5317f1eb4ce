// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/program/codes.h"

#include <algorithm>
#include <initializer_list>
#include <type_traits>

#include "model/basis/alarm.h"
#include "model/fanuc/program/offset_memory.h"
#include "model/kinematics/mechanism.h"

namespace toolcomp::model {
namespace {

// A G number in tenths (G30.1 is 301), or nothing if it has more decimals than any code.
std::optional<std::uint64_t> tenths(const spec::Decimal& value) {
  std::uint64_t digits = value.digits;
  unsigned decimals = value.decimals;
  for (; decimals > 1; --decimals) {
    if (digits % 10 != 0) return std::nullopt;
    digits /= 10;
  }
  // No code has more than three digits; larger numbers need not be told apart.
  if (digits > 100000) return std::nullopt;
  return decimals == 1 ? digits : digits * 10;
}

using enum spec::GCode;

constexpr std::size_t kAdditional = 7;  // of G54.1 P1
constexpr spec::GCode kLettersAreData[] = {kG04, kG05, kG05_1, kG10, kG22, kG50_1};
constexpr spec::GCode kWithoutEffect[] = {kG05, kG05_1, kG08, kG09,   kG11,   kG13_1, kG15,   kG22, kG23,
                                          kG25, kG40_1, kG50, kG50_1, kG50_2, kG61,   kG61_1, kG62, kG63,
                                          kG64, kG67,   kG69, kG96,   kG97,   kG113,  kG150,  kG160};

// False if there is no such code with an effect.
bool read_group(std::uint64_t code, Codes& codes, Recorder& recorder) {
  const auto is = [&](std::initializer_list<spec::GCode> names) { return std::ranges::count(names, code) > 0; };
  // `slot`: the code of the group in the block so far.
  const auto put = [&](auto& slot, const auto& meaning) {
    // fanuc.program.last-code-of-group: If a block has several G codes of one modal group, the last one counts. G04 G10
    // G28 G29 G30 G30.1 G37 G39 G45 to G48 G52 G53 and G92 exclude each other in the same way.
    if (slot != std::remove_cvref_t<decltype(slot)>()) {
      recorder.reach(Clause::fanuc_program_last_code_of_group);
      codes.repeats = true;
    }
    slot = meaning;
    return true;
  };
  if (is({kG00, kG01, kG02, kG03})) return put(codes.motion, static_cast<Motion>(code));
  if (is({kG04, kG10, kG28, kG29, kG30, kG30_1, kG37, kG39, kG45, kG46, kG47, kG48, kG52, kG53, kG92}))
    return put(codes.one_shot, static_cast<OneShot>(code));
  if (is({kG17})) return put(codes.plane, spec::Plane::xy);
  if (is({kG18})) return put(codes.plane, spec::Plane::zx);
  if (is({kG19})) return put(codes.plane, spec::Plane::yz);
  if (is({kG20, kG21})) return put(codes.units, is({kG20}) ? spec::Units::inch : spec::Units::mm);
  if (is({kG40, kG41, kG41_2, kG41_3, kG41_6, kG42, kG42_2, kG42_6}))
    return put(codes.compensation, static_cast<Compensation>(code));
  if (is({kG43, kG43_4, kG43_5, kG44, kG49})) return put(codes.length, static_cast<LengthCode>(code));
  if (is({kG54, kG55, kG56, kG57, kG58, kG59})) return put(codes.workpiece, (code - kG54) / 10 + 1);
  if (is({kG54_1})) return put(codes.workpiece, kAdditional);
  if (is({kG80})) return put(codes.cycle, Cycle::cancel);
  if (is({kG73, kG83})) return put(codes.cycle, Cycle::pecking);
  if (is({kG87})) return put(codes.cycle, Cycle::back_boring);
  if (is({kG74, kG76, kG81, kG82, kG84, kG85, kG86, kG88, kG89})) return put(codes.cycle, Cycle::other);
  if (is({kG90, kG91})) return put(codes.incremental, is({kG91}));
  if (is({kG93, kG94, kG95})) return put(codes.feed_per_minute, is({kG94}));
  if (is({kG98, kG99})) return put(codes.to_initial_level, is({kG98}));
  return false;
}

// False if there is no such code.
bool read_g(std::uint64_t code, const Words& words, Codes& codes, Recorder& recorder) {
  codes.letters_are_data = codes.letters_are_data || std::ranges::count(kLettersAreData, code) > 0;
  // fanuc.program.without-effect: G05 G05.1 G08 G09 G11 G13.1 G15 G22 G23 G25 G40.1 G50 G50.1 G50.2 G61 G61.1 G62 G63
  // G64 G67 G69 G96 G97 G113 G150 and G160 change nothing here. They cancel what is not supported, or they say how fast
  // and how exactly the tool runs a path, not where the path is.
  if (std::ranges::count(kWithoutEffect, code) == 0) return read_group(code, codes, recorder);
  recorder.reach(Clause::fanuc_program_without_effect);
  codes.refused_in_space = codes.refused_in_space || code == kG96 || code == kG97 || code == kG160 ||
                           (code == kG05 && words.number('P', 0) != 10000);
  return true;
}

// Whether a parameter says so of an M code; one that is not given is 0.
bool is_stop_by_parameter(const Rational& code, const spec::Setup& setup) {
  for (std::uint32_t number = 3411; number <= 3420; ++number)
    if (code == parameter(setup, number)) return true;
  for (std::uint32_t first = 3421; first <= 3431; first += 2)
    if (parameter(setup, first) <= code && code <= parameter(setup, first + 1)) return true;
  return false;
}

void read_m(const spec::Decimal& value, const spec::Setup& setup, Codes& codes, Recorder& recorder) {
  const std::uint64_t number = value.digits;
  codes.ends_program = codes.ends_program || number == 2 || number == 30;
  codes.stops_look_ahead = codes.stops_look_ahead || number == 0 || number == 1 || codes.ends_program;
  codes.calls = codes.calls || number == 98;
  codes.returns = codes.returns || number == 99;
  // fanuc.program.stops-reading-ahead: M00, M01, M02 and M30 stop the control from reading ahead, and so does each M
  // code that a parameter names. Each of No. 3411 to 3420 names one M code. The pairs 3421 and 3422, 3423 and 3424, up
  // to 3431 and 3432 name all M codes from the first to the last one, these two included.
  if (!codes.stops_look_ahead && is_stop_by_parameter(plain(value), setup)) {
    recorder.reach(Clause::fanuc_program_stops_reading_ahead);
    codes.stops_look_ahead = true;
  }
}

// G10 with L2 or L20.
bool names_origin(const Words& words) {
  const spec::Decimal* const l = words.find('L');
  return l != nullptr && (l->digits == 2 || l->digits == 20);
}

// The system that G54.1 selects, behind the six of G54 to G59.
std::size_t additional_system(const Words& words, Recorder& recorder) {
  // fanuc.program.additional-system: G54.1 selects an additional workpiece system by P1 to P48, and without P it is P1.
  recorder.reach(Clause::fanuc_program_additional_system);
  const Rational number = words.number('P', 1);
  if (!is_whole(number, 1, spec::kAdditionalWorkpieces)) throw Alarm(AlarmCause::workpiece_number);
  return kAdditional + static_cast<std::size_t>(numerator(number)) - 1;
}

// An H or D number; the reader admits neither sign nor point.
std::optional<std::uint32_t> offset_number(const spec::Decimal* word, const spec::Setup& setup, Recorder& recorder) {
  if (word == nullptr) return std::nullopt;
  // fanuc.program.offset-number-range: An H or D number greater than the number of offsets raises PS0030, whatever the
  // block does with it.
  if (word->digits > setup.offset_count)
    raise(recorder, Clause::fanuc_program_offset_number_range, AlarmCause::offset_number);
  return static_cast<std::uint32_t>(word->digits);
}

}  // namespace

Words::Words(const spec::Block& block, Recorder& recorder) {
  for (const spec::Word& word : block.words()) {
    if (word.address == 'G' || word.address == 'M' || word.address == 'N' || word.address == 'O') continue;
    const spec::Decimal*& slot = word_[static_cast<std::size_t>(word.address - 'A')];
    // fanuc.program.last-word-of-address: If a block has several words with one address, the last one counts. G and M
    // words all count.
    if (slot != nullptr) {
      recorder.reach(Clause::fanuc_program_last_word_of_address);
      repeats_ = true;
    }
    slot = &word.value;
  }
}

Codes read_codes(const spec::Block& block, const Words& words, const spec::Setup& setup, Recorder& recorder) {
  Codes codes;
  for (const spec::Word& word : block.words()) {
    codes.any = codes.any || word.address != 'O';
    codes.auxiliary = codes.auxiliary || word.address == 'M' || word.address == 'S' || word.address == 'T';
    if (word.address == 'G') {
      const auto code = tenths(word.value);
      // fanuc.program.unknown-code: A G code that does not exist raises PS0010.
      if (!code || !read_g(*code, words, codes, recorder))
        raise(recorder, Clause::fanuc_program_unknown_code, AlarmCause::unknown_code);
    } else if (word.address == 'M') {
      read_m(word.value, setup, codes, recorder);
    }
  }
  // fanuc.program.address-repeated: With AD2 (3403#6) = 1 a block raises PS5074 if an address other than G, M, N and O
  // occurs twice in it, or two G codes of one group do.
  if ((words.repeats() || codes.repeats) && setup.bit(3403, 6))
    raise(recorder, Clause::fanuc_program_address_repeated, AlarmCause::address_repeated);
  const bool side = codes.compensation && is_cutter_side(*codes.compensation);
  // fanuc.cutter-c.three-dimensional: G41 or G42 in a block with all of I, J and K is three-dimensional tool
  // compensation. That section is not supported here, so the block raises PS0010, as a code that is not supported does.
  if (side && !codes.letters_are_data && words.has('I') && words.has('J') && words.has('K') &&
      setup.cutter_compensation == spec::CutterCompensationType::c)
    raise(recorder, Clause::fanuc_cutter_c_three_dimensional, AlarmCause::unknown_code,
          "three-dimensional cutter compensation is not supported");
  codes.writes_origin = codes.one_shot == OneShot::data && names_origin(words);
  // fanuc.memory.g10-kind: L of G10 says what G10 writes. In memory A it is L11; in memory B L10 for geometry, L11 for
  // wear; in memory C L10 and L11 for H, L12 and L13 for D. L1 is L11. L2 and L20 write workpiece origins
  // (fanuc.program.origin). No L, or an L that no control has, raises PS0010; an L that controls have and this project
  // does not support ends the run (fanuc.program.not-supported).
  if (codes.one_shot == OneShot::data && !codes.writes_origin && !offset_kind(words, setup.memory))
    raise(recorder, Clause::fanuc_memory_g10_kind, AlarmCause::g10_kind);
  codes.h = offset_number(words.find('H'), setup, recorder);
  codes.d = offset_number(words.find('D'), setup, recorder);
  // fanuc.program.additional-system: G54.1 selects an additional workpiece system by P1 to P48, and without P it is P1.
  // G54 with a P is G54.1 with that P, unless P belongs to another code of the block (G04 G05 G05.1 G10 G22 G30 G43.4
  // G43.5 G50.1 G73 G74 G76 G81 to G89 M98 M99). A P other than 1 to 48 raises PS0030.
  const bool taken = codes.letters_are_data || codes.calls || codes.returns ||
                     codes.one_shot == OneShot::other_reference || (codes.cycle && *codes.cycle != Cycle::cancel) ||
                     (codes.length && is_tip_control(*codes.length));
  if (codes.workpiece == std::size_t{1} && words.has('P') && !taken) codes.workpiece = kAdditional;
  if (codes.workpiece == kAdditional) codes.workpiece = additional_system(words, recorder);
  return codes;
}

}  // namespace toolcomp::model
