// SPDX-License-Identifier: Apache-2.0
// G40 G41 G42 programs of type C: start-ups, corners of every kind, cancels, and what may stand between.
#include <fmt/format.h>

#include "fuzz/gen/fanuc/cutter_program.h"
#include "fuzz/gen/fanuc/setups.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {
namespace {

class CompensationC final : public CutterProgram {
 public:
  using CutterProgram::CutterProgram;

 private:
  void start_words() {
    side_word(choose_.chance(60) ? 1 : -1);
    if (choose_.chance(92)) number();
  }

  // A straight movement whose words are put behind those of the block.
  void straight() { block(contour_.line()); }

  void start_up() override {
    start_words();
    switch (choose_.weighted({72, 8, 5, 4, 3, 3, 3, 2})) {
      case 0:
        return straight();
      case 1:
        write_.end_block();
        return straight();
      case 2:
        normal_travel();
        write_.end_block();
        return choose_.chance(80) ? straight() : block(contour_.arc());
      case 3:
        write_.end_block();
        still_block();
        return straight();
      case 4:  // forbidden
        return block(contour_.arc());
      case 5:  // I J mean nothing here
        segment(contour_.line());
        direction_words();
        // Of all three of I, J and K: three-dimensional compensation, which is not built.
        if (choose_.chance(25)) write_.word("I1. J2. K3.");
        return write_.end_block();
      case 6:  // a block without movement behind it, or two
        straight();
        still_block();
        return choose_.chance(50) ? still_block() : void();
      default:  // cancelled, or started again, before anything moved
        write_.end_block();
        write_.word(choose_.one_of({"G40", "G40", "G41", "G42", "D0"}));
        return straight();
    }
  }

  void inside() override {
    switch (choose_.weighted({38, 22, 6, 7, 7, 5, 4, 4, 3, 2, 2, 3})) {
      case 0:
        return block(contour_.movement());
      case 1:
        return shapes();
      case 2:
        still_block();
        return block(contour_.movement());
      case 3:
        still_block();
        still_block();
        more_still_blocks();
        return block(contour_.movement());
      case 4:
        return other_side();
      case 5:
        return other_number();
      case 6:
        return corner_arc();
      case 7:
        return repeated();
      case 8:
        machine_block();
        return block(choose_.chance(75) ? contour_.line() : contour_.movement());
      case 9:
        switch_mode();
        return block(contour_.movement());
      case 10:
        return seldom();
      default:
        return shift();
    }
  }

  // G92 or G52 of the plane, straight behind a movement or one or two blocks later, with a code or alone.
  void shift() {
    if (choose_.chance(70)) block(contour_.movement());
    const std::size_t still = choose_.weighted({70, 22, 8});
    for (std::size_t i = 0; i < still; ++i) still_block();
    if (choose_.chance(10)) write_.word(choose_.one_of({"G40", "G41", "G42", "D0", "D1", "G43 H1"}));
    shift_words();
    write_.end_block();
    if (choose_.chance(10)) {
      shift_words();
      write_.end_block();
    }
    if (choose_.chance(12)) return corner_arc();
    if (choose_.chance(12)) return cancel();
    if (choose_.chance(10)) machine_block();
    block(contour_.movement());
  }

  void shift_words() {
    write_.word(choose_.chance(75) ? "G92" : "G52");
    const std::size_t axes = choose_.weighted({60, 15, 15, 10});
    std::string letters;
    if (axes == 0 || axes == 1 || axes == 3) letters += first();
    if (axes == 0 || axes == 2) letters += second();
    if (axes == 3) letters += normal();
    for (const char letter : letters) write_.axis(letter, choose_.between(-8, 8) * 10 * write_.one());
  }

  void shapes() {
    if (!choose_.chance(15)) return blocks(contour_.shape());
    // A corner whose second vector the limit of 5010 drops, or keeps by a unit.
    const Contour::OmissionCorner corner = contour_.omission_corner();
    const std::int64_t limit = corner.distance + choose_.between(-1, 1);
    case_.setup.parameters[{5010, -1}] = decimal(limit < 0 ? 0 : limit, increment_decimals(case_.setup));
    blocks(corner.segments);
  }

  // G41 for G42 in a block that moves or alone; sharp turns make intersections there.
  void other_side() {
    side_word(-side());
    if (choose_.chance(12)) write_.end_block();
    if (choose_.chance(10)) number();
    if (choose_.chance(25)) return blocks(contour_.shape());
    block(contour_.movement());
  }

  void other_number() {
    if (choose_.chance(15))
      write_.word("D0");
    else
      number();
    if (choose_.chance(15)) write_.end_block();
    block(contour_.movement());
  }

  void corner_arc() {
    write_.word("G39");
    if (choose_.chance(4)) write_.word(choose_.one_of(kNotWithCornerArc));
    if (choose_.chance(50)) direction_words();
    if (choose_.chance(4)) write_.axis(first(), 5 * write_.one());
    write_.end_block();
    const std::size_t still = choose_.weighted({80, 14, 6});
    for (std::size_t i = 0; i < still; ++i) still_block();
    if (choose_.chance(15)) return cancel();
    block(contour_.movement());
  }

  void repeated() {
    write_.word(side() > 0 ? "G41" : "G42");
    if (choose_.chance(50)) write_.end_block();
    if (choose_.chance(15)) number();
    block(contour_.movement());
  }

  // What is forbidden, ends the run, or is left open.
  void seldom() {
    write_.word(choose_.one_of({"G45 X10.", "G18", "G19", "G17", "G37 Z0", "G41.3 D1", "M30", "D999", "G43 H1", "G55",
                                "G20", "G92 X0 Y0", "G30.1 X0", "G43.5 H1", "G02", "G01", "G40 G41", "M98"}));
    if (choose_.chance(50)) write_.end_block();
    block(contour_.movement());
  }

  // As many as the 30i may read past.
  void more_still_blocks() {
    if (case_.setup.series != spec::Series::series_30i) return;
    for (std::int64_t n = choose_.between(0, 5); n > 0; --n) still_block();
  }

  // A move to where the tool is programmed to stand, and perhaps another plane.
  void stand() {
    zero_travel();
    if (choose_.chance(30)) normal_travel();
    write_.end_block();
    if (choose_.chance(30)) write_.word(choose_.one_of({"G17", "G18", "G19"})).end_block();
  }

  void cancel() override {
    switch (choose_.weighted({46, 14, 12, 8, 4, 4, 3, 5, 4})) {
      case 0:
        write_.word("G40");
        return straight();
      case 1:
        write_.word("G40").end_block();
        if (choose_.chance(20)) still_block();
        if (choose_.chance(15)) stand();
        return choose_.chance(85) ? straight() : void();
      case 2: {
        // The direction is chosen before the path turns.
        write_.word("G40");
        direction_words();
        return straight();
      }
      case 3:
        write_.word("D0");
        return straight();
      case 4:
        write_.word("D0").end_block();
        return straight();
      case 5:  // forbidden
        write_.word("G40");
        return block(contour_.arc());
      case 6:  // outside the plane
        write_.word("G40");
        normal_travel();
        write_.end_block();
        return straight();
      case 7:  // behind blocks that do not move
        still_block();
        if (choose_.chance(60)) still_block();
        write_.word("G40");
        return straight();
      default:  // started again before the vector is gone
        write_.word("G40").end_block();
        side_word(choose_.chance(50) ? side() : -side());
        return straight();
    }
  }
};

}  // namespace

spec::Case cutter_compensation_c(Choices& choose, std::uint32_t blocks) {
  spec::Case c;
  c.setup = random_cutter_setup(choose, spec::CutterCompensationType::c);
  c.program = CompensationC(choose, c).program(blocks, 82);
  return c;
}

}  // namespace toolcomp::fuzz
