// SPDX-License-Identifier: Apache-2.0
// Programs with calls give the events of the same program without them, as a script written from the manuals' words
// (tests/support/expand_klartext.py) carries the calls out: model and fast engine, block by block.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "fast/basis/print.h"
#include "judge/oracle/control.h"
#include "judge/oracle/trial.h"
#include "model/basis/print.h"
#include "spec/language/byte_source.h"
#include "spec/language/event_format.h"
#include "spec/language/heidenhain/joined_program.h"
#include "spec/language/heidenhain/program_files.h"
#include "spec/language/setup_format.h"
#include "tests/effort.h"

namespace toolcomp {
namespace {

namespace fs = std::filesystem;

// Random programs that call each other without ever calling themselves: what is called has a greater number.
class Writer {
 public:
  explicit Writer(unsigned seed) : random_(seed) {}

  // A main program and the programs P1, P2 … that it and they call.
  std::vector<std::string> write() {
    programs_ = 1 + below(3);
    std::vector<std::string> files;
    for (std::size_t i = 0; i <= programs_; ++i) files.push_back(program(i));
    return files;
  }

 private:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  bool chance(unsigned percent) { return below(100) < percent; }

  std::string program(std::size_t number) {
    text_.clear();
    here_ = number;
    labels_ = 0;
    const std::string name = number == 0 ? "MAIN" : "P" + std::to_string(number);
    line("BEGIN PGM " + name + " MM");
    subprograms_ = below(4);
    if (number == 0) line("TOOL CALL 1 Z F500");
    body(2, 1);
    if (number == 0) {
      if (chance(50)) line("FUNCTION RESET TCPM");
      line(chance(50) ? "L R0 M30" : "M2");
    }
    // In a program that is called, blocks run into its subprograms.
    for (std::size_t s = 1; s <= subprograms_; ++s) {
      line("LBL " + subprogram(s));
      body(1, s + 1);
      line("LBL 0");
    }
    line("END PGM " + name + " MM");
    return text_;
  }

  static std::string subprogram(std::size_t s) {
    return s % 2 == 0 ? std::to_string(100 + s) : "\"Sub " + std::to_string(s) + "; CALL\"";
  }

  void line(const std::string& words) {
    if (chance(50)) text_ += std::to_string(below(1000)) + ' ';
    text_ += words;
    if (chance(10)) text_ += " ; CALL LBL 1";
    text_ += '\n';
    if (chance(5)) text_ += "* - LBL 1\n";
    if (chance(5)) text_ += "\n";
  }

  // Blocks, repeats `depth` deep, and calls of subprograms from `first` on.
  void body(int depth, std::size_t first) {
    for (std::size_t n = 1 + below(3); n > 0; --n) switch (below(6)) {
        case 0:
          if (depth > 0) {
            const std::string label = chance(50) ? std::to_string(++labels_) : "\"R" + std::to_string(++labels_) + '"';
            line("LBL " + label);
            body(depth - 1, first);
            const std::string count = std::to_string(1 + below(2));
            line("CALL LBL " + label +
                 (chance(30)   ? " ~\n  REP " + count
                  : chance(50) ? " REP" + count
                               : " REP " + count));
          }
          break;
        case 1:
          if (first <= subprograms_)
            line((chance(50) ? "CALL LBL " : "call ~\n lbl ") + subprogram(first + below(subprograms_ - first + 1)));
          break;
        case 2:
          if (here_ < programs_ && chance(60)) {
            const std::string name = std::to_string(here_ + 1 + below(programs_ - here_));
            line(chance(50) ? "CALL PGM P" + name + ".H" : "CALL PGM \"p" + name + '"');
          }
          break;
        default:
          line(move());
      }
  }

  std::string number() { return std::to_string(below(30)) + '.' + std::to_string(below(10)); }

  std::string move() {
    switch (below(6)) {
      case 0:
        return "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS";
      case 1:
        return "LN X" + number() + " Y" + number() + " Z" + number() + " NX0.6 NY0 NZ0.8 R0";
      case 2:
        return "L IX" + number() + " IB" + std::to_string(15 * below(4)) + (chance(50) ? " RL" : " R0");
      case 3:
        return "L IX-" + number() + " IZ" + number() + " F" + std::to_string(100 + below(900));
      default:
        return "L IY" + number();
    }
  }

  std::mt19937 random_;
  std::string text_;
  std::size_t programs_ = 0;
  std::size_t here_ = 0;
  std::size_t subprograms_ = 0;
  std::size_t labels_ = 0;
};

constexpr std::string_view kSetup = R"(control = "heidenhain"
axes = ["X", "Y", "Z", "A", "B", "C"]
[[tool]]
number = 1
R = 5
R2 = 2
DR = -0.1
DR2 = -0.05
)";

// Events as text, the line of each told apart.
struct Told {
  std::vector<std::uint64_t> lines;
  std::vector<std::string> events;
};

template <class Number, class Append>
Told told(std::vector<spec::Event<Number>> events, const spec::Axes& axes, const Append& append) {
  Told result;
  for (spec::Event<Number>& event : events) {
    result.lines.push_back(event.line);
    event.line = 1;
    spec::append_event_json(result.events.emplace_back(), event, axes, append);
  }
  return result;
}

Told of_model(const spec::Case& c) {
  return told(judge::run_model(c).events, c.setup.axes,
              [](std::string& out, const exact::Real& value) { model::append_number(out, value, 15); });
}
Told of_fast(const spec::Case& c) {
  return told(judge::run_fast(c), c.setup.axes,
              [](std::string& out, double value) { fast::append_number(out, value); });
}

// Read from the files as they are called.
Told of_files(const spec::Case& c, const std::string& main, const fs::path& folder) {
  struct Sink final : fast::EventSink {
    std::vector<fast::Event> events;
    void on(const fast::Event& event) override { events.push_back(event); }
  } sink;
  using Control = judge::HeidenhainControl;
  auto reader = Control::reader(spec::text_source(main), c.setup, "p", spec::klartext::programs_beside(folder));
  auto engine = Control::fast(c.setup, sink, 0);
  for (Control::Block block; !engine.stopped() && reader.next(block);) engine.block(block);
  engine.end();
  return told(sink.events, c.setup.axes, [](std::string& out, double value) { fast::append_number(out, value); });
}

void expect_same(const Told& flat, const std::vector<std::uint64_t>& map, const Told& called) {
  EXPECT_EQ(called.events, flat.events);
  ASSERT_EQ(called.lines.size(), flat.lines.size());
  for (std::size_t i = 0; i < flat.lines.size(); ++i) EXPECT_EQ(called.lines[i], map.at(flat.lines[i] - 1)) << i;
}

TEST(KlartextExpansion, CallsGiveTheEventsOfTheFlatProgram) {
  const fs::path folder = fs::temp_directory_path() / ("toolcomp-calls-" + std::to_string(std::random_device{}()));
  std::size_t longer = 0;
  std::size_t events = 0;
  for (unsigned seed = 1; seed <= test::random_cases(60); ++seed) {
    SCOPED_TRACE(seed);
    fs::remove_all(folder);
    fs::create_directories(folder);
    const std::vector<std::string> files = Writer(seed).write();
    for (std::size_t i = 0; i < files.size(); ++i)
      std::ofstream(folder / (i == 0 ? "main.h" : "p" + std::to_string(i) + ".H"), std::ios::binary) << files[i];
    const std::string command = "python3 " TOOLCOMP_SOURCE_DIR "/tests/support/expand_klartext.py " +
                                (folder / "main.h").string() + ' ' + (folder / "flat").string() + ' ' +
                                (folder / "map").string();
    ASSERT_EQ(std::system(command.c_str()), 0) << files[0];  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
    std::vector<std::uint64_t> map;
    std::istringstream lines(spec::read_file((folder / "map").string()));
    for (std::uint64_t number = 0; lines >> number;) map.push_back(number);

    spec::Case flat;
    flat.setup = spec::read_setup_toml(kSetup, "setup.toml");
    spec::Case called = flat;
    flat.program = spec::read_file((folder / "flat").string());
    called.program = spec::klartext::joined_klartext(files[0], spec::klartext::programs_beside(folder));
    const Told model = of_model(flat);
    expect_same(model, map, of_model(called));
    const Told fast = of_fast(flat);
    expect_same(fast, map, of_fast(called));
    expect_same(fast, map, of_files(called, files[0], folder));
    events += model.events.size();
    longer += static_cast<std::size_t>(map.size() >
                                       std::size_t{2} + static_cast<std::size_t>(std::ranges::count(files[0], '\n')));
  }
  fs::remove_all(folder);
  EXPECT_GT(events, test::random_cases(500));
  EXPECT_GT(longer, test::random_cases(60) / 6) << "programs that calls make longer";
}

}  // namespace
}  // namespace toolcomp
