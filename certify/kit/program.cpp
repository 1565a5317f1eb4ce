// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "certify/kit/marks.h"
#include "certify/kit/offsets.h"

namespace toolcomp::certify::kit {
namespace {

// What stands before the way back to the place of the marks, a line each. That place is {place}, its rotary axes alone
// {turned}, in machine coordinates {machine}: G53 takes the shift of G45 to G48 away. The first is what every control
// runs alike: it turns back under tool center point control, and takes a length off while it moves.
constexpr std::array<std::string_view, 8> kEndings = {
    "G40\nG90 G00{turned}\nG49 G00 {place}\n",
    "G40\nG49\n",
    "G00 G40\nG49\n",
    "G00 G40\nG90 G00 {place}\nG49\n",
    "G40\nG90 G00 {place}\nG49\n",
    "G49\nG40\n",
    "G40\nG49\nG90 G53 G00 {machine}\n",
    "G00 G40\nG49\nG90 G53 G00 {machine}\n",
};

// The place of the marks in machine coordinates.
spec::AxisTable machine_place(const spec::Setup& setup) {
  spec::AxisTable place = setup.workpiece[0];
  for (const auto& [axis, value] : setup.position) place[axis] = sum(place[axis], value);
  return place;
}

std::string word(char axis, const spec::AxisTable& place) {
  const auto entry = place.find(axis);
  return std::string(1, axis) + with_point(entry == place.end() ? spec::Decimal{} : entry->second);
}

// Those of the rotary axes, a blank before each.
std::string rotary_words(const spec::Setup& setup, const spec::AxisTable& place) {
  std::string words;
  for (const char axis : setup.axes.letters())
    if (spec::is_rotary_axis(axis)) words += " " + word(axis, place);
  return words;
}

// Not every control reads small letters in a comment.
std::string in_capitals(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  return text;
}

// Lines one behind the other, and what stands in which.
class Writer {
 public:
  Writer(const Machine& machine, ProgramKind kind) : machine_(machine), kind_(kind) {}

 protected:
  void add(std::string_view line) {
    text_ += line;
    text_ += '\n';
    ++line_;
  }

  void add_lines(std::string_view lines) {
    while (!lines.empty()) {
      const std::size_t end = lines.find('\n');
      add(lines.substr(0, end));
      lines.remove_prefix(end + 1);
    }
  }

  ProgramText written() { return {std::move(text_), std::move(cases_), marks_}; }

  // Of the dialect.
  virtual void rest(unsigned milliseconds) = 0;
  virtual void step(bool up) = 0;  // one unit up, or back

  // A rest between moves: whatever the machine stood before and stands behind it is not counted with it.
  void rest_apart(unsigned milliseconds) {
    step(true);
    step(false);
    rest(milliseconds);
    marks_.last_rest = line_;
    step(true);
    step(false);
  }

  void mark(unsigned number) {
    const auto digits = digits_of(number);
    marks_.steps = line_ + 1;
    step(true);
    step(false);
    marks_.first_rest = line_ + 1;
    for (std::size_t i = 0; i < digits.size(); ++i) {
      if (i > 0) step(i % 2 == 1);
      rest(digit_length(digits.at(i)));
    }
    step(false);
  }

  ~Writer() = default;

  const Machine& machine_;
  ProgramKind kind_;
  std::string text_;
  std::uint64_t line_ = 0;
  std::vector<CaseLines> cases_;
  MarkLines marks_;
};

class FanucWriter final : private Writer {
 public:
  FanucWriter(const Machine& machine, ProgramKind kind)
      : Writer(machine, kind),
        place_(place_words(machine.setup, machine.setup.position)),
        turned_(rotary_words(machine.setup, machine.setup.position)) {}

  void head(unsigned number, std::string_view title) {
    add("%");
    add(fmt::format("O{} ({})", number, title));
    // What the model does not know of is cancelled in a block that it skips.
    add("/G80 G69");
    // In a block of their own, as a control wants them.
    add(machine_.setup.units == spec::Units::inch ? "G20" : "G21");
    safe();
    add("G00 " + place_);
    if (kind_ == ProgramKind::recorded) mark(number - kFirstProgram);
  }

  void add_case(const CaseText& c, std::size_t index) {
    CaseLines lines;
    add(fmt::format("(CASE {} {})", index + 1, in_capitals(c.id)));
    add("G00 " + place_words(machine_.setup, c.start));
    lines.first = line_ + 1;
    for (std::size_t i = 0; i < c.blocks.size(); ++i) {
      spec::Block block = c.blocks[i];
      block.n = (index + 1) * 1000 + i + 1;
      add(spec::to_string(block));
    }
    lines.last = line_;
    add_lines(fmt::format(fmt::runtime(kEndings.at(c.ending)), fmt::arg("place", place_), fmt::arg("turned", turned_),
                          fmt::arg("machine", place_words(machine_.setup, machine_place(machine_.setup)))));
    safe();
    add("D0 H0");
    add_lines(c.restore);
    add("G00 " + place_);
    if (kind_ == ProgramKind::recorded) rest_apart(kCaseEnd);
    lines.end = line_;
    cases_.push_back(lines);
  }

  ProgramText end() {
    if (kind_ == ProgramKind::recorded) rest_apart(kProgramEnd);
    add("M30");
    add("%");
    return written();
  }

 private:
  void safe() {
    const bool inch = machine_.setup.units == spec::Units::inch;
    add(fmt::format("G00 G90 G40 G49 G17 G94 G54 F{}.", inch ? 40 : 1000));
  }

  void rest(unsigned milliseconds) override { add(fmt::format("G04 P{}", milliseconds)); }

  void step(bool up) override {
    add(fmt::format("G91 G01 {}{}1.", mark_axis(machine_), up ? "" : "-"));
    add("G90 G00");
  }

  std::string place_;
  std::string turned_;
};

class KlartextWriter final : private Writer {
 public:
  KlartextWriter(const Machine& machine, ProgramKind kind) : Writer(machine, kind) {}

  void head(unsigned number, std::string_view title) {
    number_ = number;
    add(fmt::format("BEGIN PGM {} {}", number, unit()));
    add(fmt::format("; {}", title));
    safe();
    go(machine_.setup.position);
    add(fmt::format("L I{}+0 R0 F1000", mark_axis(machine_)));
    if (kind_ == ProgramKind::recorded) mark(number - kFirstProgram);
  }

  void add_case(const CaseText& c, std::size_t index) {
    CaseLines lines;
    add(fmt::format("; CASE {} {}", index + 1, c.id));
    go(c.start);
    lines.first = line_ + 1;
    for (const spec::klartext::Block& statement : c.statements) add(klartext_of(statement));
    lines.last = line_;
    safe();
    go(machine_.setup.position);
    if (kind_ == ProgramKind::recorded) rest_apart(kCaseEnd);
    lines.end = line_;
    cases_.push_back(lines);
  }

  ProgramText end() {
    if (kind_ == ProgramKind::recorded) rest_apart(kProgramEnd);
    add(fmt::format("END PGM {} {}", number_, unit()));
    return written();
  }

 private:
  [[nodiscard]] std::string_view unit() const { return machine_.setup.units == spec::Units::inch ? "INCH" : "MM"; }

  void safe() {
    add("FUNCTION RESET TCPM");
    add("FUNCTION PROG PATH OFF");
    add("FUNCTION CORRDATA RESET");
    add("M108");
    add("CYCL DEF 7.0 DATUM SHIFT");
    for (const char axis : std::string_view("XYZ"))
      if (machine_.setup.axes.has(axis)) add(fmt::format("CYCL DEF 7.{} {}+0", axis - 'X' + 1, axis));
  }

  void go(const spec::AxisTable& place) {
    std::string words;
    for (const char axis : machine_.setup.axes.letters()) {
      const auto entry = place.find(axis);
      const spec::Decimal value = entry == place.end() ? spec::Decimal{} : entry->second;
      words += fmt::format(" {}{}{}", axis, value.negative ? "" : "+", spec::to_string(value));
    }
    add("L" + words + " R0 FMAX");
  }

  void rest(unsigned milliseconds) override {
    add("CYCL DEF 9.0 DWELL TIME");
    add(fmt::format("CYCL DEF 9.1 DWELL {}.{}", milliseconds / 1000, milliseconds % 1000 / 100));
  }

  void step(bool up) override { add(fmt::format("L I{}{}1 R0 F1000", mark_axis(machine_), up ? "+" : "-")); }

  unsigned number_ = 0;
};

template <class DialectWriter>
ProgramText write_by(DialectWriter writer, unsigned number, std::string_view title,
                     const std::vector<CaseText>& cases) {
  writer.head(number, title);
  for (std::size_t i = 0; i < cases.size(); ++i) writer.add_case(cases[i], i);
  return writer.end();
}

}  // namespace

std::size_t ending_count(spec::Control control) { return control == spec::Control::fanuc ? kEndings.size() : 1; }

std::string program_name(spec::Control control, unsigned number) {
  return (control == spec::Control::fanuc ? "O" : "") + std::to_string(number);
}

std::size_t block_count(const CaseText& text) { return std::max(text.blocks.size(), text.statements.size()); }

void cut_to(CaseText& text, std::size_t count) {
  text.blocks.resize(std::min(count, text.blocks.size()));
  text.statements.resize(std::min(count, text.statements.size()));
}

std::string place_words(const spec::Setup& setup, const spec::AxisTable& place) {
  std::string words;
  for (const char axis : setup.axes.letters()) words += (words.empty() ? "" : " ") + word(axis, place);
  return words;
}

std::string between_rests(std::string_view text, const MarkLines& marks) {
  std::string cut;
  for (std::uint64_t line = 1; line <= marks.last_rest && !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (line < marks.steps || line >= marks.first_rest) cut += text.substr(0, end);
    cut += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return cut;
}

ProgramText write_program(const Machine& machine, unsigned number, std::string_view title, ProgramKind kind,
                          const std::vector<CaseText>& cases) {
  return machine.setup.control == spec::Control::fanuc ? write_by(FanucWriter(machine, kind), number, title, cases)
                                                       : write_by(KlartextWriter(machine, kind), number, title, cases);
}

}  // namespace toolcomp::certify::kit
