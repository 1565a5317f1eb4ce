// SPDX-License-Identifier: Apache-2.0
// G39 to G42 programs of type B: vectors by I J and by the path, corner arcs, and what is forbidden.
#include <fmt/format.h>

#include "fuzz/gen/fanuc/cutter_program.h"
#include "fuzz/gen/fanuc/setups.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {
namespace {

class CompensationB final : public CutterProgram {
 public:
  using CutterProgram::CutterProgram;

 private:
  void start_up() override {
    side_word(choose_.chance(60) ? 1 : -1);
    if (choose_.chance(92)) number();
    switch (choose_.weighted({60, 22, 8, 4, 4, 2})) {
      case 0:
        return straight(0);
      case 1:
        return straight(100);
      case 2:  // alone, perhaps with a direction
        if (choose_.chance(50)) direction_words();
        write_.end_block();
        return choose_.chance(85) ? straight(20) : block(contour_.arc());
      case 3:
        normal_travel();
        write_.end_block();
        return straight(20);
      case 4:
        return block(contour_.arc());
      default:
        zero_travel();
        direction_words();
        return write_.end_block();
    }
  }

  // A line, in so many of a hundred cases with the direction of its end vector.
  void straight(std::uint64_t directed) {
    const Segment s = contour_.line();
    if (!choose_.chance(directed)) return block(s);
    segment(s);
    direction_words();
    write_.end_block();
  }

  // Mostly an arc that leaves along the path, which keeps the offset radial.
  void arc() { block(contour_.arc()); }

  void inside() override {
    switch (choose_.weighted({26, 24, 14, 5, 8, 6, 6, 4, 3, 4})) {
      case 0:
        return straight(15);
      case 1:
        return arc();
      case 2:
        return corner_arc();
      case 3:
        return blocks(contour_.shape());
      case 4:
        return still_block();
      case 5:
        side_word(-side());
        if (choose_.chance(12)) write_.end_block();
        return choose_.chance(92) ? straight(20) : arc();
      case 6:
        if (choose_.chance(12))
          write_.word("D0");
        else
          number();
        if (choose_.chance(15)) write_.end_block();
        return choose_.chance(92) ? straight(10) : arc();
      case 7:
        return machine_block();
      case 8:
        switch_mode();
        return straight(10);
      default:
        return seldom();
    }
  }

  // By I J or by X Y, which direct and do not move.
  void corner_arc() {
    write_.word("G39");
    if (choose_.chance(6)) write_.word(choose_.one_of(kNotWithCornerArc));
    if (choose_.chance(60)) {
      direction_words();
    } else {
      const PlaneCounts d = choose_.chance(85) ? contour_.any_direction(10 * write_.one()) : PlaneCounts{};
      const std::int64_t before[] = {write_.at(first()), write_.at(second())};
      if (d.x != 0 || choose_.chance(50)) write_.axis(first(), d.x);
      if (d.y != 0 || choose_.chance(50)) write_.axis(second(), d.y);
      write_.place(first(), before[0]);
      write_.place(second(), before[1]);
    }
    write_.end_block();
  }

  void seldom() {
    write_.word(choose_.one_of({"G45 X10.", "G18", "G19", "G17", "G37 Z0", "G41.3 D1", "M30", "D999", "G43 H1", "G55",
                                "G20", "G92 X0 Y0", "G30.1 X0", "G41", "G42", "G02", "G01", "G40 G41", "G39"}));
    if (choose_.chance(50)) write_.end_block();
    block(contour_.movement());
  }

  void cancel() override {
    switch (choose_.weighted({55, 18, 5, 5, 5, 5, 7})) {
      case 0:
        write_.word("G40");
        return straight(10);
      case 1:
        write_.word("G40");
        return write_.end_block();
      case 2:
        write_.word("G40");
        return arc();
      case 3:
        write_.word("G40");
        normal_travel();
        return write_.end_block();
      case 4:
        write_.word("G40");
        direction_words();
        return write_.end_block();
      case 5:
        write_.word("G40").end_block();
        return arc();
      default:  // G39 outside the mode
        write_.word("G40");
        straight(0);
        return choose_.chance(30) ? corner_arc() : void();
    }
  }
};

}  // namespace

spec::Case cutter_compensation_b(Choices& choose, std::uint32_t blocks) {
  spec::Case c;
  c.setup = random_cutter_setup(choose, spec::CutterCompensationType::b);
  c.program = CompensationB(choose, c).program(blocks, 85);
  return c;
}

}  // namespace toolcomp::fuzz
