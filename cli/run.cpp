// SPDX-License-Identifier: Apache-2.0
// toolcomp run: the events of one program, as they come.
#include <fmt/format.h>

#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "certify/path_svg.h"
#include "cli/crossing.h"
#include "cli/manners.h"
#include "cli/notes.h"
#include "cli/output.h"
#include "cli/program.h"
#include "cli/program_page.h"
#include "cli/unjudged.h"
#include "cli/verbs.h"
#include "cli/word_at_fault.h"
#include "fast/arrays/line_moves.h"
#include "fast/arrays/line_road.h"
#include "fast/arrays/line_text.h"
#include "fast/basis/event.h"
#include "fast/basis/print.h"
#include "judge/oracle/control.h"
#include "judge/oracle/number.h"
#include "model/basis/event.h"
#include "model/basis/number.h"
#include "model/basis/print.h"
#include "spec/language/event_format.h"
#include "spec/language/event_map.h"
#include "spec/language/input_error.h"
#include "spec/language/json_text.h"
#include "spec/language/printable.h"
#include "spec/language/text_buffer.h"
#include "spec_engine/engine.h"

namespace toolcomp::cli {
namespace {

// How numbers of the engines are written.
class FastNumber {
 public:
  void operator()(spec::TextCursor& out, double value) const {
    out.write([&](char* to) { return writer_.write(to, value); });
  }

 private:
  mutable fast::NumberWriter writer_;
};
struct ModelNumber {
  int digits = 15;
  void operator()(spec::TextCursor& out, const exact::Real& value) const {
    std::string number;
    model::append_number(number, value, digits);
    out.append(number);
  }
};

double nearest(double value) { return value; }
double nearest(const exact::Real& value) { return judge::approximate(value); }

// Says on standard error what ends the run, and what is not judged, with its place.
template <class Number>
void tell(const Program& program, const RecentBlocks& recent, const spec::Event<Number>& event, Unjudged& unjudged) {
  const RecentBlocks::LineColumn at = recent.place(event.line);
  unjudged.on(event, at.line, at.column);
  if (event.kind != spec::EventKind::alarm) return;
  const auto [more, column] = at_fault(event.alarm, text_of_line(program, at.line), at.column, program.setup());
  const Place place = program.place(at.line, column);
  report_alarm(place.file, place.line, place.column, event.number.view(), event.message + more);
}

// Prints each event as it comes; an alarm also on standard error, with its place in the file.
template <class Number, class AppendNumber>
class Printer final : public spec::EventSink<Number> {
 public:
  // `start`: where the program starts, linear axes.
  Printer(const Program& program, const RunOptions& options, AppendNumber append, const spec::AxisValues<Number>& start)
      : program_(program),
        with_notes_(options.notes),
        format_(options.format),
        append_(std::move(append)),
        gcode_{start},
        units_(program.setup().units),
        notes_(program.setup()),
        unjudged_(program) {
    std::string head;
    if (format_ == Format::csv) spec::append_csv_header(head, program_.setup().axes, program_.setup().control);
    spec::TextCursor(buffer_).append(head);
  }
  ~Printer() override = default;
  Printer(const Printer&) = delete;
  Printer& operator=(const Printer&) = delete;

  void on(const spec::Event<Number>& event) override {
    begin();
    if (with_notes_) {
      notes_.on(event, [](const Number& value) { return nearest(value); });
      if (notes_.wait()) say(notes_.take());
      if (event.kind == spec::EventKind::alarm && event.alarm == spec::AlarmCause::interference) say_crossing(event);
    }
    if (format_ == Format::gcode && program_.samples() > 1)
      print_inside(event);
    else
      print(event);
    if (buffer_.view().size() > kFlushAt) flush();
    if (event.kind != spec::EventKind::undecided && !spec::ends_run(event.kind)) return;
    flush();
    std::cout.flush();
    tell(program_, recent_, event, unjudged_);
  }

  // As on(), of all of them. There is no sample among them.
  void on_lines(fast::LineMoves& moves, fast::LineText& text) {
    if (with_notes_ && !notes_.passes(moves)) {
      for (std::size_t i = 0; i < moves.size; ++i) on(moves.at(i));
      return;
    }
    begin();
    text.append(buffer_, moves, gcode_);
    if (buffer_.view().size() > kFlushAt) flush();
  }

  void reading(const spec::Block& block) {
    recent_.add(block);
    if (!with_notes_) return;
    notes_.read(block);
    if (notes_.wait()) say(notes_.take());
  }
  void reading(const spec::LineColumns& lines, std::size_t count) { recent_.add(lines, count); }
  void reading(const spec::klartext::Block& block) {
    recent_.add(block);
    // The units of the events, too.
    if (block.statement == spec::klartext::Statement::begin_program && !block.alarm) units_ = block.unit;
  }
  void end() {
    begin();
    std::string tail;
    if (format_ == Format::gcode) spec::append_gcode_end(tail);
    spec::TextCursor(buffer_).append(tail);
    flush();
    std::cout.flush();
    unjudged_.end();
    if (!with_notes_) return;
    say(notes_.summary(), false);
    flush();
  }
  void flush() {
    const std::string_view text = buffer_.view();
    std::cout.write(text.data(), static_cast<std::streamsize>(text.size()));
    if (output_lost()) check_output();
    buffer_.clear();
  }
  [[nodiscard]] int status() const { return unjudged_.status(); }

 private:
  void say_crossing(const spec::Event<Number>& alarm) {
    std::optional<double> by;
    if constexpr (std::is_same_v<Number, exact::Real>) by = crossing(alarm);
    if (!by) by = crossing(program_);
    if (by) say({{alarm.line, fmt::format("the paths cross by {:.6g}", *by)}});
  }
  // On standard error, and those of a block as events where these have a form for it.
  void say(const std::vector<Note>& notes, bool of_block = true) {
    for (const Note& each : notes) {
      if (each.line == 0) {
        note(each.text);
        continue;
      }
      if (of_block && format_ == Format::jsonl) {
        std::string quoted;
        spec::append_json_string(quoted, each.text);
        spec::TextCursor(buffer_).append(
            fmt::format("{{\"kind\":\"note\",\"line\":{},\"text\":{}}}\n", each.line, quoted));
      }
      const Place place = program_.place(each.line, 1);
      note(fmt::format("{}:{}: note: {}", spec::printable(spec::display_name(place.file)), place.line, each.text));
    }
  }

  // A plain program says its units first; a Klartext program has said them before its first event.
  void begin() {
    if (format_ != Format::gcode || begun_) return;
    begun_ = true;
    std::string head;
    spec::append_gcode_begin(head, units_);
    spec::TextCursor(buffer_).append(head);
  }

  // A program has no samples: the axes run straight from one to the next, also where the tip runs on an arc.
  void print_inside(const spec::Event<Number>& event) {
    if (event.kind == spec::EventKind::sample) {
      inside_.push_back(event.axes);
      return;
    }
    if (event.kind != spec::EventKind::move || inside_.empty()) {
      print(event);
      return;
    }
    for (const spec::AxisValues<Number>& axes : inside_) print(spec::straight_to(axes, event));
    inside_.clear();
    print(spec::straight_to(event.axes, event));
  }

  [[gnu::flatten]] void print(const spec::Event<Number>& event) {
    const spec::Axes& axes = program_.setup().axes;
    spec::TextCursor out(buffer_);
    switch (format_) {
      case Format::jsonl:
        spec::append_event_json(out, event, axes, append_);
        out += '\n';
        break;
      case Format::csv:
        spec::append_event_csv(out, event, axes, append_, program_.setup().control);
        break;
      case Format::gcode:
        spec::append_event_gcode(out, event, axes, append_, gcode_);
        break;
      case Format::svg:
      case Format::html:
        break;
    }
  }

  static constexpr std::size_t kFlushAt = std::size_t{1} << 16U;
  const Program& program_;
  bool with_notes_;
  Format format_;
  AppendNumber append_;
  spec::TextBuffer buffer_;
  spec::GcodeState<Number> gcode_;
  std::vector<spec::AxisValues<Number>> inside_;  // axes at the samples of the block whose move comes next
  RecentBlocks recent_;
  spec::Units units_;
  Notes notes_;
  Unjudged unjudged_;
  bool begun_ = false;
};

// The printer of plain programs also takes moves of lines together.
class LinePrinter final : public fast::LineSink {
 public:
  LinePrinter(Printer<double, FastNumber>& printer, const spec::Axes& axes) : printer_(printer), text_(axes) {}
  void lines(fast::LineMoves& moves) override { printer_.on_lines(moves, text_); }

 private:
  Printer<double, FastNumber>& printer_;
  fast::LineText text_;
};

// `lines`: as LineRoad.
template <class Control, class Engine, class Sink>
void feed(const Program& program, Engine& engine, Sink& sink, fast::LineSink* lines = nullptr) {
  const judge::StreamedProgram text = program.text();
  auto reader = Control::reader(text.open(), program.setup(), text.name, text.called_program);
  typename Control::Block block;
  const auto reading = [&sink](const auto&... read) { sink.reading(read...); };
  try {
    fast::LineRoad(lines).run(reader, engine, block, reading, reading);
  } catch (const spec::InputError& error) {
    // The events before the bytes that could not be read stand.
    sink.flush();
    throw program.placed(error);
  } catch (...) {
    sink.flush();
    throw;
  }
  engine.end();
  sink.end();
}

template <class Sink>
void feed_model(const Program& program, model::Recorder& recorder, Sink& sink) {
  judge::with_control(program.setup(), [&]<class Control>(Control) {
    auto engine = Control::model(program.setup(), recorder, sink, program.samples());
    feed<Control>(program, engine, sink);
  });
}

template <class Sink>
void feed_fast(const Program& program, Sink& sink, fast::LineSink* lines = nullptr) {
  judge::with_control(program.setup(), [&]<class Control>(Control) {
    auto engine = Control::fast(program.setup(), sink, program.samples());
    feed<Control>(program, engine, sink, lines);
  });
}

// The formal specification, which runs a program as a whole.
template <class Sink>
struct Specification {
  const Program& program;
  Sink& sink;
  [[nodiscard]] static bool stopped() { return false; }
  template <class Block>
  static void block(const Block& /*block*/) {}
  void end() {
    const spec_engine::Run run = spec_engine::run(program.as_case());
    if (!run.not_said.empty()) throw spec::InputError("--engine", 0, 0, run.not_said);
    for (const spec::Event<exact::Real>& event : run.events) sink.on(event);
  }
};

template <class Sink>
void feed_specification(const Program& program, Sink& sink) {
  if (!spec_engine::available())
    throw spec::InputError("--engine", 0, 0, "this toolcomp was built without the formal specification");
  judge::with_control(program.setup(), [&]<class Control>(Control) {
    Specification<Sink> engine{program, sink};
    feed<Control>(program, engine, sink);
  });
}

// Keeps the events for a picture, in double; alarms also on standard error, as above.
template <class Number>
struct Collector final : spec::EventSink<Number> {
  explicit Collector(const Program& drawn) : program(drawn), unjudged(drawn) {}
  const Program& program;
  RecentBlocks recent;
  std::vector<spec::Event<double>> events;
  void on(const spec::Event<Number>& event) override {
    events.push_back(spec::map_numbers<double>(event, [](const Number& value) { return nearest(value); }));
    tell(program, recent, event, unjudged);
  }
  Unjudged unjudged;
  std::string unit;  // of a Klartext program
  void reading(const spec::Block& block) { recent.add(block); }
  void reading(const spec::LineColumns& lines, std::size_t count) { recent.add(lines, count); }
  void reading(const spec::klartext::Block& block) {
    recent.add(block);
    if (block.statement == spec::klartext::Statement::begin_program && !block.alarm)
      unit = block.unit == spec::Units::mm ? "mm" : "inch";
  }
  void flush() {}
  void end() { unjudged.end(); }
};

// The path as a picture.
template <class Number>
int draw(const Program& program, const Collector<Number>& run) {
  certify::PathOptions options = certify::path_options(program.setup());
  if (!run.unit.empty()) options.unit = run.unit;
  std::cout << certify::path_svg(run.events, program.setup().axes, options) << '\n';
  return run.unjudged.status();
}

// The page of `view`; with the fast engine, its path beside the exact one.
int print_page(const RunOptions& options) {
  ViewOptions shown;
  shown.program = options.program;
  shown.setup = options.setup;
  shown.samples = options.samples;
  shown.digits = options.digits;
  const ProgramPage page = program_page(shown, {}, options.engine == EngineName::fast, [] {});
  std::cout << page.html;
  report_alarms(page);
  return page.undecided ? kUndecided : kAgrees;
}

// The start of the setup, linear axes, by way of `number`.
template <class Number, class NumberOf>
spec::AxisValues<Number> start_of(const spec::Setup& setup, NumberOf number) {
  spec::AxisValues<Number> start;
  for (std::size_t axis = 0; axis < setup.axes.size(); ++axis) {
    const char letter = setup.axes.letter(axis);
    if (!spec::is_linear_axis(letter)) continue;
    const auto given = setup.position.find(letter);
    start.set(axis, number(given == setup.position.end() ? spec::Decimal{} : given->second));
  }
  return start;
}

}  // namespace

int run(const RunOptions& options) {
  say_what_is_read(options.program, options.setup);
  if (options.format == Format::html) return print_page(options);
  const Program program(options.program, options.setup, options.samples);
  const bool specified = options.engine == EngineName::specification;
  detail(options.engine == EngineName::fast ? "engine fast, double"
         : specified                        ? "the formal specification, exact"
                                            : "engine model, exact");
  if (options.engine == EngineName::fast) {
    FastNumber append;
    if (options.format == Format::svg) {
      Collector<double> sink(program);
      feed_fast(program, sink);
      return draw(program, sink);
    }
    const auto start =
        start_of<double>(program.setup(), [](const spec::Decimal& d) { return std::stod(spec::to_string(d)); });
    Printer<double, FastNumber> sink(program, options, append, start);
    LinePrinter lines(sink, program.setup().axes);
    feed_fast(program, sink, options.format == Format::gcode ? &lines : nullptr);
    return sink.status();
  }
  model::Recorder recorder;
  const auto feed_exactly = [&](auto& sink) {
    specified ? feed_specification(program, sink) : feed_model(program, recorder, sink);
  };
  if (options.format == Format::svg) {
    Collector<exact::Real> sink(program);
    feed_exactly(sink);
    return draw(program, sink);
  }
  ModelNumber append{options.digits};
  const auto start =
      start_of<exact::Real>(program.setup(), [](const spec::Decimal& d) { return exact::Real(model::plain(d)); });
  Printer<exact::Real, ModelNumber> sink(program, options, append, start);
  feed_exactly(sink);
  return sink.status();
}

}  // namespace toolcomp::cli
