// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/rotary_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "fuzz/gen/fanuc/arc_words.h"
#include "fuzz/gen/fanuc/contour.h"
#include "fuzz/gen/fanuc/rotary_aim.h"
#include "fuzz/gen/fanuc/setups.h"
#include "fuzz/gen/fanuc/space_path.h"

namespace toolcomp::fuzz {
namespace {

class RotaryProgram {
 public:
  RotaryProgram(Choices& choose, const spec::Case& c, bool posture)
      : choose_(choose),
        setup_(c.setup),
        posture_(posture),
        write_(choose, c.setup),
        aim_(choose, write_, c.setup, posture),
        path_(choose, write_.one()),
        contour_(choose, write_.one()) {}

  std::string program(std::uint32_t blocks_wanted) {
    blocks_ = blocks_wanted + 2;
    preamble();
    do {
      mode();
    } while (write_.blocks() + 3 <= blocks_);
    if (choose_.chance(15)) write_.word(choose_.one_of({"M30", "M02"})).end_block();
    return write_.text();
  }

 private:
  void preamble() {
    const std::size_t which = choose_.weighted({70, 15, 15});
    if (which != 0 || choose_.chance(15)) write_.word(fmt::format("G{}", 17 + which));
    constexpr std::size_t normals[] = {2, 1, 0};
    normal_ = normals[which];
    if (choose_.chance(35)) switch_mode();
    write_.units();
    if (choose_.chance(6)) rename();
    if (choose_.chance(75)) {
      motion("G01");
      write_.number('F', choose_.between(1, 50) * 100 * write_.one());
    }
    if (choose_.chance(60)) travel(start_move());
    // The pose at which the mode starts.
    if (choose_.chance(60)) aim_.position();
    write_.end_block();
  }

  // The rotary axes are called otherwise from here on.
  void rename() {
    const char axis = setup_.axes.letter(setup_.axes.size() - 1 - choose_.below(2));
    if (choose_.chance(50))
      write_.word(fmt::format("G{}", 54 + choose_.below(6)));
    else
      write_.word(fmt::format("G92 {}{}.", axis, choose_.between(-12, 12) * 15));
    write_.end_block();
  }

  SpaceCounts start_move() {
    SpaceCounts move{};
    for (std::int64_t& x : move) x = choose_.chance(40) ? 0 : choose_.between(-10, 10) * 5 * write_.one();
    return move;
  }

  // From the block of the code to G49, or to the end.
  void mode() {
    write_.switch_units();
    start();
    do {
      inside();
    } while (write_.blocks() + 1 < blocks_ && !choose_.chance(4));
    if (compensated_) cancel();
    if (choose_.chance(40)) end();
  }

  void start() {
    const bool in_workpiece_system = setup_.bit(19696, 5);
    const std::uint64_t percent = !aim_.rotary()        ? 97
                                  : !aim_.complete()    ? 6
                                  : in_workpiece_system ? 4
                                  : posture_            ? 66
                                                        : 48;
    const bool by_words = choose_.chance(percent);
    if (motion_ == "G02" || motion_ == "G03") straight_code();
    write_.word(by_words ? "G43.5" : "G43.4");
    write_.word(
        fmt::format("H{}", choose_.chance(85) ? choose_.between(1, static_cast<std::int64_t>(setup_.h.size())) : 0));
    if (choose_.chance(posture_ ? 90 : 55)) write_.word(choose_.chance(posture_ ? 88 : 25) ? "P1" : "P0");
    if (by_words && choose_.chance(18)) lean();
    if (choose_.chance(35)) travel(start_move());
    if (!by_words && choose_.chance(25)) aim_.position();
    const bool at_once = by_words && (aim_.head() || !aim_.rotary()) && choose_.chance(30);
    aim_.start(by_words);
    if (at_once) aim_.turn();
    write_.end_block();
  }

  void lean() {
    const std::int64_t thousandths =
        choose_.chance(60)   ? choose_.one_of<std::int64_t>({2000, 3000, 5000, -2000, 10'000})
        : choose_.chance(80) ? choose_.between(-20'000, 20'000)
                             : choose_.one_of<std::int64_t>({90'000, 1, -1, 180'000, 45'000});
    write_.number('Q', thousandths * write_.one() / 1000);
  }

  void end() {
    write_.word("G49");
    if (choose_.chance(30)) {
      straight_code();
      travel(start_move());
    }
    aim_.end();
    write_.end_block();
    if (choose_.chance(5)) rename();
    for (std::int64_t n = choose_.between(0, 2); n > 0; --n) {
      straight_code();
      travel(path_.movement(aim_.aim()));
      if (choose_.chance(30)) aim_.position();
      write_.end_block();
    }
  }

  // Movements

  void motion(std::string_view code) {
    if (motion_ == code && !choose_.chance(8)) return;
    motion_ = code;
    write_.word(code);
  }

  void straight_code() {
    const bool straight = motion_ == "G00" || motion_ == "G01";
    if (!straight || choose_.chance(8)) motion(choose_.chance(80) ? "G01" : "G00");
  }

  void switch_mode() {
    write_.incremental(!write_.incremental());
    write_.word(write_.incremental() ? "G91" : "G90");
  }

  void travel(const SpaceCounts& move) {
    for (std::size_t i = 0; i < 3; ++i)
      if (move.at(i) != 0 || choose_.chance(8)) write_.axis("XYZ"[i], move.at(i));
    if (setup_.axes.has('U') && choose_.chance(20)) write_.axis('U', choose_.between(-5, 5) * write_.one());
    path_.follow(move);
    Segment s;
    s.travel = {move.at((normal_ + 1) % 3), move.at((normal_ + 2) % 3)};
    contour_.follow(s);
  }

  void straight(std::uint64_t turn_percent) {
    straight_code();
    const bool turn = choose_.chance(turn_percent);
    const bool first = turn && choose_.chance(40);
    if (first) aim_.turn();
    SpaceCounts move = path_.movement(aim_.aim());
    if (choose_.chance(6)) move = {};
    travel(move);
    if (turn && !first) aim_.turn();
  }

  // A radius that lies between half the chord and a lot.
  void arc() {
    const Segment s = contour_.arc();
    const bool closed = s.travel == PlaneCounts{};
    if (aim_.by_words() && closed) return straight(50);
    motion(s.clockwise ? "G02" : "G03");
    const std::int64_t in_plane[] = {s.travel.x, s.travel.y};
    for (const std::size_t i : {0U, 1U})
      if (in_plane[i] != 0 || (!closed && choose_.chance(20))) write_.axis("XYZ"[(normal_ + 1 + i) % 3], in_plane[i]);
    SpaceCounts move{};
    move.at((normal_ + 1) % 3) = s.travel.x;
    move.at((normal_ + 2) % 3) = s.travel.y;
    if (choose_.chance(15)) {  // a helix
      move.at(normal_) = choose_.between(-6, 6) * 5 * write_.one();
      write_.axis("XYZ"[normal_], move.at(normal_));
    }
    if (aim_.by_words())
      arc_words_by_radius(write_, s);
    else
      arc_words(choose_, write_, s, center_letters(normal_));
    const bool turn = choose_.chance(60);
    if (turn) aim_.turn();
    contour_.follow(s);
    path_.follow(move);
  }

  // In the mode

  void inside() {
    if (compensated_) return in_compensation();
    switch (choose_.weighted({50, 8, 12, 10, 4, 4, 3, 5, 3, 1})) {
      case 0:
        straight(85);
        break;
      case 1:
        straight(0);
        break;
      case 2:  // the tool alone
        straight_code();
        aim_.turn();
        break;
      case 3:
        arc();
        break;
      case 4:
        write_.word(fmt::format("H{}", choose_.between(0, static_cast<std::int64_t>(setup_.h.size()))));
        if (choose_.chance(60)) straight(50);
        break;
      case 5:
        write_.word(choose_.one_of({"M08", "S1000", "F300", "M01", "T2"}));
        break;
      case 6:
        switch_mode();
        straight(60);
        break;
      case 7:
        if (write_.blocks() + 2 < blocks_) return begin_compensation();
        straight(60);
        break;
      case 8:  // anew
        return start();
      default:
        seldom();
        break;
    }
    write_.end_block();
  }

  void seldom() {
    write_.word(
        choose_.one_of({"G43 H1", "G28 Z0",   "G54", "G92 X0",    "G53 Z0",         "G41 D1",    "P1",       "P2",
                        "Q5.",    "G43.4 P2", "G39", "G45 X1.",   "G37 Z0",         "G41.2 D1",  "G41.6 D1", "I0 J0 K0",
                        "B10.",   "C10.",     "K1.", "G43.5 Q2.", "G10 L10 P1 R5.", "G49 G43.5", "G04 P10"}));
    if (choose_.chance(40)) straight(30);
  }

  // Compensation on top

  void offset() {
    number_ = static_cast<std::uint32_t>(
        choose_.between(1, static_cast<std::int64_t>(std::max<std::size_t>(setup_.d.size(), 1))));
    write_.word(fmt::format("D{}", number_));
    const auto entry = setup_.d.find(number_);
    const std::int64_t counts = entry == setup_.d.end() ? 0 : counts_of(entry->second.geometry, setup_);
    path_.offset(counts);
  }

  void begin_compensation() {
    const std::size_t kind = choose_.weighted({45, 40, 15});
    straight_code();
    if (kind == 2) {
      write_.word("G41.3");
    } else {
      write_.word(fmt::format("G4{}.{}", kind + 1, aim_.by_words() ? 6 : 2));
    }
    offset();
    compensated_ = true;
    const bool alone = kind == 2 || setup_.bit(5003, 1);
    if (alone) {
      write_.end_block();
    }
    straight(35);
    write_.end_block();
  }

  void in_compensation() {
    switch (choose_.weighted({60, 14, 12, 4, 10})) {
      case 0:
        straight(45);
        break;
      case 1:
        straight(0);
        break;
      case 2:
        straight_code();
        aim_.turn();
        break;
      case 3:
        arc();
        break;
      default:
        return cancel();
    }
    write_.end_block();
  }

  void cancel() {
    straight_code();
    write_.word("G40");
    if (setup_.bit(5003, 1) || choose_.chance(20)) write_.end_block();
    straight(30);
    write_.end_block();
    compensated_ = false;
  }

  Choices& choose_;
  const spec::Setup& setup_;
  bool posture_;
  ProgramWriter write_;
  RotaryAim aim_;
  SpacePath path_;
  Contour contour_;
  std::size_t normal_ = 2;
  std::uint32_t blocks_ = 0;
  std::uint32_t number_ = 0;
  std::string motion_;
  bool compensated_ = false;
};

}  // namespace

spec::Case rotary_case(Choices& choose, std::uint32_t blocks, bool posture) {
  spec::Case c;
  c.setup = random_rotary_setup(choose);
  c.samples = static_cast<std::uint32_t>(choose.weighted({25, 5, 30, 15, 25}));
  c.program = RotaryProgram(choose, c, posture).program(blocks);
  return c;
}

}  // namespace toolcomp::fuzz
