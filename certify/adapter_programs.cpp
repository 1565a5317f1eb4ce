// SPDX-License-Identifier: Apache-2.0
#include "certify/adapter_programs.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "certify/adapter_contour.h"
#include "fuzz/gen/choices.h"
#include "spec/language/byte_source.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify {
namespace {

using fuzz::Choices;

constexpr std::uint32_t kH = 1;
constexpr std::uint32_t kD = 2;
constexpr std::int64_t kThousand = 1000;  // one unit in thousandths

std::string thousandths(std::int64_t value) {
  const std::int64_t size = value < 0 ? -value : value;
  return fmt::format("{}{}.{:03}", value < 0 ? "-" : "", size / kThousand, size % kThousand);
}

spec::Decimal decimal(std::int64_t thousandths_of) { return *spec::parse_decimal(thousandths(thousandths_of)); }

class Program {
 public:
  Program(Choices& choose, spec::Setup setup) : choose_(choose) { case_.setup = std::move(setup); }

  spec::Case take() && { return std::move(case_); }

  // Offsets in space, arcs in all planes and helices.
  void length_offset() {
    case_.section = "fanuc/tool-length-offset";
    set_offset(case_.setup.h, kH, choose_.between(-40 * kThousand, 80 * kThousand));
    set_offset(case_.setup.h, kH + 1, choose_.between(-40 * kThousand, 80 * kThousand));
    add("G90 G17 G40 G49");
    add("G00 " + words("XYZ", 40));
    add(fmt::format("G00 G43 H{} Z{}", kH, coordinate(30)));
    add("G01 " + words("XY", 40) + " F3000");
    const auto blocks = choose_.between(4, 9);
    for (std::int64_t i = 0; i < blocks; ++i) {
      if (choose_.chance(15))
        add(fmt::format("G01 G43 H{} Z{}", kH + choose_.below(2), coordinate(30)));
      else if (choose_.chance(40))
        arc("");
      else
        add((choose_.chance(15) ? "G00 " : "G01 ") + some_words("XYZ", 40));
    }
    add("G49 G00 Z" + coordinate(40));
    add("M30");
  }

  // A closed contour from inside, or its mirror image.
  void cutter_compensation() {
    case_.section = "fanuc/cutter-compensation-c";
    const std::int64_t radius = choose_.between(kThousand / 2, 5 * kThousand);
    set_offset(case_.setup.d, kD, radius);
    const Contour contour = inside_contour(choose_, radius);
    const bool mirrored = choose_.chance(50);
    const bool in_zx = choose_.chance(40);
    const std::string letters = in_zx ? "ZXY" : "XYZ";  // of the plane, and across it
    const auto place = [&](const Point& p) {
      return fmt::format("{}{} {}{}", letters[0], thousandths(p.u), letters[1], thousandths(mirrored ? -p.v : p.v));
    };
    const auto across = [&] { return choose_.chance(25) ? fmt::format(" {}{}", letters[2], coordinate(10)) : ""; };
    add(in_zx ? "G90 G18 G40 G49" : "G90 G17 G40 G49");
    add("G00 " + place(contour.approach) + fmt::format(" {}{}", letters[2], coordinate(20)));
    add(fmt::format("G01 {} D{} {} F3000", mirrored ? "G42" : "G41", kD, place(contour.start)));
    for (const Leg& leg : contour.legs) {
      if (leg.radius == 0) {
        add("G01 " + place(leg.end) + across());
        continue;
      }
      const bool ccw = leg.ccw != mirrored;
      add(fmt::format("{} {} R{}", ccw ? "G03" : "G02", place(leg.end), thousandths(leg.radius)) + across());
    }
    add("G01 G40 " + place(contour.retract));
    add("M30");
  }

  // Lines and arcs of the tip with the tool turning, lines without, turns without a line.
  void tool_center_point() {
    case_.section = "fanuc/tool-center-point-control";
    std::string rotary;
    for (std::size_t i = 0; i < case_.setup.axes.size(); ++i)
      if (spec::is_rotary_axis(case_.setup.axes.letter(i))) rotary += case_.setup.axes.letter(i);
    set_offset(case_.setup.h, kH, choose_.between(20 * kThousand, 120 * kThousand));
    add("G90 G17 G40 G49");
    add("G00 " + words("XYZ", 40) + zeros(rotary));
    add(fmt::format("G01 G43.4 H{} {} F3000", kH, words("XYZ", 30)));
    const auto blocks = choose_.between(4, 9);
    for (std::int64_t i = 0; i < blocks; ++i) {
      const std::string turns = choose_.chance(80) ? " " + some_words(rotary, 50) : "";
      if (choose_.chance(15))
        add("G01" + (turns.empty() ? " " + some_words(rotary, 50) : turns));
      else if (choose_.chance(25))
        arc(turns);
      else
        add("G01 " + some_words("XYZ", 40) + turns);
    }
    add("G01" + zeros(rotary));
    add("G49 " + words("XYZ", 40));
    add("M30");
  }

 private:
  void add(const std::string& block) { case_.program += block + "\n"; }

  static void set_offset(std::map<std::uint32_t, spec::OffsetEntry>& table, std::uint32_t number,
                         std::int64_t thousandths_of) {
    table[number].geometry = decimal(thousandths_of);
  }

  // In ±size, thousandths.
  std::string coordinate(std::int64_t size) {
    return thousandths(choose_.between(-size * kThousand, size * kThousand));
  }
  std::string words(std::string_view letters, std::int64_t size) {
    std::string out;
    for (const char letter : letters) out += (out.empty() ? "" : " ") + std::string(1, letter) + coordinate(size);
    return out;
  }
  // One of the letters at least.
  std::string some_words(std::string_view letters, std::int64_t size) {
    std::string chosen;
    for (const char letter : letters)
      if (choose_.chance(65)) chosen += letter;
    if (chosen.empty()) chosen = letters[choose_.below(letters.size())];
    return words(chosen, size);
  }
  static std::string zeros(std::string_view letters) {
    std::string out;
    for (const char letter : letters) out += fmt::format(" {}0.", letter);
    return out;
  }

  // An incremental arc by R in some plane, seldom a helix; behind it other words, increments too.
  void arc(const std::string& others) {
    struct Plane {
      const char* code;
      const char* letters;
    };
    static constexpr std::array<Plane, 3> kPlanes{{{"G17", "XYZ"}, {"G18", "ZXY"}, {"G19", "YZX"}}};
    const Plane& plane = kPlanes.at(choose_.below(kPlanes.size()));
    const double angle = static_cast<double>(choose_.below(360)) * std::numbers::pi / 180;
    const auto chord = static_cast<double>(choose_.between(5 * kThousand, 30 * kThousand));
    // Longer than half the chord by a margin: an arc of half a turn is ill-conditioned by R.
    const double radius = chord * static_cast<double>(choose_.between(55, 150)) / 100;
    const auto part = [&](double of_chord) { return thousandths(std::llround(chord * of_chord)); };
    std::string block = fmt::format("{} {} G91 {}{} {}{} R{}{}", plane.code, choose_.chance(50) ? "G02" : "G03",
                                    plane.letters[0], part(std::cos(angle)), plane.letters[1], part(std::sin(angle)),
                                    choose_.chance(30) ? "-" : "", thousandths(std::llround(radius)));
    if (choose_.chance(30)) block += fmt::format(" {}{}", plane.letters[2], coordinate(10));
    add(block + others);
    add("G17 G90");
  }

  Choices& choose_;
  spec::Case case_;
};

}  // namespace

spec::Case machine_program(const spec::Setup& setup, std::uint64_t seed) {
  fuzz::SeededSource source(seed);
  Choices choose(source);
  Program program(choose, setup);
  const auto kinematics = setup.parameters.find(spec::ParameterId{19680, -1});
  if (kinematics != setup.parameters.end() && !kinematics->second.is_zero())
    program.tool_center_point();
  else if (choose.chance(40))
    program.length_offset();
  else
    program.cutter_compensation();
  spec::Case c = std::move(program).take();
  c.source.seed = std::to_string(seed);
  return c;
}

std::uint64_t program_seed(std::uint64_t seed, std::uint32_t index) {
  constexpr std::uint64_t kApart = 1'000'003;
  return seed * kApart + index;
}

std::vector<MachineProgram> machine_programs(const std::vector<std::filesystem::path>& setups, std::uint32_t count,
                                             std::uint64_t seed) {
  std::vector<spec::Setup> read;
  read.reserve(setups.size());
  for (const std::filesystem::path& file : setups)
    read.push_back(spec::read_setup_toml(spec::read_file(file.string()), file.string()));
  std::vector<MachineProgram> programs;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t which = i % setups.size();
    MachineProgram& program = programs.emplace_back();
    program.c = machine_program(read[which], program_seed(seed, i));
    program.machine = setups[which].stem().string();
    program.c.id = fmt::format("{}-{}", program.machine, i + 1);
  }
  return programs;
}

}  // namespace toolcomp::certify
