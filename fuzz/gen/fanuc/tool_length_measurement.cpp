// SPDX-License-Identifier: Apache-2.0
// G37 programs: the tool meets the signal inside the permitted zone, on its ends, a unit beyond, or not at all.
#include <fmt/format.h>

#include "fuzz/gen/fanuc/program_writer.h"
#include "fuzz/gen/fanuc/setups.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {
namespace {

class LengthMeasurement {
 public:
  LengthMeasurement(Choices& choose, spec::Case& c) : choose_(choose), case_(c), write_(choose, c.setup) {
    const std::int64_t one = write_.one();
    // Deceleration distance and half of the permitted zone.
    half_zone_ = choose.chance(80) ? choose.between(0, 8) * one : choose.between(0, 8 * one);
    slow_ = half_zone_ + (choose.chance(80) ? choose.between(1, 20) * one : choose.between(1, 3));
    if (choose.chance(3)) slow_ = half_zone_ - choose.between(0, 1);
    set(6241, choose.chance(97) ? choose.between(1, 100) * 10 : choose.between(-1, 0), 0);
    if (choose.chance(96)) set(6251, slow_, increment_decimals(c.setup));
    if (choose.chance(96)) set(6254, half_zone_, increment_decimals(c.setup));
    if (choose.chance(2)) c.setup.parameters.erase({6241, -1});
    for (const char letter : c.setup.axes.letters())
      if (choose.chance(letter == 'Z' ? 95 : 60)) {
        signal_[letter] = choose.between(-30, 30) * 10 * one;
        c.setup.measurement[letter] = decimal(signal_[letter], increment_decimals(c.setup));
      }
  }

  std::string program(std::uint32_t blocks) {
    write_.units();
    if (choose_.chance(20)) {
      write_.word("G92").number('Z', 500 * write_.one()).place('Z', 500 * write_.one());
      write_.end_block();
    }
    if (choose_.chance(20)) travel();
    if (choose_.chance(94)) {
      // With OFH a lone H is the cutter's.
      if (case_.setup.bit(5001, 2)) write_.word("G43");
      number();
    }
    write_.end_block();
    bool measured = false;
    while (write_.blocks() < blocks || !measured) {
      if (!measured || choose_.chance(35)) {
        measure();
        measured = true;
      } else {
        between();
      }
    }
    return write_.text();
  }

 private:
  void set(std::uint32_t parameter, std::int64_t counts, int decimals) {
    const std::int64_t positive = counts < 0 ? 0 : counts;
    case_.setup.parameters[{parameter, -1}] = decimal(positive, decimals);
  }

  void number() {
    const auto entries = static_cast<std::int64_t>(case_.setup.h.size());
    const std::int64_t n = choose_.chance(96) ? choose_.between(1, entries) : 0;
    write_.word(fmt::format("H{}", n));
  }

  void travel() {
    const char letter = choose_.one_of({'X', 'Y', 'Z', 'Z'});
    if (!case_.setup.axes.has(letter)) return;
    write_.axis(letter, choose_.between(-20, 20) * 5 * write_.one());
  }

  void absolute() {
    if (!write_.incremental()) return;
    write_.incremental(false);
    write_.word("G90");
  }

  // Where the signal comes on, counted from the commanded coordinate along the movement.
  std::int64_t reached() {
    const std::int64_t beside = choose_.between(-1, 1);
    switch (choose_.weighted({36, 10, 10, 10, 12, 6, 10, 6})) {
      case 0:
        return half_zone_ == 0 ? 0 : choose_.between(-half_zone_, half_zone_);
      case 1:
        return 0;
      case 2:
        return half_zone_ + beside;
      case 3:
        return -half_zone_ + beside;
      case 4:
        return -slow_ + beside;
      case 5:  // before the slow part: on already
        return -slow_ - choose_.between(1, 50) * write_.one();
      case 6:
        return half_zone_ + choose_.between(1, 50) * write_.one();
      default:
        return -choose_.between(0, slow_ < 1 ? 1 : slow_);
    }
  }

  void measure() {
    const char letter = choose_.chance(80) || signal_.empty() ? 'Z' : any_signal();
    if (!case_.setup.axes.has(letter)) return;
    const std::int64_t one = write_.one();
    const std::int64_t sense = choose_.chance(70) ? -1 : 1;  // of the movement
    const std::int64_t target = signal(letter) - sense * reached();
    approach(letter, target - sense * start_distance());
    if (!choose_.chance(4)) absolute();
    write_.word("G37");
    if (choose_.chance(2)) {
      write_.end_block();
      return;
    }
    write_.axis(letter, target - write_.at(letter));
    if (choose_.chance(2)) write_.axis(letter == 'X' ? 'Y' : 'X', one);
    if (choose_.chance(2)) number();
    if (choose_.chance(3)) write_.word(choose_.one_of({"F100", "M08", "G01", "G00", "G43", "G54", "D1", "G40"}));
    write_.end_block();
  }

  char any_signal() {
    auto it = signal_.begin();
    std::advance(it, static_cast<std::ptrdiff_t>(choose_.below(signal_.size())));
    return it->first;
  }

  [[nodiscard]] std::int64_t signal(char letter) const {
    const auto found = signal_.find(letter);
    return found == signal_.end() ? 0 : found->second;
  }

  // Mostly so far that there is a rapid part; on its limit; inside the slow part; seldom on the coordinate itself.
  std::int64_t start_distance() {
    switch (choose_.weighted({60, 14, 20, 2})) {
      case 0:
        return slow_ + choose_.between(1, 40) * 10 * write_.one();
      case 1:
        return slow_ + choose_.between(-1, 1);
      case 2:
        return choose_.between(1, slow_ < 1 ? 1 : slow_);
      default:
        return 0;
    }
  }

  // A block of its own to where the measurement begins, unless the tool is there; the length offset shifts it.
  void approach(char letter, std::int64_t from) {
    if (write_.at(letter) == from && choose_.chance(50)) return;
    if (choose_.chance(20)) write_.word(choose_.one_of({"G00", "G01"}));
    write_.axis(letter, from - write_.at(letter));
    write_.end_block();
  }

  void between() {
    switch (choose_.weighted({18, 22, 10, 10, 6, 6, 8, 6, 6, 8})) {
      case 0:
        travel();
        return write_.end_block();
      case 1: {  // the new length at work
        write_.word(choose_.chance(75) ? "G43" : "G44");
        if (case_.setup.bit(5001, 0) || choose_.chance(60)) write_.axis('Z', choose_.between(-9, 9) * write_.one());
        if (choose_.chance(40)) number();
        return write_.end_block();
      }
      case 2:
        write_.word("G49");
        if (choose_.chance(50)) travel();
        return write_.end_block();
      case 3:
        number();
        return write_.end_block();
      case 4:
        write_.incremental(!write_.incremental());
        write_.word(write_.incremental() ? "G91" : "G90");
        travel();
        return write_.end_block();
      case 5:
        write_.word("G10");
        write_.word(case_.setup.memory == spec::OffsetMemory::a ? "L11" : choose_.one_of({"L10", "L11"}));
        write_.word(fmt::format("P{}", choose_.between(1, 3)));
        write_.number('R', choose_.between(-50, 50) * write_.one() / 10);
        return write_.end_block();
      case 6:
        write_.word(choose_.one_of({"G45 Z10. D1", "G46 Z-10. D1", "G92 Z100.", "G55", "G54", "G28 Z0", "G53 Z0"}));
        return write_.end_block();
      case 7:
        write_.word(choose_.one_of({"G41 X20. D1", "G42 D1", "G40", "G41.3 D1", "G43.5", "G37 X1. Z1.", "G37 Z0 H1",
                                    "G91 G37 Z-5.", "G37", "G37 H1"}));
        return write_.end_block();
      case 8:
        write_.word(choose_.one_of({"H0", "M08", "G04 P100", "G01 F500", "G18", "G19", "G17"}));
        return write_.end_block();
      default:
        return measure();
    }
  }

  Choices& choose_;
  spec::Case& case_;
  ProgramWriter write_;
  std::map<char, std::int64_t> signal_;
  std::int64_t slow_ = 0;
  std::int64_t half_zone_ = 0;
};

}  // namespace

spec::Case tool_length_measurement(Choices& choose, std::uint32_t blocks) {
  spec::Case c;
  c.setup = random_setup(choose, Kinematics::none);
  if (choose.chance(80)) c.setup.workpiece.front().clear();
  c.program = LengthMeasurement(choose, c).program(blocks);
  return c;
}

}  // namespace toolcomp::fuzz
