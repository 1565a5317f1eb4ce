// SPDX-License-Identifier: Apache-2.0
// G41.2 and G42.2 programs: corners as a tilted tool sees them, turns of the tool, arcs in planes the tool stands on,
// and what may stand between.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "fuzz/gen/fanuc/arc_words.h"
#include "fuzz/gen/fanuc/contour.h"
#include "fuzz/gen/fanuc/setups.h"
#include "fuzz/gen/fanuc/space_path.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {
namespace {

class ToolSide {
 public:
  ToolSide(Choices& choose, spec::Case& c)
      : choose_(choose),
        case_(c),
        write_(choose, c.setup),
        pose_(choose, write_, c.setup),
        path_(choose, write_.one()),
        contour_(choose, write_.one()),
        type_c_(c.setup.bit(5003, 1)) {
    if (const auto limit = c.setup.parameter(19630); limit && !limit->negative) limit_ = counts_of(*limit, c.setup);
  }

  std::string program(std::uint32_t blocks_wanted) {
    blocks_ = blocks_wanted;
    preamble();
    do {
      cycle();
    } while (write_.blocks() + 4 <= blocks_);
    if (pose_.by_words() && choose_.chance(15)) write_.word("G49").end_block();
    if (choose_.chance(10)) write_.word(choose_.one_of({"M30", "M02"})).end_block();
    return write_.text();
  }

 private:
  void preamble() {
    const std::size_t which = choose_.weighted({60, 20, 20});
    if (which != 0 || choose_.chance(20)) write_.word(fmt::format("G{}", 17 + which));
    plane(which);
    if (choose_.chance(50)) switch_mode();
    write_.units();
    if (choose_.chance(70)) {
      motion("G01");
      write_.number('F', choose_.between(1, 50) * 100 * write_.one());
    }
    const auto type = case_.setup.parameter(19680);
    const bool table = type && (type->digits == 12 || type->digits == 21);
    const bool words = choose_.chance(table ? 3 : pose_.turns() ? 42 : 75);
    if (words) {
      // The block of G43.5 is one of its own; its direction counts from there on.
      if (choose_.chance(50)) start_point();
      write_.end_block();
      write_.word("G43.5").word(fmt::format("H{}", choose_.between(0, 2)));
      pose_.by_words(true);
      if (choose_.chance(25))
        pose_.align();
      else
        pose_.turn();
      return write_.end_block();
    }
    // Arcs want a tool that stands on their plane.
    if (choose_.chance(35))
      pose_.align();
    else if (choose_.chance(85))
      pose_.turn();
    if (choose_.chance(60)) start_point();
    write_.end_block();
  }

  void start_point() {
    SpaceCounts move{};
    for (std::int64_t& x : move) x = choose_.chance(50) ? 0 : choose_.between(-10, 10) * 5 * write_.one();
    linear(move);
  }

  void cycle() {
    write_.switch_units();
    start_up();
    // The last two blocks are left for the cancel.
    do {
      inside();
    } while (write_.blocks() + 2 < blocks_);
    if (choose_.chance(85)) cancel();
  }

  // Codes

  void side_word(int sign) {
    side_ = sign;
    const bool other_form = choose_.chance(1);
    const bool six = pose_.by_words() != other_form;
    write_.word(fmt::format("G4{}.{}", sign > 0 ? 1 : 2, six ? 6 : 2));
    take_offset();
  }

  void number() {
    number_ = static_cast<std::uint32_t>(choose_.between(1, static_cast<std::int64_t>(case_.setup.d.size())));
    const bool by_h = case_.setup.bit(5001, 2) && choose_.chance(10);
    write_.word(fmt::format("{}{}", by_h ? 'H' : 'D', number_));
    take_offset();
  }

  void take_offset() {
    const auto entry = case_.setup.d.find(number_);
    std::int64_t counts = 0;
    if (entry != case_.setup.d.end())
      counts = write_.in_program(counts_of(entry->second.geometry, case_.setup) +
                                 counts_of(entry->second.wear, case_.setup));
    path_.offset(counts);
    // Contours lie in a plane; left and right are those of the tool.
    contour_.offset(side_ * (pose_.aim().direction[normal_] < 0 ? -counts : counts));
  }

  // Q1 Q2 Q3: what to do about interference where the compensation plane changes.
  void treatment() { write_.word(choose_.one_of({"Q1", "Q2", "Q3", "Q1.", "Q2", "Q3"})); }

  // Movements: words alone, and whole blocks

  void motion(std::string_view code) {
    if (motion_ == code && !choose_.chance(8)) return;
    motion_ = code;
    write_.word(code);
  }

  void straight_code() {
    const bool straight = motion_ == "G00" || motion_ == "G01";
    if (!straight || choose_.chance(8)) motion(choose_.chance(80) ? "G01" : "G00");
  }

  void linear(const SpaceCounts& move) {
    bool any = false;
    for (std::size_t i = 0; i < 3; ++i)
      if (case_.setup.axes.has("XYZ"[i]) && (move[i] != 0 || choose_.chance(12))) {
        write_.axis("XYZ"[i], move[i]);
        any = true;
      }
    if (!any) write_.axis('X', 0);
    const std::int64_t plane_travel[] = {move[(normal_ + 1) % 3], move[(normal_ + 2) % 3]};
    Segment s;
    s.travel = {plane_travel[0], plane_travel[1]};
    contour_.follow(s);
    path_.follow(move);
  }

  // A straight movement, the tool turned in the same block in some.
  void straight() {
    straight_code();
    const bool turn = choose_.chance(28);
    // Most corners are meant in the plane of the tool before it turns; half of the turns come first.
    const bool first = turn && choose_.chance(50);
    if (first) pose_.turn();
    linear(path_.movement(pose_.aim()));
    if (turn && !first) pose_.turn();
  }

  void segment(const Segment& s) {
    if (s.kind == Segment::Kind::line) {
      straight_code();
      SpaceCounts move{};
      move[(normal_ + 1) % 3] = s.travel.x;
      move[(normal_ + 2) % 3] = s.travel.y;
      return linear(move);
    }
    const bool closed = s.travel == PlaneCounts{};
    // I J K are the tool's under G43.5, so that a centre cannot be written.
    if (pose_.by_words() && closed) return straight();
    motion(s.clockwise ? "G02" : "G03");
    const std::int64_t travel[] = {s.travel.x, s.travel.y};
    bool any = false;
    SpaceCounts move{};
    for (const std::size_t i : {0U, 1U})
      if (travel[i] != 0 || choose_.chance(closed ? 20 : 12)) {
        write_.axis("XYZ"[(normal_ + 1 + i) % 3], travel[i]);
        move[(normal_ + 1 + i) % 3] = travel[i];
        any = true;
      }
    if (!any && !closed) write_.axis("XYZ"[(normal_ + 1) % 3], 0);
    if (choose_.chance(12)) {  // a helix
      move[normal_] = choose_.between(-6, 6) * 5 * write_.one();
      write_.axis("XYZ"[normal_], move[normal_]);
    }
    if (pose_.by_words())
      arc_words_by_radius(write_, s);
    else
      arc_words(choose_, write_, s, center_letters(normal_));
    contour_.follow(s);
    path_.follow(move);
  }

  void end_of_movement() {
    if (choose_.chance(2)) write_.word(choose_.one_of({"F300", "F300", "M08", "S1500", "T3"}));
    write_.end_block();
  }

  // Any movement: in space, or of a contour in the plane. Where the tool stands on the plane contours are likelier.
  void movement() {
    const bool stands = std::abs(billionths(pose_.aim().direction[normal_])) == 1'000'000'000;
    if (choose_.chance(stands ? 60 : 12)) {
      segment(contour_.movement());
      if (choose_.chance(3)) pose_.turn();
    } else {
      straight();
    }
    end_of_movement();
  }

  // Several movements with a purpose.
  void shapes() {
    take_offset();
    for (const Segment& s : contour_.shape()) {
      segment(s);
      end_of_movement();
    }
  }

  // Blocks that do not move, or not in the compensation plane

  void still_block() {
    switch (choose_.weighted({34, 22, 14, 10, 8, 5, 4, 3})) {
      case 0:
        if (!pose_.turns()) return still_words();
        if (choose_.chance(70))
          pose_.turn();
        else
          pose_.turn_by(choose_.between(-180, 180) * 1000);
        break;
      case 1:
        straight_code();
        linear(path_.parallel(pose_.aim()));
        break;
      case 2:
        return still_words();
      case 3:
        straight_code();
        limit_movement();
        break;
      case 4:
        write_.axis(choose_.one_of({'X', 'Y', 'Z'}), 0);
        break;
      case 5:
        if (pose_.by_words()) return still_words();
        write_.word(choose_.one_of({"G43 H1", "H2", "G49", "G44 H1"}));
        break;
      case 6:
        switch_mode();
        break;
      default:
        motion_ = choose_.one_of({"G00", "G01"});
        write_.word(motion_);
        break;
    }
    write_.end_block();
  }

  [[nodiscard]] bool reads_more() const { return case_.setup.series == spec::Series::series_30i; }

  void still_words() {
    write_.word(choose_.one_of({"M08", "S1000", "T2", "M05", "F300", "M08", "M00", "M01"})).end_block();
  }

  // The travel in the plane is the limit of 19630, or a unit beside it.
  void limit_movement() {
    const std::int64_t length = limit_ + choose_.between(-1, 1);
    linear(path_.of_length(pose_.aim(), std::max<std::int64_t>(0, write_.in_program(length))));
  }

  // A movement in which the tool turns, and which differs as seen along the tool before and after: along one of them,
  // or in one of the planes of the length of 19630.
  void turning_movement() {
    straight_code();
    const auto limit = [&](const ToolAim& aim) {
      return path_.of_length(aim, std::max<std::int64_t>(0, limit_ + choose_.between(-1, 1)));
    };
    const std::size_t which = choose_.weighted({45, 20, 18, 17});
    if (which == 1 || which == 3) pose_.turn();
    const ToolAim aim = pose_.aim();
    linear(which < 2 ? path_.parallel(aim) : limit(aim));
    if (which == 0 || which == 2) pose_.turn();
  }

  // One or two of these, also behind the tool that turns alone.
  void turning() {
    const ToolAim before = pose_.aim();
    if (choose_.chance(30)) {
      pose_.turn();
      write_.end_block();
    }
    if (choose_.chance(8)) treatment();
    if (choose_.chance(5)) side_word(choose_.chance(50) ? side_ : -side_);
    if (choose_.chance(25)) {
      straight_code();
      linear(path_.parallel(before));
    } else {
      turning_movement();
    }
    end_of_movement();
    if (choose_.chance(25)) {
      turning_movement();
      end_of_movement();
    }
    if (choose_.chance(60)) movement();
  }

  // Movements along the tool as it stood, which the corner before them passes over, while it turns and turns back: the
  // corners between them are known before that one.
  void along_the_former_tool() {
    straight();
    end_of_movement();
    const ToolAim before = pose_.aim();
    for (std::int64_t n = choose_.between(2, 6); n > 0; --n) {
      straight_code();
      if (pose_.by_words() && before.whole && choose_.chance(35))
        pose_.direction(*before.whole);
      else if (choose_.chance(75))
        pose_.turn_by(choose_.between(2, 40) * 1000);
      linear(path_.parallel(before));
      write_.end_block();
    }
    movement();
  }

  void switch_mode() {
    write_.incremental(!write_.incremental());
    write_.word(write_.incremental() ? "G91" : "G90");
  }

  // Start-up

  void start_up() {
    if (type_c_) return start_alone();
    side_word(choose_.chance(55) ? 1 : -1);
    if (choose_.chance(95)) number();
    switch (choose_.weighted({74, 8, 5, 4, 4, 1, 3, 2})) {
      case 0:
        straight();
        end_of_movement();
        return choose_.chance(8) ? turning() : void();
      case 1:
        write_.end_block();
        if (choose_.chance(15))
          turning_movement();
        else
          straight();
        return end_of_movement();
      case 2:
        write_.end_block();
        still_block();
        straight();
        return end_of_movement();
      case 3:  // along the tool: nothing moves in the plane
        straight_code();
        linear(path_.parallel(pose_.aim()));
        write_.end_block();
        straight();
        return end_of_movement();
      case 4:  // the tool alone
        pose_.turn();
        write_.end_block();
        straight();
        return end_of_movement();
      case 5:  // forbidden
        segment(contour_.arc());
        return write_.end_block();
      case 6:  // blocks without movement behind it
        straight();
        end_of_movement();
        still_block();
        return choose_.chance(50) ? still_block() : void();
      default:  // cancelled, or started again, before anything moved
        write_.end_block();
        if (choose_.chance(50))
          write_.word(choose_.one_of({"G40", "D0"}));
        else
          side_word(choose_.chance(50) ? side_ : -side_);
        straight();
        return end_of_movement();
    }
  }

  // Type C: a block of its own, in G00 or G01, before a movement.
  void start_alone() {
    if (motion_ == "G02" || motion_ == "G03")
      if (choose_.chance(90)) straight_code();
    side_word(choose_.chance(55) ? 1 : -1);
    if (choose_.chance(95)) number();
    switch (choose_.weighted({94, 2, 2, 2})) {
      case 0:
        write_.end_block();
        return choose_.chance(8) ? turning() : movement();
      case 1:
        straight();
        return end_of_movement();
      case 2:
        pose_.turn();
        return write_.end_block();
      default:
        write_.end_block();
        still_block();
        return movement();
    }
  }

  // In the mode

  void inside() {
    switch (choose_.weighted({36, 9, 7, 8, 6, 6, 5, 8, 4, 2, 2, 11})) {
      case 0:
        return movement();
      case 1:
        return shapes();
      case 2:
        still_block();
        return movement();
      case 3:
        if (reads_more() && pose_.turns() && choose_.chance(50)) return along_the_former_tool();
        for (std::int64_t n = choose_.between(2, reads_more() ? 7 : 3); n > 0; --n) still_block();
        return movement();
      case 4:
        return other_side();
      case 5:
        return other_number();
      case 6:
        return repeated();
      case 7:
        return plane_change();
      case 8:
        return treated();
      case 9:
        switch_mode();
        return movement();
      case 10:
        return seldom();
      default:
        return turning();
    }
  }

  // Q in a block that is block A of a corner, mostly: of a usual one, a change of side, a repeated code, a cancel.
  void treated() {
    treatment();
    if (choose_.chance(8)) return write_.end_block();
    straight();
    end_of_movement();
    switch (choose_.weighted({40, 20, 12, 16, 12})) {
      case 0:
        return movement();
      case 1:
        return other_side();
      case 2:
        return repeated();
      case 3:
        if (choose_.chance(30)) side_word(side_);
        return other_number();
      default:
        still_block();
        return movement();
    }
  }

  void other_side() {
    if (choose_.chance(8)) treatment();
    side_word(-side_);
    if (choose_.chance(12)) write_.end_block();
    if (choose_.chance(10)) number();
    if (choose_.chance(10)) return shapes();
    movement();
  }

  void other_number() {
    if (choose_.chance(6)) {
      write_.word("D0");
      number_ = 0;
    } else {
      number();
    }
    if (choose_.chance(type_c_ && number_ == 0 ? 90 : 15)) write_.end_block();
    movement();
  }

  void repeated() {
    side_word(side_);
    if (choose_.chance(30)) write_.end_block();
    if (choose_.chance(15)) number();
    if (choose_.chance(50)) {
      straight();
      return end_of_movement();
    }
    movement();
  }

  // The tool turns by the limit angle, a thousandth of a degree beside it, or any angle, and the path goes back under
  // it.
  void plane_change() {
    constexpr std::int64_t full = 180'000;
    std::int64_t angle = choose_.between(0, full);
    if (choose_.chance(65)) {
      const auto parameter = case_.setup.parameter(6261);
      std::int64_t limit = 45'000;
      if (parameter && parameter->digits != 0) {
        limit = static_cast<std::int64_t>(parameter->digits);
        for (int i = parameter->decimals; i < 3; ++i) limit *= 10;
      }
      angle = std::clamp<std::int64_t>(limit + choose_.between(-1, 1), 0, full);
    }
    const Direction first = pose_.aim().direction;
    straight_code();
    const SpaceCounts before = path_.movement(pose_.aim());
    linear(before);
    if (choose_.chance(30)) treatment();
    write_.end_block();
    // The tool turns in the next movement, or alone before it.
    const bool alone = choose_.chance(50);
    if (alone) {
      pose_.turn_by(angle);
      write_.end_block();
      if (choose_.chance(5)) still_block();
    }
    straight_code();
    if (!alone) pose_.turn_by(angle);
    const ToolAim second = pose_.aim();
    const std::int64_t percent = choose_.chance(20) ? 100 : choose_.between(80, 400);
    linear(choose_.chance(8) ? path_.parallel(second) : path_.overcut(first, before, second.direction, percent));
    if (choose_.chance(6)) side_word(side_);
    end_of_movement();
  }

  // What is forbidden, ends the run, or is left open.
  void seldom() {
    write_.word(choose_.one_of({"G04 P100",   "G10 L10 P1 R1.",
                                "G39",        "G54",
                                "G55",        "G92 X0",
                                "G28 Z0",     "G53 Z0",
                                "G30 X0",     "G30.1 Y0",
                                "G29 X0",     "G41 D1",
                                "G42",        "G41.3 D1",
                                "G45 X10.",   "G37 Z0",
                                "G20",        "G21",
                                "G17",        "G18",
                                "G19",        "D999",
                                "Q4",         "Q0",
                                "Q-1",        "Q1.5",
                                "G43.5 H1",   "G49",
                                "M08 X1.",    "T1",
                                "B5.",        "C5.",
                                "M30",        "G41.6",
                                "G42.2",      "G40 G41.2",
                                "I1. J2. K3."}));
    if (choose_.chance(50)) write_.end_block();
    movement();
  }

  // Cancel

  void cancel() {
    if (type_c_) return cancel_alone();
    switch (choose_.weighted({54, 14, 9, 5, 2, 4, 7, 3})) {
      case 0:
        if (choose_.chance(12)) turning();
        write_.word("G40");
        if (choose_.chance(12))
          turning_movement();
        else
          straight();
        return end_of_movement();
      case 1:
        write_.word("G40").end_block();
        if (choose_.chance(20)) still_block();
        if (choose_.chance(15)) return;
        straight();
        return end_of_movement();
      case 2:
        write_.word("D0");
        if (choose_.chance(30)) write_.end_block();
        straight();
        return end_of_movement();
      case 3:  // along the tool, or the tool alone
        write_.word("G40");
        if (choose_.chance(50)) {
          straight_code();
          linear(path_.parallel(pose_.aim()));
        } else {
          pose_.turn();
        }
        write_.end_block();
        straight();
        return end_of_movement();
      case 4:  // forbidden
        write_.word("G40");
        segment(contour_.arc());
        return write_.end_block();
      case 5:
        write_.word("G40");
        if (choose_.chance(50))
          write_.word("I5. J3.");
        else
          treatment();
        straight();
        return end_of_movement();
      case 6:  // behind blocks that do not move
        still_block();
        if (choose_.chance(60)) still_block();
        write_.word("G40");
        straight();
        return end_of_movement();
      default:  // started again before the vector is gone
        write_.word("G40").end_block();
        side_word(choose_.chance(50) ? side_ : -side_);
        straight();
        return end_of_movement();
    }
  }

  void cancel_alone() {
    if (motion_ == "G02" || motion_ == "G03")
      if (choose_.chance(92)) straight_code();
    write_.word(choose_.chance(88) ? "G40" : "D0");
    if (choose_.chance(3))
      straight();
    else if (choose_.chance(2))
      pose_.turn();
    write_.end_block();
    if (choose_.chance(40)) {
      straight();
      end_of_movement();
    }
  }

  // G17 X Y, G18 Z X, G19 Y Z: the axis at right angles to the plane.
  void plane(std::size_t which) {
    constexpr std::size_t normals[] = {2, 1, 0};
    normal_ = normals[which];
  }

  Choices& choose_;
  spec::Case& case_;
  ProgramWriter write_;
  ToolPose pose_;
  SpacePath path_;
  Contour contour_;
  bool type_c_;
  std::size_t normal_ = 2;
  std::uint32_t blocks_ = 0;
  std::uint32_t number_ = 0;
  std::int64_t limit_ = 0;  // 19630
  std::string motion_;
  int side_ = 1;
};

}  // namespace

spec::Case tool_side_compensation(Choices& choose, std::uint32_t blocks) {
  spec::Case c;
  c.setup = random_tool_side_setup(choose);
  c.program = ToolSide(choose, c).program(blocks);
  return c;
}

}  // namespace toolcomp::fuzz
