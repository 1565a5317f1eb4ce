// SPDX-License-Identifier: Apache-2.0
// program: faults
// link: toolcomp_fast_faulty
// The law of lines as arrays (fast/batch): their moves are those of the same program as text, block by block, bit for
// bit, by every kind of instructions. Paths are random walks in which smooth pieces, corners of any angle, reversals,
// halts and long ways come in turn; every mistake seeded into the arrays breaks the law.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fast/batch/batch.h"
#include "fast/fanuc/engine.h"
#include "fast/heidenhain/engine.h"
#include "fuzz/faults/fault.h"
#include "spec/language/event_json.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/setup_format.h"
#include "tests/effort.h"

namespace toolcomp::fast {
namespace {

// How values of a column come about.
enum class Walk : std::uint8_t {
  place,   // X, Y, Z
  angle,   // rotary words
  vector,  // I J K, of any length
  unit,    // of Klartext: of length 1
};

struct Shape {
  std::string_view section;
  std::string_view setup;
  std::string_view head;
  std::vector<std::pair<std::string_view, Walk>> words;
  std::string_view tail;
  bool arrays = false;  // lines of this section go as arrays
};

constexpr std::string_view kThreeAxes = R"(
control = "fanuc"
axes = ["X", "Y", "Z"]
[parameters]
6241 = 1000
6251 = 20
6254 = 5
[measurement]
Z = "198.0"
[offsets.H]
1 = 15
[offsets.D]
1 = "RADIUS"
)";
constexpr std::string_view kHead = R"(
control = "fanuc"
axes = ["X", "Y", "Z", "B", "C"]
[parameters]
19680 = 2
19681 = 5
19682 = 3
19686 = 4
19687 = 2
[offsets.H]
1 = 100
[offsets.D]
1 = "RADIUS"
)";
constexpr std::string_view kKlartext = R"(
control = "heidenhain"
axes = ["X", "Y", "Z", "A", "C"]
[[tool]]
number = 1
L = 80
R = 6
R2 = 2
DR = "-0.05"
DR2 = "-0.03"
)";

std::vector<Shape> shapes() {
  using enum Walk;
  const std::vector<std::pair<std::string_view, Walk>> xy{{"X", place}, {"Y", place}};
  const std::vector<std::pair<std::string_view, Walk>> xyz{{"X", place}, {"Y", place}, {"Z", place}};
  const auto with = [&](std::initializer_list<std::pair<std::string_view, Walk>> more) {
    auto all = xyz;
    all.insert(all.end(), more);
    return all;
  };
  const auto ijk = with({{"I", vector}, {"J", vector}, {"K", vector}});
  const auto bc = with({{"B", angle}, {"C", angle}});
  return {
      {"fanuc/tool-length-offset", kThreeAxes, "G90 G01 F1000\nG43 H1 Z5.\n", xyz, "G49 Z0\n", true},
      {"fanuc/tool-length-offset", kHead, "G90 G01 F1000\nG44 H1 Z5.\n", bc, "G49 Z0\n", true},
      {"fanuc/tool-length-measurement", kThreeAxes, "G90 G00 H01 Z760.\nG37 Z200.\n", xyz, "", true},
      {"fanuc/tool-offset", kThreeAxes, "G90 G01 F1000\nG46 D1 X10.\n", xyz, ""},
      {"fanuc/cutter-compensation-c", kThreeAxes, "G90 G17 G01 F1000 X-5. Y-5.\nG41 D1 X0 Y0\n", xy, "G40 X0 Y0\n",
       true},
      {"fanuc/cutter-compensation-c", kThreeAxes, "G90 G17 G01 F1000 X-5. Y-5.\nG42 D1 X0 Y0\n", xyz, "G40 X0 Y0\n"},
      {"fanuc/cutter-compensation-c",
       kHead,
       "G90 G18 G43 H1 G01 F1000 X-5. Z-5.\nG42 D1 X0 Z0\n",
       {{"Z", place}, {"X", place}},
       "G40 X0 Z0\n"},
      {"fanuc/cutter-compensation-c",
       kThreeAxes,
       "G90 G19 G01 F1000 Y-5. Z-5.\nG41 D1 Y0 Z0\n",
       {{"Y", place}},
       "G40 X0 Z0\n"},
      {"fanuc/leading-edge-offset", kHead, "G90 G01 F1000\nB10. C5.\nG41.3 D1\n", bc, "G40\n"},
      {"fanuc/tool-side-compensation", kHead, "G90 G01 F1000\nG41.2 D1 X1. Y1.\n", xyz, "G40 X0\n", true},
      {"fanuc/tool-side-compensation", kHead, "G90 G01 F1000\nG41.2 D1 X1. Y1.\n", bc, "G40 X0\n"},
      {"fanuc/tool-side-compensation", kThreeAxes, "G43.5 H0 I0 J0 K1\nG90 G01 F1000\nG41.6 D1 X1. Y1. I0 J0 K1\n", ijk,
       "G40 X0\n", true},
      {"fanuc/tool-center-point-control", kHead, "G90 G01 F1000\nG43.4 H1 X1. Y1.\n", bc, "G49\n"},
      {"fanuc/tool-posture-control", kHead, "G90 G01 F1000\nG43.5 H1 X1. Y1. I0 J0 K1\n", ijk, "G49\n"},
      {"heidenhain/face-milling", kKlartext, "BEGIN PGM T MM\nTOOL CALL 1 Z S1000 DR-0.02\nL X0 Y0 Z0 R0 F1000 M128\n",
       with({{"NX", unit}, {"NY", unit}, {"NZ", unit}, {"TX", unit}, {"TY", unit}, {"TZ", unit}}), "END PGM T MM\n",
       true},
      {"heidenhain/face-milling", kKlartext, "BEGIN PGM T MM\nTOOL CALL 1 Z S1000 DR-0.02\nL X0 Y0 Z0 R0 F1000\n",
       with({{"NX", unit}, {"NY", unit}, {"NZ", unit}}), "END PGM T MM\n", true},
      {"heidenhain/programmed-contour", kKlartext,
       "BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nFUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\nFUNCTION PROG "
       "PATH IS CONTOUR\nL X0 Y0 Z0 R0 F1000\n",
       with({{"NX", unit}, {"NY", unit}, {"NZ", unit}}), "END PGM T MM\n", true},
      {"heidenhain/peripheral-milling", kKlartext,
       "BEGIN PGM T MM\nTOOL CALL 1 Z S1000 DR-0.02\nL X0 Y0 Z0 RL F1000 M128\n",
       with({{"TX", unit}, {"TY", unit}, {"TZ", unit}}), "END PGM T MM\n"},
  };
}

// With offsets that leave most paths alone, and with one that ends many of them.
spec::Setup setup_of(const Shape& shape, std::uint64_t seed) {
  constexpr std::array<std::string_view, 4> kRadius{"0.01", "-0.05", "0.1", "1.95"};
  std::string text(shape.setup);
  if (const auto at = text.find("RADIUS"); at != std::string::npos) text.replace(at, 6, kRadius[seed % kRadius.size()]);
  return spec::read_setup_toml(text, "setup");
}

// Whole numbers of 10^-decimals.
struct Column {
  std::string_view word;
  unsigned decimals = 3;
  std::vector<std::int64_t> whole;
};

class Paths {
 public:
  explicit Paths(std::uint64_t seed) : random_(seed) {}

  std::vector<Column> columns(const Shape& shape, std::size_t blocks) {
    std::vector<Column> all;
    for (const auto& [word, walk] : shape.words)
      all.push_back({word, walk == Walk::unit ? 8U : (walk == Walk::vector ? 6U : below(4) + 1), {}});
    for (std::size_t i = 0; i < blocks; ++i) {
      step();
      for (std::size_t c = 0; c < all.size(); ++c) {
        const double power = std::pow(10.0, all[c].decimals);
        all[c].whole.push_back(std::llround(value(shape.words[c].second, all[c].word.back()) * power));
      }
    }
    return all;
  }

 private:
  std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
  double share() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }
  double about(double width) { return (share() - 0.5) * width; }

  // The next end of a block, and how the tool stands there.
  void step() {
    if (left_-- == 0) {
      left_ = below(300);
      style_ = below(8);
    }
    constexpr double kTurn = 2 * std::numbers::pi;
    double length = 0.2 + share();
    switch (style_) {
      case 0:  // corners of any angle
        heading_ += about(kTurn);
        break;
      case 1:  // straight on, with reversals
        heading_ = std::round(heading_) + (below(20) == 0 ? std::numbers::pi : 0);
        break;
      case 2:  // along the axes
        heading_ = std::numbers::pi / 2 * below(4);
        break;
      case 3:  // halts
        length = below(3) == 0 ? 0 : length;
        heading_ += about(0.5);
        break;
      case 4:
        length = 100 * share();
        heading_ += about(1);
        break;
      default:
        heading_ += about(0.2);
    }
    at_[0] += length * std::cos(heading_);
    at_[1] += length * std::sin(heading_);
    at_[2] += about(style_ == 0 ? 1 : 0.1);
    // A long walk comes back.
    for (double& x : at_)
      if (std::abs(x) > 2000) x = 0;
    const double turn = style_ == 0 ? 1 : 0.02;
    lean_ += about(turn);
    around_ += about(turn);
    if (std::abs(lean_) > 0.5) lean_ = 0;
    slope_ += about(turn);
    if (std::abs(slope_) > 0.5) slope_ = lean_ + about(0.3);
    if (style_ == 3 && below(4) == 0) slope_ = lean_;
  }

  double value(Walk walk, char component) {
    switch (walk) {
      case Walk::place:
        return at_[static_cast<std::size_t>(component - 'X')];
      case Walk::angle:
        return (component == 'B' ? lean_ : around_) * 180 / std::numbers::pi;
      default:
        return direction(component);
    }
  }
  // Of the tool, or beside it the normal, which the caller asks for first.
  double direction(char component) {
    const bool normal = component == 'X' || component == 'I' ? (asked_ = !asked_) : asked_;
    const double lean = normal ? slope_ : lean_;
    switch (component) {
      case 'X':
      case 'I':
        return std::sin(lean) * std::cos(around_);
      case 'Y':
      case 'J':
        return std::sin(lean) * std::sin(around_);
      default:
        return std::cos(lean);
    }
  }

  std::mt19937_64 random_;
  std::uint32_t left_ = 0, style_ = 7;
  double heading_ = 0, lean_ = 0.1, around_ = 0, slope_ = 0.2;
  bool asked_ = false;
  std::array<double, 3> at_{};
};

// Everything a run gives, as text.
class Written final : public EventSink {
 public:
  explicit Written(const spec::Axes& of) : axes_(of) {}
  void on(const Event& event) override {
    if (event.kind == spec::EventKind::move) {
      lines.push_back(event.line);
      for (std::size_t i = 0; i < axes_.size(); ++i)
        axes.push_back(event.axes.has(i) ? std::bit_cast<std::uint64_t>(event.axes.value[i]) : kNone);
      return;
    }
    spec::append_event_json(others, event, axes_, [](std::string& to, double x) { to += fmt::format("{:a}", x); });
    others += '\n';
  }
  static constexpr std::uint64_t kNone = 1;  // of the bits of a number
  std::vector<std::uint64_t> lines, axes;
  std::string others;

 private:
  const spec::Axes& axes_;
};

std::string word_text(const Column& column, std::size_t i) {
  const std::int64_t whole = column.whole[i];
  std::string digits = fmt::format("{:0{}}", std::abs(whole), column.decimals + 1);
  digits.insert(digits.size() - column.decimals, ".");
  return fmt::format("{}{}{}", column.word, whole < 0 ? "-" : "", digits);
}

std::string program_text(const Shape& shape, const std::vector<Column>& columns) {
  std::string text(shape.head);
  const bool klartext = shape.section.starts_with("heidenhain");
  for (std::size_t i = 0; i < columns.front().whole.size(); ++i) {
    if (klartext) text += "LN";
    for (const Column& column : columns) {
      text += ' ';
      text += word_text(column, i);
    }
    text += '\n';
  }
  text += shape.tail;
  return text;
}

void run_text(const spec::Setup& setup, const std::string& text, Written& to) {
  const auto all = [&](auto& engine, auto reader, auto block) {
    while (reader.next(block)) engine.block(block);
    engine.end();
  };
  if (setup.control == spec::Control::heidenhain) {
    klartext::Engine engine(setup, to);
    all(engine, spec::klartext::Reader(spec::text_source(text), setup), spec::klartext::Block());
  } else {
    Engine engine(setup, to);
    all(engine, spec::ProgramReader(spec::text_source(text), setup.axes), spec::Block());
  }
}

struct Arrays {
  Written written;
  std::uint64_t as_arrays = 0;
};

Arrays run_arrays(const Shape& shape, const spec::Setup& setup, const std::vector<Column>& columns,
                  Instructions instructions) {
  Arrays all{Written(setup.axes)};
  Batch batch(setup, &all.written, instructions);
  batch.run(shape.head);
  std::vector<std::vector<double>> values;
  for (const Column& column : columns) {
    std::vector<double>& doubles = values.emplace_back();
    for (const std::int64_t whole : column.whole)
      doubles.push_back(static_cast<double>(whole) / std::pow(10.0, column.decimals));
  }
  // In two calls: what is in flight goes on.
  const std::size_t size = columns.front().whole.size();
  for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{0, size / 3}, {size / 3, size}}) {
    std::vector<WordColumn> words;
    for (std::size_t c = 0; c < columns.size(); ++c)
      words.push_back({columns[c].word, std::span(values[c]).subspan(from, to - from), columns[c].decimals});
    batch.lines(words);
  }
  batch.run(shape.tail);
  batch.end();
  const Moves& moves = batch.moves();
  all.written.lines.assign(moves.block().begin(), moves.block().end());
  for (std::size_t m = 0; m < moves.size(); ++m)
    for (std::size_t i = 0; i < moves.axes(); ++i) {
      const double value = moves.axis(i)[m];
      all.written.axes.push_back(std::isnan(value) ? Written::kNone : std::bit_cast<std::uint64_t>(value));
    }
  all.as_arrays = batch.blocks_as_arrays();
  return all;
}

// Where the law is broken on a path; empty: it holds. Counts lines that went as arrays.
std::string broken(const Shape& shape, std::uint64_t seed, std::size_t blocks, std::uint64_t* as_arrays,
                   std::uint64_t* moves) {
  const spec::Setup setup = setup_of(shape, seed);
  const std::vector<Column> columns = Paths(seed).columns(shape, blocks);
  Written one(setup.axes);
  const std::string text = program_text(shape, columns);
  run_text(setup, text, one);
  *moves += one.lines.size();
  for (const Instructions instructions : {Instructions::baseline, best_instructions()}) {
    const Arrays many = run_arrays(shape, setup, columns, instructions);
    *as_arrays += many.as_arrays;
    const std::string where = fmt::format("{} {} seed {}", shape.section, shape.head, seed);
    if (many.written.others != one.others)
      return where + "\nas text\n" + one.others + "as arrays\n" + many.written.others;
    const std::size_t axes = setup.axes.size();
    for (std::size_t m = 0; m < std::max(one.lines.size(), many.written.lines.size()); ++m) {
      if (m >= one.lines.size() || m >= many.written.lines.size())
        return fmt::format("{}: {} moves as text, {} as arrays", where, one.lines.size(), many.written.lines.size());
      if (one.lines[m] != many.written.lines[m])
        return fmt::format("{}: move {} is of block {} as text, {} as arrays", where, m, one.lines[m],
                           many.written.lines[m]);
      for (std::size_t i = 0; i < axes; ++i)
        if (one.axes[m * axes + i] != many.written.axes[m * axes + i])
          return fmt::format("{}: block {} axis {} is {:a} as text, {:a} as arrays", where, one.lines[m],
                             setup.axes.letter(i), std::bit_cast<double>(one.axes[m * axes + i]),
                             std::bit_cast<double>(many.written.axes[m * axes + i]));
    }
  }
  return "";
}

TEST(Batch, GivesWhatTextGives) {
  // Alarms end a path: short ones meet more corners of each kind.
  constexpr std::size_t kBlocks = 400;
  const std::uint64_t kPaths = test::effort(20U, 600U);
  // TOOLCOMP_BATCH_MOVES=1000000: as many paths as it takes to so many moves of each shape.
  const char* const wanted = std::getenv("TOOLCOMP_BATCH_MOVES");  // NOLINT(concurrency-mt-unsafe): one thread
  const std::uint64_t most = wanted == nullptr ? 0 : std::strtoull(wanted, nullptr, 10);
  for (const Shape& shape : shapes()) {
    std::uint64_t as_arrays = 0;
    std::uint64_t moves = 0;
    for (std::uint64_t seed = 1; most == 0 ? seed <= kPaths : moves < most; ++seed) {
      const std::string why = broken(shape, seed, kBlocks, &as_arrays, &moves);
      ASSERT_EQ(why, "");
    }
    fmt::print("{:34}{:>9} moves, {:>9} lines as arrays\n", shape.section, moves, as_arrays / 2);
    if (shape.arrays) {
      EXPECT_GT(as_arrays, moves / 2) << shape.section;
    }
  }
}

#ifdef TOOLCOMP_FAULTS
TEST(Batch, AMistakeInTheArraysBreaksTheLaw) {
  constexpr std::pair<std::string_view, Fault> kFaults[] = {
#define TOOLCOMP_BATCH_FAULT(name, mistake) {#name, Fault::name},
#define TOOLCOMP_ROAD_FAULT(name, mistake)
#include "fuzz/faults/array_faults.inc"
#undef TOOLCOMP_BATCH_FAULT
#undef TOOLCOMP_ROAD_FAULT
  };
  struct Restore {
    ~Restore() { active_fault = Fault::none; }
  } const restore;
  constexpr std::uint64_t kPaths = 100;
  for (const auto& [name, fault] : kFaults) {
    active_fault = fault;
    std::uint64_t found = 0;
    std::uint64_t ignored = 0;
    std::string why;
    for (std::uint64_t seed = 1; seed <= kPaths && found == 0; ++seed)
      for (const Shape& shape : shapes())
        if (shape.arrays && found == 0 && !(why = broken(shape, seed, 400, &ignored, &ignored)).empty()) found = seed;
    fmt::print("{:34}{:>4} {}\n", name, found, why.substr(0, why.find('\n')));
    EXPECT_NE(found, 0) << name;
  }
}
#endif

void expect_refused(const spec::Setup& setup, std::string_view head, const std::vector<WordColumn>& columns,
                    std::string_view why) {
  Batch batch(setup);
  batch.run(head);
  const std::size_t moves = batch.moves().size();
  try {
    batch.lines(columns);
    ADD_FAILURE() << "not refused: " << why;
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string_view(error.what()), why);
  }
  EXPECT_EQ(batch.moves().size(), moves);
}

TEST(Batch, RefusesWhatIsNoLine) {
  const spec::Setup fanuc = spec::read_setup_toml("control = \"fanuc\"\n", "setup");
  const std::vector<double> two{1, 2};
  const std::vector<double> three{1, 2, 3};
  const std::vector<double> bad{1, std::numeric_limits<double>::quiet_NaN()};
  const std::vector<double> far{1, -2e9};
  expect_refused(fanuc, "G90\n", {{"X", two}, {"Y", three}}, "Y: 3 values, and X has 2");
  expect_refused(fanuc, "G90\n", {{"X", two}, {"X", two}}, "X: named twice");
  expect_refused(fanuc, "G90\n", {{"B", two}}, "B: not a word of a line of this control");
  expect_refused(fanuc, "G90\n", {{"NX", two}}, "NX: not a word of a line of this control");
  expect_refused(fanuc, "G90\n", {{"X", two, 10}}, "X: more than 9 decimals");
  expect_refused(fanuc, "G90\n", {{"X", two}, {"Y", bad}}, "Y: value 1 is nan; expected a number up to 1e+09");
  expect_refused(fanuc, "G90\n", {{"X", far}}, "X: value 1 is -2e+09; expected a number up to 1e+09");
  const spec::Setup klartext = spec::read_setup_toml(kKlartext, "setup");
  const std::vector<double> zero{0, 0};
  const std::vector<double> ten{0, 10};
  expect_refused(klartext, "", {{"NX", two}, {"NY", two}, {"NZ", two}},
                 "vectors: X, Y, Z and all three components of the vector are needed");
  expect_refused(klartext, "", {{"X", two}, {"Y", two}, {"Z", two}, {"NX", zero}, {"NY", zero}, {"NZ", zero}},
                 "NX: the vector of value 0 is 0");
  expect_refused(klartext, "", {{"X", two}, {"Y", two}, {"Z", two}, {"NX", zero}, {"NY", zero}, {"NZ", ten}},
                 "NZ: value 1 is 10; expected a number up to 9.999");
  expect_refused(klartext, "", {{"X", two}, {"Y", two}, {"Z", two}, {"TX", zero, 3}, {"TY", zero, 3}, {"TZ", two, 4}},
                 "TX, TY, TZ: these words must have the same number of decimals");
}

// Words are rounded as a post processor prints them; many decimals and long ways go one by one.
TEST(Batch, WordsAreThoseAPostProcessorPrints) {
  const spec::Setup setup = spec::read_setup_toml("control = \"fanuc\"\n", "setup");
  Batch batch(setup);
  batch.run("G90 G01 F100\n");
  const std::vector<double> x{1.23456, -0.00049, 2.0625, 1e9};
  const std::vector<double> y{0.123456789, 1e-9, -7, 12.25};
  batch.lines(std::vector<WordColumn>{{"X", x, 3}, {"Y", y, 9}});
  batch.end();
  ASSERT_EQ(batch.moves().size(), 4);
  EXPECT_EQ(batch.blocks_as_arrays(), 0);
  const std::vector<double> to_x(batch.moves().axis(0).begin(), batch.moves().axis(0).end());
  const std::vector<double> to_y(batch.moves().axis(1).begin(), batch.moves().axis(1).end());
  EXPECT_EQ(to_x, (std::vector<double>{1.235, 0, 2.062, 1e9}));  // 2062.5: to even
  EXPECT_EQ(to_y, y);
  EXPECT_EQ(batch.moves().block()[0], 2);
  EXPECT_EQ(batch.blocks(), 5);
}

}  // namespace
}  // namespace toolcomp::fast
