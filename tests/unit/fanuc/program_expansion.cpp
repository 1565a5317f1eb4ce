// SPDX-License-Identifier: Apache-2.0
// FANUC programs with M98 and M99 give the events of the same program without them, as a script written from the words
// of the clauses (tests/support/expand_fanuc.py) carries the calls out: model and fast engine, block by block.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "fast/basis/print.h"
#include "judge/oracle/control.h"
#include "judge/oracle/trial.h"
#include "model/basis/print.h"
#include "spec/language/byte_source.h"
#include "spec/language/event_format.h"
#include "spec/language/fanuc/program_files.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/setup_format.h"
#include "tests/effort.h"
#include "tests/support/setup_with_feed.h"

namespace toolcomp {
namespace {

namespace fs = std::filesystem;

// Random programs that call each other without ever calling themselves: what is called comes later in `programs_`.
// Every program has a block N9000 behind its last call, so that M99 P9000 finds one.
class Writer {
 public:
  explicit Writer(unsigned seed) : random_(seed) {}

  // The text of files by their names; that of the main program is "main.nc".
  std::map<std::string, std::string> write() {
    const std::size_t count = 1 + below(5);
    programs_.push_back(Program{chance(50) ? "O0001 (MAIN)" : chance(50) ? "<MAIN>" : "", "", "", ""});
    for (std::size_t i = 1; i <= count; ++i) programs_.push_back(called(i));
    std::map<std::string, std::string> files;
    std::string main = text(0);
    for (std::size_t i = 1; i < programs_.size(); ++i) {
      const std::string body = text(i);
      if (programs_[i].file.empty())
        main += body;
      else
        files[programs_[i].file] = dressed(body);
    }
    files["main.nc"] = dressed(main);
    return files;
  }

 private:
  struct Program {
    std::string head;
    std::string file;  // empty: in the text of the main program
    std::string call;  // M98 of it, once
    std::string number;
    bool short_number = false;  // upper digits of P may say how often
  };

  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  bool chance(unsigned percent) { return below(100) < percent; }

  Program called(std::size_t i) {
    Program program;
    if (chance(20)) {
      const std::string name = "Sub-" + std::to_string(i);
      program.head = '<' + name + ">(O7)";
      program.call = "M98<" + name + '>';
      if (chance(50)) program.file = (chance(50) ? "SUB-" : "sub-") + std::to_string(i) + (chance(50) ? ".nc" : "");
      return program;
    }
    // Numbers of two to eight digits.
    program.short_number = chance(80);
    program.number = std::to_string((program.short_number ? 10 : 51000) + i * (chance(50) ? 1 : 100));
    const std::string zeros(program.number.size() < 4 ? 4 - program.number.size() : 0, '0');
    program.head = (chance(50)   ? "O" + zeros
                    : chance(50) ? "o"
                                 : "O ") +
                   program.number + (chance(50) ? " (SUB M98 P1)" : "");
    if (chance(50))
      program.file = (chance(60)   ? "O"
                      : chance(50) ? "o"
                                   : "") +
                     (chance(50) ? zeros : "") + program.number +
                     (chance(40)   ? ".nc"
                      : chance(50) ? ".NC"
                                   : "");
    return program;
  }

  std::string call(const Program& program) {
    const std::string times = std::to_string(1 + below(3));
    if (program.number.empty()) return program.call + (chance(50) ? " L" + times : "");
    if (!program.short_number) return "M98 P" + program.number + " L" + times;
    if (chance(40)) return (chance(50) ? "M98 P" : "m98p ") + program.number + (chance(50) ? " L" + times : "");
    const std::string digits = std::string(4 - program.number.size(), '0') + program.number;
    return (chance(20) ? "M98 P00" : "M98 P") + times + digits;
  }

  // As files come.
  std::string dressed(const std::string& body) {
    std::string text = chance(50) ? "%\n" + body + "%\n" : body;
    if (chance(20)) text.pop_back();
    if (chance(20)) {
      std::string returns;
      for (const char c : text) returns += c == '\n' ? "\r\n" : std::string(1, c);
      text = returns;
    }
    return chance(10) ? "\xEF\xBB\xBF" + text : text;
  }

  std::string text(std::size_t number) {
    text_.clear();
    if (!programs_[number].head.empty()) text_ += programs_[number].head + '\n';
    if (number == 0) line("G21 G17 G40 G49 G80 G90 G54");
    calls_ = 0;
    for (std::size_t n = 3 + below(6); n > 0; --n) block(number);
    if (number == 0 && calls_ == 0) line(call(programs_[1]));
    line(chance(50) ? "N9000" : "N09000" + move());
    if (number == 0) {
      if (chance(50)) line("G40 G00 X0 Y0");
      // A program that follows ends the main one too.
      if (chance(90)) line(chance(60) ? "M30" : chance(50) ? "M02" : "M99");
    } else if (chance(90)) {
      const bool last = chance(5);
      line(last ? "M30" : (chance(30) ? move() + " " : "") + "M99" + (chance(30) ? " P9000" : ""));
    }
    return text_;
  }

  void block(std::size_t number) {
    if (number + 1 < programs_.size() && chance(30)) {
      const Program& program = programs_[number + 1 + below(programs_.size() - number - 1)];
      ++calls_;
      line((chance(20) ? move() + " " : "") + call(program) + (chance(10) ? " X3" : ""));
    } else {
      line(move());
    }
  }

  void line(const std::string& words) {
    if (chance(10)) text_ += '/';
    if (chance(30) && !words.starts_with('N')) text_ += 'N' + std::to_string(chance(20) ? 9000 : 10 * below(100));
    text_ += words;
    if (chance(10)) text_ += " (M98 P10; O5)";
    if (chance(10)) text_ += ';';
    text_ += '\n';
    if (chance(5)) text_ += "(O10)\n";
    if (chance(5)) text_ += "\n";
  }

  std::string number() { return std::to_string(5 + below(30)) + '.' + std::to_string(below(10)); }

  std::string move() {
    switch (below(9)) {
      case 0:
        return chance(50) ? "G91" : "G90";
      case 1:
        return std::string(chance(50) ? "G41" : "G42") + " D1 G01 X" + number() + " F500";
      case 2:
        return "G40 G01 X" + number() + " Y" + number();
      case 3:
        return chance(50) ? "G43 H1 Z" + number() : "M08";
      case 4:
        return "G01 X-" + number();
      case 5:
        return "G00 Y" + number() + " Z-" + number();
      default:
        return "G01 X" + number() + " Y" + (chance(50) ? "-" : "") + number();
    }
  }

  std::mt19937 random_;
  std::string text_;
  std::vector<Program> programs_;
  std::size_t calls_ = 0;
};

constexpr std::string_view kSetup = R"(control = "fanuc"
axes = ["X", "Y", "Z"]
[offsets.H]
1 = 100
[offsets.D]
1 = 1
)";

// Events as text, the line of each told apart. The clauses differ: where M98 stood the flat program has another M.
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
    event.clauses = {};
    spec::append_event_json(result.events.emplace_back(), event, axes, append);
  }
  return result;
}

Told of_model(const spec::Case& c) {
  return told(judge::run_model(c).events, c.setup.axes,
              [](std::string& out, const exact::Real& value) { model::append_number(out, value, 15); });
}
Told of_fast(const std::vector<fast::Event>& events, const spec::Axes& axes) {
  return told(events, axes, [](std::string& out, double value) { fast::append_number(out, value); });
}

// Read from the files as they are called.
Told of_files(const spec::Case& c, const std::string& main, const fs::path& folder) {
  struct Sink final : fast::EventSink {
    std::vector<fast::Event> events;
    void on(const fast::Event& event) override { events.push_back(event); }
  } sink;
  using Control = judge::FanucControl;
  auto reader = Control::reader(spec::text_source(main), c.setup, "p", spec::programs_beside(folder));
  auto engine = Control::fast(c.setup, sink, 0);
  for (Control::Block block; !engine.stopped() && reader.next(block);) engine.block(block);
  engine.end();
  return of_fast(sink.events, c.setup.axes);
}

void expect_same(const Told& flat, const std::vector<std::uint64_t>& map, const Told& called) {
  EXPECT_EQ(called.events, flat.events);
  ASSERT_EQ(called.lines.size(), flat.lines.size());
  for (std::size_t i = 0; i < flat.lines.size(); ++i) EXPECT_EQ(called.lines[i], map.at(flat.lines[i] - 1)) << i;
}

TEST(ProgramExpansion, CallsGiveTheEventsOfTheFlatProgram) {
  const fs::path folder = fs::temp_directory_path() / ("toolcomp-calls-" + std::to_string(std::random_device{}()));
  std::size_t events = 0;
  std::size_t in_files = 0;
  std::size_t ended = 0;
  const auto kPrograms = static_cast<unsigned>(test::random_cases(60));
  for (unsigned seed = 1; seed <= kPrograms; ++seed) {
    SCOPED_TRACE(seed);
    fs::remove_all(folder);
    fs::create_directories(folder);
    const std::map<std::string, std::string> files = Writer(seed).write();
    for (const auto& [name, text] : files) std::ofstream(folder / name, std::ios::binary) << text;
    // What it writes is no file beside.
    const std::string out = folder.string() + "-flat";
    std::string command = "python3 " TOOLCOMP_SOURCE_DIR "/tests/support/expand_fanuc.py ";
    command.append((folder / "main.nc").string()).append(" ").append(out).append(" ").append(out).append(".map");
    ASSERT_EQ(std::system(command.c_str()), 0) << files.at("main.nc");  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
    std::vector<std::uint64_t> map;
    std::istringstream lines(spec::read_file(out + ".map"));
    for (std::uint64_t number = 0; lines >> number;) map.push_back(number);

    spec::Case flat;
    flat.setup = test::setup_with_feed(kSetup);
    spec::Case called = flat;
    flat.program = spec::read_file(out);
    called.program =
        spec::joined_program(files.at("main.nc"), flat.setup.axes, {.called_program = spec::programs_beside(folder)});
    const Told model = of_model(flat);
    expect_same(model, map, of_model(called));
    const Told fast = of_fast(judge::run_fast(flat), flat.setup.axes);
    expect_same(fast, map, of_fast(judge::run_fast(called), flat.setup.axes));
    expect_same(fast, map, of_files(called, files.at("main.nc"), folder));
    if (HasFailure()) {
      for (const auto& [name, text] : files) ADD_FAILURE() << "== " << name << '\n' << text;
      ADD_FAILURE() << "== flat\n" << flat.program;
      break;
    }
    const auto main_lines = static_cast<std::uint64_t>(std::ranges::count(files.at("main.nc"), '\n'));
    in_files += std::ranges::any_of(map, [&](std::uint64_t line) { return line > main_lines + 1; }) ? 1 : 0;
    ended += model.events.empty() || model.events.back().find("\"move\"") == std::string::npos ? 1 : 0;
    events += model.events.size();
    fs::remove(out);
    fs::remove(out + ".map");
  }
  fs::remove_all(folder);
  EXPECT_GT(events, test::random_cases(1000));
  EXPECT_GT(in_files, kPrograms / 3) << "programs that run a file";
  EXPECT_LT(ended, kPrograms / 2) << "programs that end by an alarm";
}

}  // namespace
}  // namespace toolcomp
