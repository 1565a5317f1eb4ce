// SPDX-License-Identifier: Apache-2.0
// G45 to G48 programs: travel stretched and shortened by one or two offsets, zero travel of both signs, arcs.
#include <fmt/format.h>

#include "fuzz/gen/fanuc/contour.h"
#include "fuzz/gen/fanuc/program_writer.h"
#include "fuzz/gen/fanuc/setups.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {
namespace {

class ToolOffset {
 public:
  ToolOffset(Choices& choose, spec::Case& c) : choose_(choose), case_(c), write_(choose, c.setup) {}

  std::string program(std::uint32_t blocks) {
    write_.units();
    if (choose_.chance(50)) switch_mode();
    if (choose_.chance(50)) write_.word("G01").number('F', choose_.between(1, 50) * 100 * write_.one());
    if (choose_.chance(65)) number();
    if (choose_.chance(60)) travel();
    write_.end_block();
    while (write_.blocks() < blocks) block();
    if (choose_.chance(8)) write_.word(choose_.one_of({"M30", "M02"})).end_block();
    return write_.text();
  }

 private:
  void block() {
    switch (choose_.weighted({52, 12, 16, 6, 4, 4, 3, 3})) {
      case 0:
        return offset();
      case 1:
        return offset_arc();
      case 2:
        travel();
        return write_.end_block();
      case 3:
        switch_mode();
        if (choose_.chance(50)) code();
        travel();
        return write_.end_block();
      case 4:
        number();
        if (choose_.chance(50)) travel();
        return write_.end_block();
      case 5:
        return memory();
      case 6:
        return opposite();
      default:
        return seldom();
    }
  }

  void switch_mode() {
    write_.incremental(!write_.incremental());
    write_.word(write_.incremental() ? "G91" : "G90");
  }

  void code() {
    last_ = choose_.between(45, 48);
    write_.word(fmt::format("G{}", last_));
  }

  // The number that counts is D, or H with 5001#5; the other one is seldom of use.
  void number() {
    const bool by_h = case_.setup.bit(5001, 5) && !case_.setup.bit(5001, 2);
    const char letter = choose_.chance(92) == by_h ? 'H' : 'D';
    const std::int64_t n = choose_.chance(6) ? 0 : choose_.between(1, static_cast<std::int64_t>(case_.setup.d.size()));
    write_.word(fmt::format("{}{}", letter, n));
    const auto& table = letter == 'H' ? case_.setup.h : case_.setup.d;
    const auto entry = table.find(static_cast<std::uint32_t>(n));
    offset_ = entry == table.end() ? 0
                                   : write_.in_program(counts_of(entry->second.geometry, case_.setup) +
                                                       counts_of(entry->second.wear, case_.setup));
  }

  // Larger than the offset, smaller, equal to it or to twice of it, or zero with either sign.
  std::int64_t distance() {
    const std::int64_t one = write_.one();
    const std::int64_t sign = choose_.chance(50) ? 1 : -1;
    const std::int64_t reach = offset_ < 0 ? -offset_ : offset_;
    switch (choose_.weighted({44, 16, 12, 12, 14, 2})) {
      case 0:
        return sign * choose_.between(1, 20) * 5 * one;
      case 1:
        return sign * choose_.between(1, 100 * one);
      case 2:
        return sign * choose_.between(0, 2 * reach + 1);
      case 3: {
        const std::int64_t times = choose_.between(1, 2);
        return sign * (times * reach + choose_.between(-1, 1));
      }
      case 4:
        return 0;
      default:
        return sign * choose_.between(1, 9'000) * one;
    }
  }

  void travel() {
    const std::string& letters = case_.setup.axes.letters();
    const std::size_t axes = choose_.weighted({50, 35, 15}) + 1;
    std::string used;
    for (std::size_t i = 0; i < axes; ++i) {
      const char letter = choose_.chance(75) ? "XYZ"[choose_.below(3)] : letters[choose_.below(letters.size())];
      if (!case_.setup.axes.has(letter) || used.find(letter) != std::string::npos) continue;
      used += letter;
      const std::int64_t counts = distance();
      if (write_.incremental() && counts == 0 && choose_.chance(40))
        write_.word(fmt::format("{}{}", letter, choose_.one_of({"-0", "-0.", "-.0", "0", "-0.0"})));
      else
        write_.axis(letter, counts);
    }
  }

  void offset() {
    if (choose_.chance(15)) write_.word(choose_.one_of({"G00", "G01", "G01", "G00"}));
    code();
    if (choose_.chance(45)) number();
    travel();
    write_.end_block();
  }

  // A code and the one that takes its shift back.
  void opposite() {
    code();
    travel();
    write_.end_block();
    write_.word(fmt::format("G{}", last_ % 2 == 1 ? last_ + 1 : last_ - 1));
    travel();
    write_.end_block();
  }

  // A quarter or three quarters of a circle, from an end on an axis of it; seldom any other arc.
  void offset_arc() {
    constexpr std::string_view planes[] = {"XYIJ", "ZXKI", "YZJK"};
    const std::size_t which = choose_.weighted({60, 20, 20});
    const std::string_view letters = planes[which];
    write_.word(fmt::format("G{}", 17 + which));
    if (choose_.chance(92)) code();
    if (choose_.chance(30)) number();
    const bool clockwise = choose_.chance(50);
    write_.word(clockwise ? "G02" : "G03");
    const std::int64_t reach = offset_ < 0 ? -offset_ : offset_;
    std::int64_t r = choose_.between(1, 12) * 5 * write_.one();
    if (choose_.chance(30)) {  // a radius that the offset makes zero, or less
      const std::int64_t times = choose_.between(1, 2);
      r = times * reach + choose_.between(-1, 1);
    }
    if (r <= 0) r = write_.one();
    PlaneCounts center{r, 0};
    for (std::size_t turns = choose_.below(4); turns > 0; --turns) center = left_of(center);
    PlaneCounts end = choose_.chance(50) ? left_of(center) : right_of(center);
    bool by_radius = false;
    switch (choose_.weighted({86, 3, 3, 3, 3, 2})) {
      case 0:
        break;
      case 1:  // a half
        end = center;
        break;
      case 2:  // a whole one
        end = -center;
        break;
      case 3:
        end.x += choose_.one_of<std::int64_t>({-1, 1});
        break;
      case 4:
        center = center + left_of(center);
        end = -center;
        break;
      default:
        by_radius = true;
        break;
    }
    const PlaneCounts travel = center + end;
    if (travel.x != 0 || choose_.chance(50)) write_.axis(letters[0], travel.x);
    if (travel.y != 0 || choose_.chance(50)) write_.axis(letters[1], travel.y);
    if (by_radius) {
      write_.number('R', r);
    } else {
      if (center.x != 0 || choose_.chance(20)) write_.number(letters[2], center.x);
      if (center.y != 0 || choose_.chance(20)) write_.number(letters[3], center.y);
    }
    if (choose_.chance(5)) {
      constexpr std::string_view normals = "ZYX";
      write_.axis(normals[which], distance());
    }
    write_.end_block();
    if (choose_.chance(85)) write_.word(choose_.one_of({"G00", "G01"}));
  }

  void memory() {
    const std::int64_t last = case_.setup.memory == spec::OffsetMemory::c ? 13 : 11;
    const std::int64_t table = case_.setup.memory == spec::OffsetMemory::a ? 11 : choose_.between(10, last);
    write_.word(fmt::format("G10 L{}", table));
    write_.word(fmt::format("P{}", choose_.between(1, 3)));
    write_.number('R', choose_.between(-99, 99) * write_.one() / 10);
    write_.end_block();
  }

  // Other ways to move, modes in which the codes do not belong, and the length offset beside them.
  void seldom() {
    if (case_.setup.bit(5001, 5) && choose_.chance(40)) {  // the number by H, which needs the length offset cancelled
      write_.word(choose_.one_of({"G43 H1", "G44 H1"}));
      return write_.end_block();
    }
    const std::string_view text = choose_.one_of({"G53 X0 Z0",   "G28 X0",       "G29 X10. Y5.",
                                                  "G92 X0 Y0",   "G54",          "G55",
                                                  "G43 H1",      "G49",          "H1",
                                                  "G44 Z10. H1", "G41 D1",       "G42 X10. D1",
                                                  "G40",         "G45",          "G46 D1",
                                                  "G04 P100",    "G45 G04 P100", "G47 F100",
                                                  "D999",        "G91 G45 X-0",  "G45 G46 X10.",
                                                  "G30 Z0",      "G45 G28 X0",   "G46 G53 X0",
                                                  "G41.3 D1",    "G43.5 H1",     "G45 G10 L11 P1 R1."});
    write_.word(text);
    if (text.find("G91") != std::string_view::npos) write_.incremental(true);
    write_.end_block();
  }

  Choices& choose_;
  spec::Case& case_;
  ProgramWriter write_;
  std::int64_t offset_ = 0;
  std::int64_t last_ = 45;
};

}  // namespace

spec::Case tool_offset(Choices& choose, std::uint32_t blocks) {
  spec::Case c;
  const bool type_b = choose.chance(30);
  c.setup = random_cutter_setup(choose, type_b ? spec::CutterCompensationType::b : spec::CutterCompensationType::c);
  c.program = ToolOffset(choose, c).program(blocks);
  return c;
}

}  // namespace toolcomp::fuzz
