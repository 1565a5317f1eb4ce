#include "certify/kit/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "certify/kit/marks.h"
#include "certify/kit/offsets.h"

namespace toolcomp::certify::kit {
namespace {

// What stands before the way back to the place of the marks, a line each. That place is {place}, in machine coordinates
// {machine}: G53 takes the shift of G45 to G48 away.
constexpr std::array<std::string_view, 7> kEndings = {
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

class Writer {
 public:
  Writer(const Machine& machine, ProgramKind kind) : machine_(machine), kind_(kind) {
    place_ = place_words(machine.setup, machine.setup.position);
  }

  void head(unsigned number, std::string_view title) {
    add("%");
    add(fmt::format("O{} ({})", number, title));
    // What the model does not know of is cancelled in a block that it skips.
    add("/G80 G69");
    safe();
    add("G00 " + place_);
    if (kind_ == ProgramKind::recorded) mark(number - kFirstProgram);
  }

  void add_case(const CaseText& c, std::size_t index) {
    CaseLines lines;
    add(fmt::format("(CASE {} {})", index + 1, c.id));
    add("G00 " + place_words(machine_.setup, c.start));
    lines.first = line_ + 1;
    for (std::size_t i = 0; i < c.blocks.size(); ++i) {
      spec::Block block = c.blocks[i];
      block.n = (index + 1) * 1000 + i + 1;
      add(spec::to_string(block));
    }
    lines.last = line_;
    add_lines(fmt::format(fmt::runtime(kEndings.at(c.ending)), fmt::arg("place", place_),
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
    return {std::move(text_), std::move(cases_), marks_};
  }

 private:
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

  void safe() {
    const bool inch = machine_.setup.units == spec::Units::inch;
    add(fmt::format("G00 G90 G40 G49 G17 G94 G54 {}", inch ? "G20 F40." : "G21 F1000."));
  }

  void rest(unsigned milliseconds) { add(fmt::format("G04 P{}", milliseconds)); }

  // A rest between moves: whatever the machine stood before and stands behind it is not counted with it.
  void rest_apart(unsigned milliseconds) {
    step(true);
    step(false);
    rest(milliseconds);
    marks_.last_rest = line_;
    step(true);
    step(false);
  }

  // One unit up, or back.
  void step(bool up) {
    const char axis = mark_axis(machine_);
    add(fmt::format("G91 G01 {}{}1.", axis, up ? "" : "-"));
    add("G90 G00");
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

  const Machine& machine_;
  ProgramKind kind_;
  std::string place_;
  std::string text_;
  std::uint64_t line_ = 0;
  std::vector<CaseLines> cases_;
  MarkLines marks_;
};

}  // namespace

std::size_t ending_count() { return kEndings.size(); }

std::string place_words(const spec::Setup& setup, const spec::AxisTable& place) {
  std::string words;
  for (const char axis : setup.axes.letters()) {
    const auto entry = place.find(axis);
    words += (words.empty() ? "" : " ") + std::string(1, axis) +
             with_point(entry == place.end() ? spec::Decimal{} : entry->second);
  }
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
  Writer writer(machine, kind);
  writer.head(number, title);
  for (std::size_t i = 0; i < cases.size(); ++i) writer.add_case(cases[i], i);
  return writer.end();
}

}  // namespace toolcomp::certify::kit
