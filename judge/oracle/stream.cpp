// SPDX-License-Identifier: Apache-2.0
// Both engines in step over a program of any length.
#include <fmt/format.h>

#include <memory>

#include "judge/oracle/stream_pass.h"

namespace toolcomp::judge {
namespace {

using exact::Sign;

template <class Control>
Verdict run(stream::Pass<Control>& pass, typename Control::Reader program, void (*on_block)(std::uint64_t)) {
  const auto block = std::make_unique<typename Control::Block>();
  std::uint64_t blocks = 0;
  while (!pass.over() && program.next(*block)) {
    pass.block(*block);
    ++blocks;
    if (on_block != nullptr) on_block(blocks);
  }
  return pass.end();
}

constexpr std::string_view kNearTie = "a difference next to a near tie, in a program that can be read only once";

// Depth first along the chain of forks that each move the difference on; the first pass is the one without choices.
template <class Control>
Verdict judge_passes(const StreamedProgram& program, const spec::Setup& setup, std::uint32_t samples,
                     void (*on_block)(std::uint64_t)) {
  struct Task {
    stream::Choices choices;
    std::size_t beyond;  // events a fork must agree in to be followed
  };
  std::vector<Task> tasks = {{{}, 0}};
  std::optional<Verdict> first;
  std::size_t passes = 0;
  while (!tasks.empty()) {
    const Task task = std::move(tasks.back());
    tasks.pop_back();
    if (passes++ > policy::kMaxPasses) {
      first->outcome = Outcome::undecided;
      first->undecided = fmt::format("more than {} combinations of near ties", policy::kMaxPasses);
      return *first;
    }
    std::optional<stream::Pass<Control>> pass;
    Verdict v;
    try {
      pass.emplace(
          Rules(setup, {}, {}), setup, samples, task.choices,
          [&](const stream::Expected& /*expected*/, auto& actual) { return Control::fast(setup, actual, samples); });
      v = run(*pass, Control::reader(program.open(), setup, program.name, program.called_program),
              first ? nullptr : on_block);
    } catch (const std::exception&) {
      if (!first) throw;
      continue;  // the forced outcome has no finite vectors
    }
    if (first && v.outcome == Outcome::undecided) continue;
    if (v.outcome != Outcome::differs) {
      v.ties = task.choices.size();
      return v;
    }
    if (!first) first = v;
    if (!task.choices.empty() && pass->events() <= task.beyond) continue;
    const auto ties = pass->near_ties();
    if (program.once && !ties.empty()) {
      first->outcome = Outcome::undecided;
      first->undecided = kNearTie;
      return *first;
    }
    for (auto tie = ties.rbegin(); tie != ties.rend(); ++tie)
      for (const Sign outcome : {Sign::negative, Sign::zero, Sign::positive})
        if (outcome != tie->second) {
          tasks.push_back({task.choices, pass->events()});
          tasks.back().choices[tie->first] = outcome;
        }
  }
  return *first;
}

}  // namespace

Verdict judge_stream(const StreamedProgram& program, const spec::Setup& setup, std::uint32_t samples,
                     void (*on_block)(std::uint64_t)) {
  return with_control(setup,
                      [&]<class Control>(Control) { return judge_passes<Control>(program, setup, samples, on_block); });
}

}  // namespace toolcomp::judge
