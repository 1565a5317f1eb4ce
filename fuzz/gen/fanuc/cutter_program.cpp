// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/cutter_program.h"

#include <fmt/format.h>

#include "fuzz/gen/fanuc/arc_words.h"
#include "fuzz/gen/fanuc/setups.h"

namespace toolcomp::fuzz {

CutterProgram::CutterProgram(Choices& choose, spec::Case& c)
    : choose_(choose), case_(c), write_(choose, c.setup), contour_(choose, write_.one()) {}

std::string CutterProgram::program(std::uint32_t blocks, std::uint64_t cancels) {
  preamble();
  do {
    write_.switch_units();
    start_up();
    // The last two blocks are left for the cancel.
    do {
      inside();
    } while (write_.blocks() + 2 < blocks);
    if (choose_.chance(cancels)) cancel();
  } while (write_.blocks() + 3 <= blocks);
  if (choose_.chance(10)) write_.word(choose_.one_of({"M30", "M02"})).end_block();
  return write_.text();
}

void CutterProgram::plane(std::size_t which) {
  constexpr std::string_view letters[] = {"XYZ", "ZXY", "YZX"};
  constexpr std::string_view centers[] = {"IJK", "KIJ", "JKI"};
  letters_ = letters[which];
  centers_ = centers[which];
}

void CutterProgram::preamble() {
  const std::size_t which = choose_.weighted({60, 20, 20});
  if (which != 0 || choose_.chance(30)) write_.word(fmt::format("G{}", 17 + which));
  plane(which);
  if (choose_.chance(50)) switch_mode();
  write_.units();
  if (choose_.chance(40)) {
    motion("G01");
    write_.number('F', choose_.between(1, 50) * 100 * write_.one());
  }
  if (choose_.chance(60)) line();
  write_.end_block();
}

void CutterProgram::motion(std::string_view code) {
  if (motion_ == code && !choose_.chance(8)) return;
  motion_ = code;
  write_.word(code);
}

void CutterProgram::segment(const Segment& s) {
  if (s.kind == Segment::Kind::line) {
    const bool straight = motion_ == "G00" || motion_ == "G01";
    if (!straight || choose_.chance(10))
      motion(choose_.chance(80) ? "G01" : "G00");
    else
      motion(motion_);
  } else {
    motion(s.clockwise ? "G02" : "G03");
  }
  // A whole circle has mostly no end point.
  const bool closed = s.kind == Segment::Kind::arc && s.travel == PlaneCounts{};
  const std::uint64_t needless = closed ? 20 : 12;
  const std::int64_t travel[] = {s.travel.x, s.travel.y};
  bool any = false;
  for (const std::size_t i : {0U, 1U})
    if (travel[i] != 0 || choose_.chance(needless)) {
      write_.axis(letters_[i], travel[i]);
      any = true;
    }
  if (!any && !closed) write_.axis(letters_[0], 0);
  if (s.kind != Segment::Kind::line) arc_words(choose_, write_, s, centers_);
  contour_.follow(s);
}

void CutterProgram::line() { segment(contour_.line()); }

void CutterProgram::movement() { segment(contour_.movement()); }

void CutterProgram::block(const Segment& s) {
  segment(s);
  if (choose_.chance(5)) normal_travel();
  if (choose_.chance(5)) write_.word(choose_.one_of({"M08", "S1500", "F200", "T3", "G54"}));
  write_.end_block();
}

void CutterProgram::blocks(const Segments& all) {
  for (const Segment& s : all) block(s);
}

void CutterProgram::number() {
  const auto entries = static_cast<std::int64_t>(case_.setup.d.size());
  number(choose_.between(1, entries));
}

void CutterProgram::number(std::int64_t n) {
  const bool by_h = case_.setup.bit(5001, 2) && choose_.chance(25);
  write_.word(fmt::format("{}{}", by_h ? 'H' : 'D', n));
  number_ = n;
  take_offset();
}

void CutterProgram::side_word(int sign) {
  side(sign);
  write_.word(sign > 0 ? "G41" : "G42");
}

void CutterProgram::side(int sign) {
  side_ = sign;
  take_offset();
}

void CutterProgram::take_offset() {
  const auto entry = case_.setup.d.find(static_cast<std::uint32_t>(number_));
  std::int64_t counts = 0;
  if (entry != case_.setup.d.end())
    counts = counts_of(entry->second.geometry, case_.setup) + counts_of(entry->second.wear, case_.setup);
  contour_.offset(side_ * write_.in_program(counts));
}

void CutterProgram::normal_travel() {
  const std::int64_t one = write_.one();
  write_.axis(normal(), choose_.between(-6, 6) * 5 * one);
}

void CutterProgram::zero_travel() { write_.axis(choose_.chance(50) ? first() : second(), 0); }

void CutterProgram::still_block() {
  switch (choose_.weighted({30, 22, 12, 8, 6, 5, 5, 4, 4, 4})) {
    case 0:
      normal_travel();
      break;
    case 1:
      write_.word(choose_.one_of({"M08", "S1000", "T2", "M05", "F300"}));
      break;
    case 2:
      zero_travel();
      break;
    case 3:
      write_.word("G04 P500");
      break;
    case 4:
      write_.word(choose_.one_of({"G43 H1", "H2", "G49", "G44 H1"}));
      break;
    case 5:
      switch_mode();
      break;
    case 6:
      motion_ = choose_.one_of({"G00", "G01"});
      write_.word(motion_);
      break;
    case 7:
      return change_memory();
    case 8:
      write_.word(choose_.one_of({"M00", "M01", "G54", "G55", "N77", "P1", "G53"}));
      break;
    default:
      if (case_.setup.axes.has('B'))
        write_.axis('B', 5 * write_.one());
      else
        normal_travel();
      break;
  }
  write_.end_block();
}

void CutterProgram::direction_words() {
  const std::int64_t long_way = 10 * write_.one();
  const PlaneCounts along = contour_.direction();
  switch (choose_.weighted({40, 20, 8, 8, 8, 8, 8})) {
    case 0:
      return direction_words(contour_.any_direction(long_way));
    case 1: {
      const std::int64_t x = choose_.between(-20, 20) * write_.one();
      const std::int64_t y = choose_.between(-20, 20) * write_.one();
      return direction_words({x, y});
    }
    case 2:
      return direction_words(contour_.parallel(along, long_way));
    case 3:
      return direction_words(contour_.parallel(-along, long_way));
    case 4:
      return direction_words(contour_.parallel(left_of(along), long_way));
    case 5:
      return direction_words(contour_.parallel(right_of(along), long_way));
    default:
      return direction_words(PlaneCounts{});
  }
}

// Letters that are zero are mostly left out; both zero are written.
void CutterProgram::direction_words(PlaneCounts d) {
  const std::int64_t words[] = {d.x, d.y};
  for (const std::size_t i : {0U, 1U})
    if (words[i] != 0 || d == PlaneCounts{} || choose_.chance(20)) write_.number(centers_[i], words[i]);
}

void CutterProgram::change_memory() {
  const bool separate = case_.setup.memory == spec::OffsetMemory::c;
  const std::int64_t table = separate                                      ? choose_.between(10, 13)
                             : case_.setup.memory == spec::OffsetMemory::b ? choose_.between(10, 11)
                                                                           : 11;
  write_.word("G10").word(fmt::format("L{}", table));
  const bool active = number_ > 0 && choose_.chance(70);
  write_.word(fmt::format("P{}", active ? number_ : choose_.between(1, 3)));
  write_.number('R', choose_.between(1, 60) * write_.one() / 10);
  write_.end_block();
}

void CutterProgram::machine_block() {
  const std::size_t kind = choose_.weighted({45, 30, 10, 15});
  if (kind == 0 && write_.incremental() && choose_.chance(90)) switch_mode();
  constexpr std::string_view codes[] = {"G53", "G28", "G30", "G29"};
  write_.word(codes[kind]);
  const std::size_t axes = choose_.weighted({60, 12, 12, 8, 8});
  std::string letters;
  if (axes == 0 || axes == 1 || axes == 4) letters += first();
  if (axes == 0 || axes == 2) letters += second();
  if (axes == 3 || axes == 4) letters += normal();
  for (const char letter : letters) {
    const std::int64_t way = choose_.chance(12) ? 0 : choose_.between(-8, 8) * 10 * write_.one();
    write_.axis(letter, way);
    if (kind == 0) write_.place(letter, write_.at(letter) - table_value(case_.setup.workpiece.front(), letter));
    if (kind == 1 || kind == 2) write_.place(letter, reference(static_cast<int>(kind), letter));
  }
  write_.end_block();
}

std::int64_t CutterProgram::table_value(const spec::AxisTable& table, char letter) const {
  const auto value = table.find(letter);
  return value == table.end() ? 0 : counts_of(value->second, case_.setup);
}

std::int64_t CutterProgram::reference(int point, char letter) const {
  const auto found = case_.setup.reference.find(point);
  const std::int64_t machine = found == case_.setup.reference.end() ? 0 : table_value(found->second, letter);
  return machine - table_value(case_.setup.workpiece.front(), letter);
}

void CutterProgram::switch_mode() {
  write_.incremental(!write_.incremental());
  write_.word(write_.incremental() ? "G91" : "G90");
}

}  // namespace toolcomp::fuzz
