// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/board.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "certify/fuzzing/found.h"

namespace toolcomp::certify::fuzzing {
namespace {

// "3:07", "2:03:07".
std::string clock_text(double seconds) {
  const auto whole = static_cast<std::uint64_t>(seconds);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string found_text(const BoardView& view) {
  std::string text = findings_text(view.findings, view.ways);
  if (view.waiting > 0) text += fmt::format(", {} to examine", view.waiting);
  return text;
}

// Empty: it was not asked for.
std::string voice_text(const VoiceRow& voice) {
  const VoiceCount& c = voice.count;
  std::string text;
  if (c.cases > 0)
    text = fmt::format("{} cases, {:.0f} per s, {} agreed, {} differ, {} undecided, {} refused", c.cases, c.per_second,
                       c.agreed, c.differ, c.undecided, c.refused);
  if (!voice.silent.empty()) text += (text.empty() ? "" : "; ") + voice.silent;
  return text.empty() ? text : "formal specification: " + text;
}

}  // namespace

std::size_t OutcomeWindow::fresh(const std::string& target, std::size_t outcomes, host::Clock::time_point now) {
  std::deque<Count>& counts = counts_[target];
  if (counts.empty() || counts.back().outcomes != outcomes) counts.push_back({now, outcomes});
  // The last count before the window stays: what is new is counted from it.
  while (counts.size() > 1 && now - counts[1].at >= kLength) counts.pop_front();
  return outcomes - std::min(outcomes, counts.front().outcomes);
}

std::vector<std::string> board_lines(const BoardView& view, bool summary) {
  std::vector<std::string> lines;
  const auto row = [&](const auto& target, const auto& workers, const auto& executions, const auto& rate,
                       const auto& accepted, const auto& outcomes, const auto& fresh, const auto& laws,
                       const auto& ties, const auto& hits) {
    std::string line = fmt::format("{:<40}", target);
    if (!summary) line += fmt::format("{:>3}", workers);
    line += fmt::format("{:>13}{:>8}{:>10}{:>10}", executions, rate, accepted, outcomes);
    if (!summary) line += fmt::format("{:>6}", fresh);
    lines.push_back(line + fmt::format("{:>12}{:>8}{:>8}", laws, ties, hits));
  };
  row("target", "at", "executions", "per s", "accepted", "outcomes", "new", "law checks", "ties", "differ");
  std::size_t idle = 0;
  for (const BoardRow& r : view.rows) {
    if (r.executions == 0 && r.workers == 0) {
      ++idle;
      continue;
    }
    const bool reader = r.of == 0;
    row(r.target, r.workers == 0 ? "" : std::to_string(r.workers), r.executions, fmt::format("{:.0f}", r.per_second),
        reader ? "" : fmt::format("{:.1f} %", 100 * r.accepted), reader ? "" : fmt::format("{}/{}", r.outcomes, r.of),
        r.fresh == 0 ? "" : fmt::format("+{}", r.fresh), reader ? "" : std::to_string(r.law_checks),
        reader ? "" : std::to_string(r.ties), r.hits);
  }
  if (idle > 0) lines.push_back(fmt::format("{} targets were not run{}", idle, summary ? "" : " yet"));
  if (std::string voice = voice_text(view.specification); !voice.empty()) lines.push_back(std::move(voice));
  lines.push_back(
      fmt::format("{}  {}{}", clock_text(view.seconds), found_text(view), view.state.empty() ? "" : "  " + view.state));
  return lines;
}

std::string plain_line(const BoardView& view) {
  std::uint64_t executions = 0;
  std::size_t outcomes = 0;
  std::size_t of = 0;
  std::size_t fresh = 0;
  std::string at;
  for (const BoardRow& r : view.rows) {
    executions += r.executions;
    outcomes += r.outcomes;
    of += r.of;
    fresh += r.fresh;
    if (r.workers > 0) at += (at.empty() ? "" : ", ") + r.target;
  }
  const VoiceCount& voice = view.specification.count;
  return fmt::format("{}  {} executions, outcomes {}/{}{}, {}{}; {}", clock_text(view.seconds), executions, outcomes,
                     of, fresh == 0 ? "" : fmt::format(" (+{})", fresh), found_text(view),
                     voice.cases == 0
                         ? ""
                         : fmt::format(", formal specification {} cases, {:.0f} per s", voice.cases, voice.per_second),
                     at.empty() ? view.state : "at " + at);
}

}  // namespace toolcomp::certify::fuzzing
