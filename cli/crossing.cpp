// SPDX-License-Identifier: Apache-2.0
#include "cli/crossing.h"

#include "judge/oracle/control.h"
#include "judge/oracle/number.h"
#include "model/basis/recorder.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

struct Last final : model::EventSink {
  std::optional<double> crossing;
  void on(const model::Event& event) override { crossing = cli::crossing(event); }
};

}  // namespace

std::optional<double> crossing(const model::Event& alarm) {
  if (alarm.kind != spec::EventKind::alarm || alarm.alarm != spec::AlarmCause::interference ||
      alarm.value.sign() != exact::Sign::positive)
    return std::nullopt;
  return judge::approximate(alarm.value);
}

std::optional<double> crossing(const Program& program) {
  const judge::StreamedProgram text = program.text();
  if (text.once) return std::nullopt;
  Last last;
  judge::with_control(program.setup(), [&]<class Control>(Control) {
    model::Recorder recorder;
    auto model = Control::model(program.setup(), recorder, last, 0);
    auto reader = Control::reader(text.open(), program.setup(), text.name, text.called_program);
    typename Control::Block block;
    try {
      while (!model.stopped() && reader.next(block)) model.block(block);
      model.end();
    } catch (const spec::InputError&) {  // NOLINT(bugprone-empty-catch)
      // The run itself has said it.
    }
  });
  return last.crossing;
}

}  // namespace toolcomp::cli
