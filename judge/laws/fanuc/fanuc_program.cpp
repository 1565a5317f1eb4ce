// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/fanuc_program.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string_view>

#include "judge/laws/numbers.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/input_error.h"

namespace toolcomp::judge::laws {
namespace {

bool among(int code, std::initializer_list<int> codes) { return std::ranges::find(codes, code) != codes.end(); }

bool is_motion(int code) { return among(code, {kG00, kG01, kG02, kG03}); }
bool is_length(int code) { return among(code, {kG43, kG44, kG49, kG43_4, kG43_5}); }
bool is_compensation(int code) { return among(code, {kG40, kG41, kG42, kG41_2, kG42_2, kG41_3, kG41_6, kG42_6}); }

bool is_cycle(int code) {
  return among(code, {kG73, kG74, kG76, kG81, kG82, kG83, kG84, kG85, kG86, kG87, kG88, kG89});
}

// G04 and G10 have words of their own; to the rest of the block these letters alone say what they always say.
bool is_shared_with_data(char address) {
  constexpr std::string_view letters = "GDHFMSTNO";
  return letters.find(address) != std::string_view::npos;
}

// The position may get another name, or leave the path altogether.
bool is_renaming(int code) {
  return among(code, {kG43_4, kG43_5, kG49, kG92, kG28, kG29, kG30, kG30_1, kG53, kG52, kG20, kG21, kG10, kG37}) ||
         (code >= kG54 && code < kG60);
}

// Of the codes that hold for their block alone the last one counts.
void keep_last_one_shot(std::vector<spec::Word>& words) {
  const auto is_one_shot = [](const spec::Word& w) {
    return w.address == 'G' && among(code_of(w.value), {kG04, kG10, kG28, kG29, kG30, kG30_1, kG37, kG39, kG45, kG46,
                                                        kG47, kG48, kG52, kG53, kG92});
  };
  const auto last = std::find_if(words.rbegin(), words.rend(), is_one_shot);
  if (last == words.rend()) return;
  const spec::Word kept = *last;
  std::erase_if(words, is_one_shot);
  words.push_back(kept);
}

std::optional<std::uint64_t> number(const spec::Decimal& d) {
  if (d.negative && d.digits != 0) return std::nullopt;
  if (d.decimals != 0) return std::nullopt;
  return d.digits;
}

// P belongs to another code than that of a system.
bool takes_p(const FanucBlock& b, bool takes_letters) {
  constexpr std::array kTakesP{kG30, kG43_4, kG43_5};
  const bool calls = std::ranges::any_of(
      b.words, [](const spec::Word& w) { return w.address == 'M' && (w.value.digits == 98 || w.value.digits == 99); });
  return takes_letters || calls || std::ranges::any_of(kTakesP, [&b](int code) { return b.has_code(code); });
}

// The system that P of G54.1, or of G54, selects.
std::optional<int> additional_system(const FanucBlock& b, bool takes_letters) {
  if (takes_p(b, takes_letters)) return std::nullopt;
  const spec::Decimal* const p = b.value('P');
  const auto n = p == nullptr ? 1 : number(*p);
  if (!n) return std::nullopt;
  // Beyond the last one there is an alarm.
  return kSystems + static_cast<int>(std::min<std::uint64_t>(*n, spec::kAdditionalWorkpieces + 1));
}

// G52 and G92 have the words of their block to themselves.
bool has_words_of_its_own(const FanucBlock& b) { return b.has_code(kG52) || b.has_code(kG92); }

// What nobody says of a block in the drilling mode, or a control refuses.
bool makes_drilling_doubtful(const FanucBlock& b) {
  constexpr std::array kCodes{kG28, kG29, kG30, kG30_1, kG31, kG37, kG39, kG43_4, kG43_5, kG53};
  return b.compensation != kG40 || std::ranges::any_of(kCodes, [&b](int code) { return b.has_code(code); });
}

char drilling_axis(const spec::Setup& setup, int plane) {
  if (!setup.bit(5101, 0)) return 'Z';
  return plane == kG19 ? 'X' : plane == kG18 ? 'Y' : 'Z';
}

// Takes the last length from the block, if there is one.
void take(std::optional<CycleLength>& length, const FanucBlock& b, char address) {
  const spec::Decimal* const word = b.value(address);
  if (word == nullptr) return;
  if (std::ranges::count(b.words, address, &spec::Word::address) > 1)
    length.reset();
  else
    length = CycleLength{*word, b.absolute, b.inches};
}

exact::Rational sum(const spec::OffsetEntry& entry, spec::OffsetMemory memory) {
  exact::Rational value = rational(entry.geometry);
  if (memory != spec::OffsetMemory::a) value += rational(entry.wear);
  return value;
}

// In memories A and B a number that one table alone gives holds for both.
std::optional<exact::Rational> offset(const spec::Setup& setup, std::uint64_t n,
                                      const std::map<std::uint32_t, spec::OffsetEntry>& own,
                                      const std::map<std::uint32_t, spec::OffsetEntry>& other) {
  if (n == 0) return exact::Rational(0);
  if (n > setup.offset_count) return std::nullopt;
  const auto key = static_cast<std::uint32_t>(n);
  if (const auto found = own.find(key); found != own.end()) return sum(found->second, setup.memory);
  if (setup.memory != spec::OffsetMemory::c)
    if (const auto found = other.find(key); found != other.end()) return sum(found->second, setup.memory);
  return exact::Rational(0);
}

}  // namespace

exact::Rational programmed_length(const spec::Setup& setup, bool inches, const spec::Decimal& word) {
  exact::Rational value = rational(word);
  if (word.point || setup.bit(3401, 0, true)) return value;
  const int counts = setup.increment == spec::IncrementSystem::is_a   ? 100
                     : setup.increment == spec::IncrementSystem::is_b ? 1000
                                                                      : 10000;
  value /= exact::Rational(inches ? 10 * counts : counts);
  return value;
}

exact::Rational length_of(const spec::Setup& setup, bool inches, const spec::Decimal& word) {
  exact::Rational value = programmed_length(setup, inches, word);
  const bool shown_in_inches = setup.units == spec::Units::inch;
  if (inches && !shown_in_inches) value *= exact::Rational(127, 5);
  if (!inches && shown_in_inches) value *= exact::Rational(5, 127);
  return value;
}

std::optional<exact::Rational> length_value(const spec::Setup& setup, std::uint64_t n) {
  return offset(setup, n, setup.h, setup.d);
}
std::optional<exact::Rational> cutter_value(const spec::Setup& setup, std::uint64_t n) {
  return offset(setup, n, setup.d, setup.h);
}

bool FanucBlock::has(char address) const { return value(address) != nullptr; }

int code_of(const spec::Decimal& d) {
  std::uint64_t digits = d.digits;
  int decimals = d.decimals;
  // G41.00 is G41.
  for (; decimals > 1 && digits % 10 == 0; --decimals) digits /= 10;
  if (d.negative || decimals > 1 || digits > 9999) return -1;
  return static_cast<int>(decimals == 1 ? digits : digits * 10);
}

bool FanucBlock::has_code(int code) const {
  return std::ranges::any_of(words, [&](const spec::Word& w) { return w.address == 'G' && code_of(w.value) == code; });
}

const spec::Decimal* FanucBlock::value(char address) const {
  const spec::Decimal* last = nullptr;
  for (const spec::Word& w : words)
    if (w.address == address) last = &w.value;
  return last;
}

std::optional<std::uint64_t> FanucBlock::repeats() const {
  constexpr std::uint64_t most = 9999;
  const char address = has('K') ? 'K' : 'L';
  const spec::Decimal* const word = value(address);
  if (word == nullptr) return 1;
  const auto times = number(*word);
  const bool twice = std::ranges::count(words, address, &spec::Word::address) > 1;
  if (word->point || word->negative || twice || !times || *times > most) return std::nullopt;
  return times;
}

bool FanucBlock::cancels_its_cycle() const {
  const auto has_one = [this](bool (*is)(int)) {
    return std::ranges::any_of(words, [is](const spec::Word& w) { return w.address == 'G' && is(code_of(w.value)); });
  };
  return has_one(is_cycle) && has_one(is_motion);
}

bool FanucBlock::says_compensation() const {
  return std::ranges::any_of(words,
                             [](const spec::Word& w) { return w.address == 'G' && is_compensation(code_of(w.value)); });
}

bool FanucBlock::is_plain() const {
  return !drilling && std::ranges::all_of(words, [](const spec::Word& w) {
    if (w.address == 'G') {
      const int code = code_of(w.value);
      return is_motion(code) || is_compensation(code) || code == kG90 || code == kG91;
    }
    return w.address != 'M' && w.address != 'L' && w.address != 'P' && w.address != 'Q' && w.address != 'H';
  });
}

FanucProgram::FanucProgram(const spec::Case& c) {
  if (c.setup.control != spec::Control::fanuc) return;
  length_renames_ = c.setup.bit(5006, 6);
  any_block_may_ = c.setup.bit(5001, 6);
  FanucBlock state;
  state.inches = c.setup.units == spec::Units::inch;
  try {
    spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes, spec::reader_options(c.setup));
    const auto block = std::make_unique<spec::Block>();
    while (reader.next(*block) && !block->alarm) {
      state.line = block->line;
      state.words.assign(block->words().begin(), block->words().end());
      // A code that another one excludes keeps its letters.
      constexpr std::array kTakesLetters{kG04, kG05, kG05_1, kG10, kG22, kG50_1};
      const bool takes_letters =
          std::ranges::any_of(kTakesLetters, [&state](int code) { return state.has_code(code); });
      if (takes_letters)
        std::erase_if(state.words, [](const spec::Word& w) { return !is_shared_with_data(w.address); });
      keep_last_one_shot(state.words);
      for (const spec::Word& w : state.words) {
        calls_ = calls_ || (w.address == 'M' && (w.value.digits == 98 || w.value.digits == 99));
        if (w.address == 'D') state.d = number(w.value);
        if (w.address == 'H') state.h = number(w.value);
        if (w.address != 'G') continue;
        const int code = code_of(w.value);
        if (is_motion(code)) state.motion = code;
        if (is_length(code)) state.length = code;
        if (is_compensation(code)) state.compensation = code;
        if (among(code, {kG17, kG18, kG19})) state.plane = code;
        if (among(code, {kG90, kG91})) state.absolute = code == kG90;
        if (among(code, {kG20, kG21})) state.inches = code == kG20;
        if (code >= kG54 && code <= kG59 && code % 10 == 0) state.system = code / 10 - 53;
        const bool with_p = code == kG54 && state.value('P') != nullptr && !takes_p(state, takes_letters);
        if (code == kG54_1 || with_p) state.system = additional_system(state, takes_letters);
        if (among(code, {kG43_4, kG43_5})) {
          const spec::Decimal* p = state.value('P');
          state.posture = p != nullptr ? p->digits != 0 : c.setup.bit(19604, 0);
        }
      }
      follow_drilling(state, c.setup, takes_letters);
      blocks_.push_back(state);
    }
    complete_ = !block->alarm;
  } catch (const spec::InputError&) {  // NOLINT(bugprone-empty-catch): the run says so, where it comes so far
  }
}

void FanucProgram::follow_drilling(FanucBlock& state, const spec::Setup& setup, bool takes_letters) {
  int cycle = 0;
  bool motion = false;
  for (const spec::Word& w : state.words) {
    if (w.address != 'G') continue;
    const int code = code_of(w.value);
    if (is_cycle(code)) cycle = code;
    if (code == kG98 || code == kG99) state.to_point_r = code == kG99;
    motion = motion || is_motion(code);
  }
  const bool ends = state.has_code(kG80);
  state.drills = false;
  if (motion || (ends && cycle == 0)) state.drilling.reset();
  if (!motion && cycle != 0) {
    if (!state.drilling) {
      state.drilling.emplace();
      state.drilling->begun = blocks_.size();
      state.drilling->axis = drilling_axis(setup, state.plane);
    }
    state.drilling->cycle = cycle;
    if (ends || takes_letters) state.drilling->clear = false;
  }
  if (!state.drilling) return;
  drills_ = true;
  DrillingMode& mode = *state.drilling;
  if (makes_drilling_doubtful(state) || mode.axis != drilling_axis(setup, state.plane)) mode.clear = false;
  state.drills = state.has('R') ||
                 std::ranges::any_of(state.words, [&setup](const spec::Word& w) { return setup.axes.has(w.address); });
  const bool units = state.has_code(kG20) || state.has_code(kG21);
  for (std::optional<CycleLength>* length : {&mode.point_r, &mode.bottom})
    if (*length && (units || has_words_of_its_own(state) || ((*length)->absolute && renames_in(state))))
      length->reset();
  if (has_words_of_its_own(state)) return;
  take(mode.point_r, state, 'R');
  take(mode.bottom, state, mode.axis);
}

std::size_t FanucProgram::index(std::uint64_t line) const {
  if (calls_) return blocks_.size();
  const auto found = std::ranges::lower_bound(blocks_, line, {}, &FanucBlock::line);
  if (found == blocks_.end() || found->line != line) return blocks_.size();
  if (const auto next = found + 1; next != blocks_.end() && next->line == line) return blocks_.size();
  return static_cast<std::size_t>(found - blocks_.begin());
}

bool FanucProgram::has_code(std::initializer_list<int> codes) const {
  return std::ranges::any_of(blocks_, [&](const FanucBlock& b) {
    return std::ranges::any_of(codes, [&](int code) { return b.has_code(code); });
  });
}

bool FanucProgram::renames_in(const FanucBlock& b) const {
  if (length_renames_ && any_block_may_) return true;
  return std::ranges::any_of(b.words, [this](const spec::Word& w) {
    if (w.address != 'G') return length_renames_ && w.address == 'H';
    const int code = code_of(w.value);
    return code == kG49 ? length_renames_ : is_renaming(code) || (length_renames_ && is_length(code));
  });
}

bool FanucProgram::renames_at(std::size_t block) const { return renames_in(blocks_[block]); }

bool FanucProgram::renames(std::size_t from, std::size_t to) const {
  if (length_renames_ && any_block_may_) return true;
  for (std::size_t i = from + 1; i <= to && i < blocks_.size(); ++i)
    if (blocks_[i].drills || blocks_[i].has_code(kG49) || renames_in(blocks_[i])) return true;
  return false;
}

}  // namespace toolcomp::judge::laws
