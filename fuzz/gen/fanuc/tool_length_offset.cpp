// SPDX-License-Identifier: Apache-2.0
// G43 G44 G49 programs of types A, B and C, with the commands that cancel and restore the vector.
#include <fmt/format.h>

#include "fuzz/gen/fanuc/program_writer.h"
#include "fuzz/gen/fanuc/setups.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {
namespace {

enum class Type : std::uint8_t { a, b, c };

class LengthOffset {
 public:
  LengthOffset(Choices& choose, spec::Case& c)
      : choose_(choose),
        case_(c),
        write_(choose, c.setup),
        type_(c.setup.bit(5001, 0)   ? Type::c
              : c.setup.bit(5001, 1) ? Type::b
                                     : Type::a) {
    for (const char letter : c.setup.axes.letters())
      if (spec::is_linear_axis(letter)) linear_ += letter;
  }

  std::string program(std::uint32_t blocks) {
    const bool kinematic = case_.setup.axes.has('X') && case_.setup.axes.has('Y') && case_.setup.axes.has('Z');
    write_.units();
    if (choose_.chance(60)) switch_mode();
    if (choose_.chance(30)) write_.word("G01").number('F', choose_.between(1, 50) * 100 * write_.one());
    if (choose_.chance(75)) move();
    write_.end_block();
    if (kinematic && choose_.chance(6)) return along_tool_axis(blocks);
    while (write_.blocks() < blocks) block();
    if (choose_.chance(10)) write_.word(choose_.one_of({"M30", "M02"})).end_block();
    return write_.text();
  }

 private:
  void block() {
    switch (choose_.weighted({24, 8, 8, 5, 22, 5, 5, 5, 4, 3, 3, 3, 3, 2, 2})) {
      case 0:
        return offset();
      case 1:
        return lone_number();
      case 2:
        return cancel();
      case 3:
        switch_mode();
        return choose_.chance(70) ? finish(true) : finish(false);
      case 4:
        return finish(true);
      case 5:
        return machine_position();
      case 6:
        return reference();
      case 7:
        return memory();
      case 8:
        write_.word(fmt::format("G{}", choose_.between(54, 59)));
        return finish(choose_.chance(50));
      case 9:
        return arc();
      case 10:
        plane();
        return finish(choose_.chance(50));
      case 11:
        return shift();
      case 12:
        write_.word(choose_.one_of({"G04 P500", "M08", "S1000", "T1", "G40", "D1", "G40 X5.", "M00", "G30.1 Z0"}));
        return write_.end_block();
      case 13:
        write_.word(choose_.one_of({"H999", "G43 H33", "G10 L11 P0 R1.", "G10 L10 P1 R99999.", "G43", "G28"}));
        return write_.end_block();
      default:
        return several_axes();
    }
  }

  char any_axis() { return linear_[choose_.below(linear_.size())]; }

  void number() {
    const auto entries = static_cast<std::int64_t>(case_.setup.h.size());
    write_.word(fmt::format("H{}", choose_.chance(8)    ? 0
                                   : choose_.chance(95) ? choose_.between(1, entries)
                                                        : entries + 1));
  }

  // Mostly one axis by round figures; zero travel and -0 are ordinary.
  void move() {
    const std::size_t axes = choose_.weighted({70, 20, 10}) + 1;
    std::string used;
    for (std::size_t i = 0; i < axes; ++i) {
      const char letter = choose_.chance(50) ? 'Z' : any_axis();
      if (!case_.setup.axes.has(letter) || used.find(letter) != std::string::npos) continue;
      used += letter;
      travel(letter);
    }
    if (choose_.chance(5))
      for (const char letter : case_.setup.axes.letters())
        if (spec::is_rotary_axis(letter) && choose_.chance(50))
          write_.axis(letter, choose_.between(-90, 90) * write_.one());
  }

  void travel(char letter) {
    const std::int64_t one = write_.one();
    switch (choose_.weighted({60, 25, 10, 5})) {
      case 0:
        write_.axis(letter, choose_.between(-20, 20) * 5 * one);
        break;
      case 1:
        write_.axis(letter, choose_.between(-100 * one, 100 * one));
        break;
      case 2:
        write_.axis(letter, 0);
        break;
      default:
        write_.axis(letter, choose_.between(-9'000 * one, 9'000 * one));
        break;
    }
  }

  void finish(bool with_move) {
    if (with_move) move();
    write_.end_block();
  }

  void switch_mode() {
    write_.incremental(!write_.incremental());
    write_.word(write_.incremental() ? "G91" : "G90");
  }

  void plane() { write_.word(choose_.one_of({"G17", "G18", "G19"})); }

  void offset() {
    if (type_ == Type::b && choose_.chance(40)) plane();
    if (choose_.chance(15)) write_.word(choose_.one_of({"G00", "G01"}));
    write_.word(choose_.chance(70) ? "G43" : "G44");
    if (type_ == Type::c) {
      const char first = choose_.chance(60) ? last_axis_ : any_axis();
      last_axis_ = case_.setup.axes.has(first) ? first : any_axis();
      travel(last_axis_);
      if (choose_.chance(8)) {
        const char second = any_axis();
        if (second != last_axis_) travel(second);
      }
    } else if (choose_.chance(70)) {
      move();
    }
    if (choose_.chance(90)) number();
    write_.end_block();
  }

  // Offsets on two or three axes, then their end: type B by planes, type C by axis words.
  void several_axes() {
    if (type_ == Type::a || !case_.setup.axes.has('X') || !case_.setup.axes.has('Y')) return offset();
    const std::string_view normals = "ZYX";
    for (std::size_t i = choose_.below(2); i < normals.size(); ++i) {
      write_.word(type_ == Type::b ? fmt::format("G{} G43", 17 + i) : std::string("G43"));
      if (type_ == Type::c) travel(normals[i]);
      write_.word(fmt::format("H{}", choose_.between(1, static_cast<std::int64_t>(case_.setup.h.size()))));
      write_.end_block();
    }
    if (choose_.chance(60)) {
      write_.word(choose_.one_of({"G49", "G49", "H0"}));
      return finish(choose_.chance(50));
    }
    absolute_once();
    write_.word(choose_.one_of({"G28", "G53"}));
    for (const char letter : normals)
      if (choose_.chance(80)) travel(letter);
    write_.end_block();
    restoration();
  }

  // The block after a cancellation: what brings the vector back, or not yet.
  void restoration() {
    switch (choose_.below(5)) {
      case 0:
        write_.word(choose_.one_of({"G40", "G40", "D0"}));
        if (choose_.chance(40)) number();
        return finish(true);
      case 1:
        return lone_number();
      case 2:
        return offset();
      default:
        return finish(true);
    }
  }

  void lone_number() {
    number();
    finish(choose_.chance(40));
  }

  void cancel() {
    if (choose_.chance(70)) {
      write_.word("G49");
    } else {
      write_.word("H0");
    }
    finish(choose_.chance(50));
  }

  void absolute_once() {
    if (write_.incremental() && choose_.chance(90)) switch_mode();
  }

  void machine_position() {
    absolute_once();
    if (choose_.chance(20)) write_.word("G49");
    write_.word("G53");
    move();
    write_.end_block();
    if (choose_.chance(50)) restoration();
  }

  void reference() {
    if (choose_.chance(20)) write_.word("G49");
    switch (choose_.below(5)) {
      case 0:
        write_.word("G28");
        break;
      case 1:
        write_.word("G30");
        break;
      case 2:
        write_.word(fmt::format("G30 P{}", choose_.between(2, 4)));
        break;
      case 3:
        write_.word("G30.1");
        break;
      default:
        write_.word("G29");
        break;
    }
    if (choose_.chance(90)) move();
    write_.end_block();
    if (choose_.chance(40)) restoration();
  }

  void memory() {
    const int last = case_.setup.memory == spec::OffsetMemory::c ? 13 : 11;
    const std::int64_t word =
        choose_.chance(90) ? choose_.between(case_.setup.memory == spec::OffsetMemory::a ? 11 : 10, last) : 1;
    write_.word("G10").word(fmt::format("L{}", word)).word(fmt::format("P{}", choose_.between(1, 5)));
    const std::int64_t one = write_.one();
    // Wear reaches a tenth as far as geometry, inch a tenth of mm.
    write_.number('R', choose_.chance(80) ? choose_.between(-9 * one, 9 * one) : choose_.between(-99 * one, 99 * one));
    write_.end_block();
  }

  void arc() {
    if (!case_.setup.axes.has('X') || !case_.setup.axes.has('Y')) return finish(true);
    const std::int64_t r = choose_.between(1, 50) * write_.one();
    const bool clockwise = choose_.chance(50);
    write_.word("G17").word(clockwise ? "G02" : "G03");
    switch (choose_.below(4)) {
      case 0:  // a quarter, by I or J
        write_.axis('X', r).axis('Y', clockwise ? -r : r);
        if (choose_.chance(50))
          write_.number('J', clockwise ? -r : r);
        else
          write_.number('R', r);
        break;
      case 1:  // a half
        write_.axis('X', 2 * r).number('I', r);
        break;
      case 2:  // a full circle
        write_.number('I', r);
        break;
      default:  // by radius, either part
        write_.axis('X', choose_.between(1, 19) * r / 10).number('R', choose_.chance(60) ? r : -r);
        break;
    }
    if (case_.setup.axes.has('Z') && choose_.chance(20)) travel('Z');
    write_.end_block();
    if (choose_.chance(70)) write_.word(choose_.one_of({"G00", "G01"}));
  }

  void shift() {
    const char letter = any_axis();
    write_.word("G92");
    const std::int64_t counts = choose_.between(-50, 50) * write_.one();
    write_.number(letter, counts);
    write_.place(letter, counts);
    write_.end_block();
  }

  // The length along the tool axis: G43.5.
  std::string along_tool_axis(std::uint32_t blocks) {
    write_.word("G43.5");
    number();
    if (choose_.chance(80))
      write_.word(choose_.one_of({"I3. K4.", "J-3. K4.", "I1. J2. K2.", "K1.", "I0.6 K0.8", "I1."}));
    finish(choose_.chance(50));
    while (write_.blocks() + 1 < blocks) {
      if (choose_.chance(30))
        write_.word(choose_.one_of({"I4. K3.", "J3. K4.", "I-1. J2. K2.", "K-1.", "I.1 J.2 K.3"}));
      if (choose_.chance(20)) write_.word(fmt::format("H{}", choose_.between(0, 2)));
      finish(choose_.chance(90));
    }
    write_.word("G49");
    finish(choose_.chance(50));
    return write_.text();
  }

  Choices& choose_;
  spec::Case& case_;
  ProgramWriter write_;
  Type type_;
  std::string linear_;
  char last_axis_ = 'Z';
};

}  // namespace

spec::Case tool_length_offset(Choices& choose, std::uint32_t blocks) {
  spec::Case c;
  c.setup = random_setup(choose, choose.chance(15) ? Kinematics::always : Kinematics::maybe);
  c.program = LengthOffset(choose, c).program(blocks);
  return c;
}

}  // namespace toolcomp::fuzz
