// SPDX-License-Identifier: Apache-2.0
// Canned cycles: holes one by one, in rows by K, with data kept from block to block, contours and offsets between them.
#include <fmt/format.h>

#include "fuzz/gen/fanuc/program_writer.h"
#include "fuzz/gen/fanuc/setups.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {
namespace {

class CannedCycles {
 public:
  CannedCycles(Choices& choose, spec::Case& c)
      : choose_(choose), case_(c), write_(choose, c.setup), by_plane_(c.setup.bit(5101, 0)) {}

  std::string program(std::uint32_t blocks) {
    write_.units();
    if (choose_.chance(40)) switch_mode();
    if (choose_.chance(60)) write_.word("G00");
    if (choose_.chance(80)) feed();
    if (choose_.chance(85)) places();
    write_.end_block();
    if (choose_.chance(75)) offset();
    while (write_.blocks() < blocks) block();
    if (choose_.chance(10)) write_.word(choose_.one_of({"M30", "M02"})).end_block();
    return write_.text();
  }

 private:
  void block() {
    if (!on_) return outside();
    switch (choose_.weighted({40, 12, 10, 8, 6, 5, 4, 4, 12, 3})) {
      case 0:
        return hole();
      case 1:
        return row();
      case 2:
        return begin();
      case 3:
        returns();
        return choose_.chance(60) ? hole() : write_.end_block();
      case 4:
        switch_mode();
        return choose_.chance(85) ? hole() : write_.end_block();
      case 5:
        return offset();
      case 6:
        return rename();
      case 7:
        write_.word(choose_.one_of({"M08", "G04 P200", "S900", "G04 X1.", "Q2.", "F300.", "G45 X5. D1", "G46 D1"}));
        return write_.end_block();
      case 8:
        return end();
      default:
        return seldom();
    }
  }

  void outside() {
    switch (choose_.weighted({48, 18, 8, 10, 6, 5, 5})) {
      case 0:
        return begin();
      case 1:
        if (choose_.chance(50)) write_.word(choose_.one_of({"G00", "G01"}));
        places();
        return write_.end_block();
      case 2:
        return offset();
      case 3:
        return contour();
      case 4:
        switch_mode();
        places();
        return write_.end_block();
      case 5:
        write_.word(choose_.one_of({"G17", "G18", "G19", "G98", "G99", "G80", "G49", "G94", "G95 F0.2", "G46 X5. D1"}));
        return write_.end_block();
      default:
        return rename();
    }
  }

  void feed() { write_.number('F', choose_.between(1, 50) * 10 * write_.one()); }
  void switch_mode() {
    write_.incremental(!write_.incremental());
    write_.word(write_.incremental() ? "G91" : "G90");
  }
  void returns() { write_.word(choose_.one_of({"G98", "G99"})); }

  [[nodiscard]] char drilling_axis() const { return by_plane_ ? "ZYX"[plane_] : 'Z'; }

  // Mostly round figures; a travel of 0 is ordinary.
  std::int64_t travel() {
    const std::int64_t one = write_.one();
    switch (choose_.weighted({70, 20, 10})) {
      case 0:
        return choose_.between(-12, 12) * 5 * one;
      case 1:
        return choose_.between(-60 * one, 60 * one);
      default:
        return 0;
    }
  }

  // Words of some axes, as positions.
  void places() {
    for (const char letter : case_.setup.axes.letters())
      if (choose_.chance(spec::is_linear_axis(letter) ? 55 : 15)) write_.axis(letter, travel());
  }

  // Of the hole: axes but the drilling axis.
  bool position() {
    bool any = false;
    for (const char letter : case_.setup.axes.letters()) {
      if (letter == drilling_axis() || !choose_.chance(letter == 'X' || letter == 'Y' ? 65 : 8)) continue;
      write_.axis(letter, travel());
      any = true;
    }
    return any;
  }

  // Point R a little below the initial level or anywhere, the bottom below it: written as the mode asks.
  void point_r() {
    const std::int64_t one = write_.one();
    const std::int64_t down = choose_.chance(85) ? -choose_.between(0, 30) * one : choose_.between(0, 99) * one / 7;
    write_.number('R', write_.incremental() ? down : write_.at(drilling_axis()) + down);
  }
  void bottom() {
    const std::int64_t one = write_.one();
    const std::int64_t deep = choose_.chance(85) ? -choose_.between(1, 40) * one : choose_.between(-99, 99) * one / 7;
    write_.number(drilling_axis(), write_.incremental() ? deep : deep + write_.at(drilling_axis()) - 30 * one);
  }
  void depth_of_cut() { write_.number('Q', choose_.chance(95) ? choose_.between(1, 9) * write_.one() : 0); }

  void begin() {
    if (choose_.chance(35)) returns();
    if (choose_.chance(12)) offset_words();
    if (choose_.chance(8)) {
      plane_ = static_cast<std::size_t>(choose_.between(0, 2));
      write_.word(fmt::format("G{}", 17 + plane_));
    }
    const int code = choose_.one_of({73, 74, 76, 81, 81, 82, 83, 83, 84, 85, 86, 87, 88, 89});
    if (code == 87) write_.word("G98");
    write_.word(fmt::format("G{}", code));
    on_ = true;
    position();
    if (choose_.chance(90)) bottom();
    if (choose_.chance(90)) point_r();
    const bool pecks = code == 73 || code == 83;
    if (choose_.chance(pecks ? 96 : 10)) depth_of_cut();
    if (choose_.chance(20)) write_.number('P', choose_.between(1, 9) * 100);
    if (choose_.chance(10)) write_.word(fmt::format("K{}", choose_.between(0, 3)));
    if (choose_.chance(25)) feed();
    write_.end_block();
  }

  void hole() {
    const bool any = position();
    if (choose_.chance(15)) bottom();
    if (choose_.chance(15) || !any) point_r();
    if (choose_.chance(6)) depth_of_cut();
    if (choose_.chance(6)) offset_words();
    write_.end_block();
  }

  void row() {
    if (choose_.chance(70) && !write_.incremental()) switch_mode();
    position();
    write_.word(fmt::format("{}{}", choose_.chance(75) ? 'K' : 'L', choose_.chance(10) ? 0 : choose_.between(1, 6)));
    write_.end_block();
  }

  void end() {
    write_.word(choose_.one_of({"G80", "G80", "G80", "G00", "G01"}));
    on_ = false;
    if (choose_.chance(25)) switch_mode();
    if (choose_.chance(60)) places();
    write_.end_block();
  }

  void offset_words() {
    write_.word(choose_.one_of({"G43", "G43", "G44"}));
    write_.word(fmt::format("H{}", choose_.between(1, static_cast<std::int64_t>(case_.setup.h.size()))));
  }
  void offset() {
    if (choose_.chance(85))
      offset_words();
    else
      write_.word(choose_.one_of({"G49", "H0", "H1"}));
    if (choose_.chance(60)) write_.axis('Z', travel());
    write_.end_block();
  }

  void rename() {
    const std::int64_t value = choose_.between(-40, 40) * write_.one();
    switch (choose_.weighted({40, 25, 20, 15})) {
      case 0:
        write_.word(fmt::format("G{}", choose_.between(54, 57)));
        break;
      case 1:
        write_.word("G52").number(choose_.one_of({'X', 'Z'}), value);
        break;
      case 2:
        write_.word("G92").number(choose_.one_of({'Y', 'Z'}), value);
        break;
      default:
        write_.word("G10 L2 P1").number('Z', value);
        break;
    }
    write_.end_block();
  }

  // With a start and an end of its own; seldom a cycle stands in it.
  void contour() {
    const bool incremental = write_.incremental();
    write_.word(incremental ? "G01 G41 D1" : "G90 G01 G42 D1");
    write_.axis('X', 20 * write_.one()).end_block();
    write_.axis('Y', 30 * write_.one()).end_block();
    write_.axis('X', -40 * write_.one()).end_block();
    if (choose_.chance(12)) return begin();
    write_.word("G40");
    if (choose_.chance(92)) write_.axis('Y', -15 * write_.one());
    write_.end_block();
  }

  // What ends the run, or leaves it open.
  void seldom() {
    write_.word(choose_.one_of({"G28 Z0",      "G28",         "G30 X0",        "G29 X1.",     "G53 Z0",
                                "G37 Z5.",     "G39",         "G41 D1",        "G42 X5. D1",  "X1. K1.5",
                                "X1. K-1",     "X1. L10000",  "G99 G87 X1.",   "G83 X1. Q0",  "G18 X1.",
                                "G19",         "G43.4 H1",    "G41.3 D1",      "G41.2 D1",    "G01 G81 X1.",
                                "G81 G80 X1.", "G80 G82 X2.", "M98 P9 L2 X1.", "G02 X1. R5.", "I1. J1."}));
    write_.end_block();
  }

  Choices& choose_;
  spec::Case& case_;
  ProgramWriter write_;
  bool by_plane_;
  std::size_t plane_ = 0;
  bool on_ = false;
};

}  // namespace

spec::Case canned_cycle(Choices& choose, std::uint32_t blocks) {
  spec::Case c;
  const bool type_b = choose.chance(20);
  c.setup = random_cutter_setup(choose, type_b ? spec::CutterCompensationType::b : spec::CutterCompensationType::c);
  if (choose.chance(30)) c.setup.parameters[{5101, 0}] = spec::decimal(choose.chance(85) ? 1 : 0);
  c.program = CannedCycles(choose, c).program(blocks);
  return c;
}

}  // namespace toolcomp::fuzz
