// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/late_fault.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>

#include "fuzz/gen/program_text.h"
#include "judge/oracle/control.h"

namespace toolcomp::fuzz {
namespace {

// How far a run of the model comes.
struct Progress {
  std::size_t events = 0;  // before what ends it
  std::uint64_t line = 0;  // of the block at which it ends; 0: it runs through
};

class Watch final : public spec::EventSink<exact::Real> {
 public:
  void on(const model::Event& event) override {
    if (progress_.line != 0) return;
    const bool ends = spec::ends_run(event.kind) || event.kind == spec::EventKind::undecided;
    if (event.kind != spec::EventKind::undecided) ++progress_.events;
    if (ends) progress_.line = event.line;
  }
  [[nodiscard]] const Progress& progress() const { return progress_; }

 private:
  Progress progress_;
};

// Nothing where there is no run: a setup no control could have, a program that is no text.
std::optional<Progress> run(const spec::Case& c) {
  Watch watch;
  try {
    judge::with_control(c.setup, [&]<class Control>(Control) {
      model::Recorder recorder;
      auto engine = Control::model(c.setup, recorder, watch, c.samples);
      auto reader = Control::reader(spec::text_source(c.program), c.setup, "program");
      const auto block = std::make_unique<typename Control::Block>();
      while (watch.progress().line == 0 && reader.next(*block)) engine.block(*block);
      if (watch.progress().line == 0) engine.end();
    });
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return watch.progress();
}

bool ends_the_program(const std::string& line) {
  constexpr std::string_view words[] = {"M30", "M02", "M2", "END PGM", "m30", "m2", "end pgm"};
  return std::ranges::any_of(words, [&](std::string_view word) { return line.find(word) != std::string::npos; });
}

// The lines of a block: those of Klartext go on behind a tilde.
std::size_t last_line_of_block(const std::vector<std::string>& text, std::size_t first) {
  while (first + 1 < text.size() && text[first].ends_with('~')) ++first;
  return first;
}

}  // namespace

bool put_fault_last(spec::Case& c) {
  std::vector<std::string> text = lines(c.program);
  for (int times = 4;; --times) {
    const std::optional<Progress> progress = run(c);
    if (!progress) return true;
    const bool enough = progress->events >= kFewestEvents;
    if (progress->line == 0 || (enough && 2 * progress->line > text.size()) || times == 0) return enough;
    std::size_t end = text.size();
    while (end > 0 && ends_the_program(text[end - 1])) --end;
    const std::size_t first = progress->line - 1;
    if (first >= end) return enough;
    const std::size_t behind = last_line_of_block(text, first) + 1;
    if (behind >= end) return enough;
    const auto at = [&text](std::size_t i) { return text.begin() + static_cast<std::ptrdiff_t>(i); };
    std::rotate(at(first), at(behind), at(end));
    c.program = joined(text);
  }
}

}  // namespace toolcomp::fuzz
