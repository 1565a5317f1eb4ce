// One corner by both engines: the exact value to 40 decimals, and the double of the fast engine. A line up and one at 45
// degrees behind it, the tool of radius 5 on their left: the offset lines x = -5 and y = x + 100 + 5 * sqrt(2) meet at
// y = 95 + 5 * sqrt(2).
#include <iomanip>
#include <iostream>
#include <vector>

#include "fast/fanuc/engine.h"
#include "model/basis/print.h"
#include "model/fanuc/engine.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/setup_format.h"

namespace {

constexpr const char* kSetup = R"(
control = "fanuc"
axes = ["X", "Y", "Z"]
cutter_compensation = "C"
[offsets.D]
1 = 5
)";

constexpr const char* kProgram = R"(G90 G01 F1000
G41 D1 X0 Y10
Y100
X100 Y200
G40 X200
M30
)";

// Keeps the moves of one engine.
template <class Number>
class Moves final : public toolcomp::spec::EventSink<Number> {
 public:
  void on(const toolcomp::spec::Event<Number>& event) override { events.push_back(event); }
  std::vector<toolcomp::spec::Event<Number>> events;
};

template <class Engine>
void run(Engine& engine, const toolcomp::spec::Setup& setup) {
  toolcomp::spec::ProgramReader reader(toolcomp::spec::text_source(kProgram), setup.axes);
  for (toolcomp::spec::Block block; reader.next(block);) engine.block(block);
  engine.end();
}

// Y of the end of the line up, the block on line 3.
template <class Number>
Number corner(const Moves<Number>& moves) {
  for (const auto& event : moves.events)
    if (event.line == 3) return event.axes[1];
  return {};
}

}  // namespace

int main() {
  const toolcomp::spec::Setup setup = toolcomp::spec::read_setup_toml(kSetup, "setup");
  Moves<toolcomp::exact::Real> exact;
  toolcomp::model::Recorder decisions;
  toolcomp::model::Engine model(setup, decisions, exact);
  run(model, setup);
  Moves<double> doubles;
  toolcomp::fast::Engine fast(setup, doubles);
  run(fast, setup);
  std::string text;
  toolcomp::model::append_number(text, corner(exact), 40);
  std::cout << "exact Y  " << text << "\nfast Y   " << std::setprecision(17) << corner(doubles) << '\n';
  return text == "102.0710678118654752440084436210484903928484" ? 0 : 1;
}
