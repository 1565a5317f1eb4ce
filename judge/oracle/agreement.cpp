// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/agreement.h"

#include <memory>
#include <utility>

#include "judge/oracle/reading.h"
#include "judge/oracle/stream_pass.h"
#include "spec/language/alarm.h"

namespace toolcomp::judge {
namespace {

// A controller in the place of the fast engine: its events are there as one list, and it gives as many as the model.
class FromList {
 public:
  FromList(std::span<const spec::TextEvent> events, Reading& reading, const stream::Expected& expected,
           stream::Actual<exact::Rational>& actual)
      : left_(events), reading_(reading), expected_(expected), actual_(actual) {}
  void block(const auto& /*block*/) { give(expected_.events.size()); }
  // One too many is seen.
  void end() { give(expected_.events.size() + 1); }
  [[nodiscard]] static bool stopped() { return true; }

 private:
  void give(std::size_t most) {
    for (; actual_.events.size() < most && !left_.empty(); left_ = left_.subspan(1))
      actual_.on(reading_.event(left_.front()));
  }

  std::span<const spec::TextEvent> left_;
  Reading& reading_;
  const stream::Expected& expected_;
  stream::Actual<exact::Rational>& actual_;
};

// `known`: whether what a block means is known.
template <class Control, class Pass, class Known>
std::optional<Agreed> run(const spec::Case& c, Pass& pass, const Known& known) {
  auto program = Control::reader(spec::text_source(c.program), c.setup, "program");
  const auto block = std::make_unique<typename Control::Block>();
  while (!pass.over() && program.next(*block)) {
    if (!known(*block)) return std::nullopt;
    pass.block(*block);
  }
  Verdict verdict = pass.end();
  if (verdict.outcome != Outcome::agrees && verdict.outcome != Outcome::nothing_judged) return std::nullopt;
  return Agreed{std::move(verdict), pass.clauses()};
}

}  // namespace

std::optional<Agreed> streamed_agreement(const spec::Case& c, const JudgeOptions& judged) {
  const stream::Choices no_choices;
  return with_control(c.setup, [&]<class Control>(Control) {
    stream::Pass<Control> pass(
        Rules(c.setup, c.section, judged), c.setup, c.samples, no_choices,
        [&](const stream::Expected& /*expected*/, auto& actual) { return Control::fast(c.setup, actual, c.samples); });
    return run<Control>(c, pass, [](const auto& /*block*/) { return true; });
  });
}

std::optional<Agreed> streamed_agreement(const spec::Case& c, std::span<const spec::TextEvent> events,
                                         const JudgeOptions& judged,
                                         const std::function<void(const model::Event&)>& on_event) {
  const Rules rules(c.setup, c.section, judged);
  if (rules.rounds() || (c.samples > 0 && !rules.judges("t"))) return std::nullopt;
  Reading reading(c.setup.axes, rules);
  const stream::Choices no_choices;
  auto agreed = with_control(c.setup, [&]<class Control>(Control) {
    stream::Pass<Control, FromList, exact::Rational> pass(
        rules, c.setup, c.samples, no_choices,
        [&](const stream::Expected& expected, auto& actual) { return FromList(events, reading, expected, actual); },
        on_event);
    return run<Control>(c, pass, [](const auto& block) { return spec::beyond(block) == nullptr; });
  });
  // A text that is no number was read as 0.
  if (reading.bad()) return std::nullopt;
  return agreed;
}

}  // namespace toolcomp::judge
