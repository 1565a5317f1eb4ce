// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/program/codes.h"

#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/program/offset_memory.h"
#include "spec/language/fanuc/g_codes.h"

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

constexpr std::size_t kAdditional = 6;  // of G54.1 P1

class Reader {
 public:
  Reader(Codes& codes, const Words& words, Recorder& recorder) : codes_(codes), recorder_(recorder) {
    const spec::Decimal* const p = words.find('P');
    high_speed_ = p != nullptr && plain(*p) == 10000;
  }

  // False if there is no such code.
  bool read(std::uint64_t code) {
    using enum spec::GCode;
    switch (code) {
      case kG00:
        return group(codes_.motion, Motion::rapid);
      case kG01:
        return group(codes_.motion, Motion::linear);
      case kG02:
        return group(codes_.motion, Motion::arc_cw);
      case kG03:
        return group(codes_.motion, Motion::arc_ccw);
      case kG04:
        codes_.letters_are_data = true;
        return one_shot(OneShot::dwell);
      case kG05:
        codes_.refused_in_space = codes_.refused_in_space || !high_speed_;
        [[fallthrough]];
      case kG05_1:
      case kG22:
      case kG50_1:
        codes_.letters_are_data = true;
        return without_effect();
      case kG08:
      case kG09:
      case kG11:
      case kG13_1:
      case kG15:
      case kG23:
      case kG25:
      case kG40_1:
      case kG50:
      case kG50_2:
      case kG61:
      case kG61_1:
      case kG62:
      case kG63:
      case kG64:
      case kG67:
      case kG69:
      case kG113:
      case kG150:
        return without_effect();
      case kG96:
      case kG97:
      case kG160:
        codes_.refused_in_space = true;
        return without_effect();
      case kG10:
        codes_.letters_are_data = true;
        return one_shot(OneShot::data);
      case kG17:
        return group(codes_.plane, spec::Plane::xy);
      case kG18:
        return group(codes_.plane, spec::Plane::zx);
      case kG19:
        return group(codes_.plane, spec::Plane::yz);
      case kG20:
        return group(codes_.units, spec::Units::inch);
      case kG21:
        return group(codes_.units, spec::Units::mm);
      case kG28:
        return one_shot(OneShot::reference);
      case kG29:
        return one_shot(OneShot::from_reference);
      case kG30:
        return one_shot(OneShot::other_reference);
      case kG30_1:
        return one_shot(OneShot::floating_reference);
      case kG37:
        return one_shot(OneShot::measure);
      case kG39:
        return one_shot(OneShot::corner_arc);
      case kG40:
        return group(codes_.compensation, Compensation::cancel);
      case kG41:
        return group(codes_.compensation, Compensation::left);
      case kG41_2:
        return group(codes_.compensation, Compensation::tool_side_left);
      case kG41_3:
        return group(codes_.compensation, Compensation::leading_edge);
      case kG41_6:
        return group(codes_.compensation, Compensation::directed_tool_side_left);
      case kG42:
        return group(codes_.compensation, Compensation::right);
      case kG42_2:
        return group(codes_.compensation, Compensation::tool_side_right);
      case kG42_6:
        return group(codes_.compensation, Compensation::directed_tool_side_right);
      case kG43:
        return group(codes_.length, LengthCode::plus);
      case kG43_4:
        return group(codes_.length, LengthCode::tip_control);
      case kG43_5:
        return group(codes_.length, LengthCode::tool_direction);
      case kG44:
        return group(codes_.length, LengthCode::minus);
      case kG45:
        return one_shot(OneShot::increase);
      case kG46:
        return one_shot(OneShot::decrease);
      case kG47:
        return one_shot(OneShot::double_increase);
      case kG48:
        return one_shot(OneShot::double_decrease);
      case kG49:
        return group(codes_.length, LengthCode::cancel);
      case kG52:
        return one_shot(OneShot::local_coordinates);
      case kG53:
        return one_shot(OneShot::machine_coordinates);
      case kG54:
      case kG55:
      case kG56:
      case kG57:
      case kG58:
      case kG59:
        return group(codes_.workpiece, static_cast<std::size_t>((code - kG54) / 10));
      case kG54_1:
        return group(codes_.workpiece, kAdditional);
      case kG73:
      case kG83:
        return group(codes_.cycle, Cycle::pecking);
      case kG74:
      case kG76:
      case kG81:
      case kG82:
      case kG84:
      case kG85:
      case kG86:
      case kG88:
      case kG89:
        return group(codes_.cycle, Cycle::other);
      case kG80:
        return group(codes_.cycle, Cycle::cancel);
      case kG87:
        return group(codes_.cycle, Cycle::back_boring);
      case kG90:
        return group(codes_.incremental, false);
      case kG91:
        return group(codes_.incremental, true);
      case kG92:
        return one_shot(OneShot::shift);
      case kG93:
      case kG95:
        return group(codes_.feed_per_minute, false);
      case kG94:
        return group(codes_.feed_per_minute, true);
      case kG98:
        return group(codes_.to_initial_level, true);
      case kG99:
        return group(codes_.to_initial_level, false);
      default:
        return false;
    }
  }

 private:
  // fanuc.program.last-code-of-group: If a block has several G codes of one modal group, the last one counts. G04 G10
  // G28 G29 G30 G30.1 G37 G39 G45 to G48 G52 G53 and G92 exclude each other in the same way.
  void repeat() {
    recorder_.reach(Clause::fanuc_program_last_code_of_group);
    codes_.repeats = true;
  }
  template <class Code>
  bool group(std::optional<Code>& slot, Code code) {
    if (slot) repeat();
    slot = code;
    return true;
  }
  // fanuc.program.without-effect: G05 G05.1 G08 G09 G11 G13.1 G15 G22 G23 G25 G40.1 G50 G50.1 G50.2 G61 G61.1 G62 G63
  // G64 G67 G69 G96 G97 G113 G150 and G160 change nothing here. They cancel what is not supported, or they say how fast
  // and how exactly the tool runs a path, not where the path is.
  bool without_effect() {
    recorder_.reach(Clause::fanuc_program_without_effect);
    return true;
  }
  bool one_shot(OneShot code) {
    if (codes_.one_shot != OneShot::none) repeat();
    codes_.one_shot = code;
    return true;
  }

  Codes& codes_;
  Recorder& recorder_;
  bool high_speed_ = false;  // P10000 stands in the block
};

// Whether a parameter says so of an M code; one that is not given is 0.
bool is_stop_by_parameter(const Rational& code, const spec::Setup& setup) {
  const auto value = [&](std::uint32_t number) {
    const std::optional<spec::Decimal> given = setup.parameter(number);
    return given ? plain(*given) : Rational(0);
  };
  for (std::uint32_t number = 3411; number <= 3420; ++number)
    if (code == value(number)) return true;
  for (std::uint32_t first = 3421; first <= 3431; first += 2)
    if (value(first) <= code && code <= value(first + 1)) return true;
  return false;
}

void read_m(const spec::Decimal& value, const spec::Setup& setup, Codes& codes, Recorder& recorder) {
  codes.auxiliary = true;
  switch (value.digits) {
    case 2:
    case 30:
      codes.ends_program = true;
      [[fallthrough]];
    case 0:
    case 1:
      codes.stops_look_ahead = true;
      break;
    case 98:
      codes.calls = true;
      break;
    case 99:
      codes.returns = true;
      break;
    default:
      break;
  }
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
  const spec::Decimal* const p = words.find('P');
  // fanuc.program.additional-system: G54.1 selects an additional workpiece system by P1 to P48, and without P it is P1.
  recorder.reach(Clause::fanuc_program_additional_system);
  if (p == nullptr) return kAdditional;
  const Rational number = plain(*p);
  if (denominator(number) != 1 || number < 1 || number > spec::kAdditionalWorkpieces)
    throw Alarm(AlarmCause::workpiece_number);
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
  Reader reader(codes, words, recorder);
  for (const spec::Word& word : block.words()) {
    codes.any = codes.any || word.address != 'O';
    if (word.address == 'G') {
      const auto code = tenths(word.value);
      // fanuc.program.unknown-code: A G code that does not exist raises PS0010.
      if (!code || !reader.read(*code)) raise(recorder, Clause::fanuc_program_unknown_code, AlarmCause::unknown_code);
    } else if (word.address == 'M') {
      read_m(word.value, setup, codes, recorder);
    } else if (word.address == 'S' || word.address == 'T') {
      codes.auxiliary = true;
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
                     codes.length == LengthCode::tip_control || codes.length == LengthCode::tool_direction;
  if (codes.workpiece == std::size_t{0} && words.has('P') && !taken) codes.workpiece = kAdditional;
  if (codes.workpiece == kAdditional) codes.workpiece = additional_system(words, recorder);
  return codes;
}

}  // namespace toolcomp::model
