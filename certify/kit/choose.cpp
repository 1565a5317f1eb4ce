// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/choose.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "certify/sort_by.h"
#include "spec/language/decimal_order.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::kit {
namespace {

// Parts into which blocks under tool center point control are divided where travels are watched.
constexpr std::uint32_t kSamples = 8;

// In so many cases an outcome is looked for that no path shows.
constexpr int kMostTried = 10;

// The numbers that a kit never changes because they describe the machine.
bool describes_machine(spec::ParameterId id) {
  return why_left_alone(id).find("kinematics") != std::string_view::npos || id.number == 19666;
}

bool is_same_machine(const spec::Setup& a, const spec::Setup& b) {
  return a.axes == b.axes && static_cast<const spec::SetupKeys&>(a) == b && a.memory == b.memory &&
         std::ranges::all_of(spec::parameters(), [&](const spec::ParameterInfo& p) {
           return !describes_machine(p.id) ||
                  spec::compare(value_in_force(a, p.id), value_in_force(b, p.id)) == std::strong_ordering::equal;
         });
}

// The start of the vector on this machine's axes; nothing where it is finer than the machine's increments.
std::optional<spec::AxisTable> start_of(const spec::Setup& machine, const spec::Setup& vector) {
  spec::AxisTable start;
  for (const auto& [axis, value] : vector.position) {
    if (!machine.axes.has(axis)) continue;
    if (!is_enterable(value, decimals_of(machine, spec::is_linear_axis(axis)))) return std::nullopt;
    start[axis] = value;
  }
  return start;
}

// Blocks that give the entries with these names ("H1", "D2.wear") the values of the table again.
std::string restoring(const spec::Setup& machine, const spec::Setup& offsets, const std::vector<std::string>& names) {
  std::map<std::pair<bool, std::uint32_t>, spec::OffsetEntry> entries;
  for (const std::string& name : names) {
    const bool d = name.front() == 'D';
    const auto number = static_cast<std::uint32_t>(std::stoul(name.substr(1)));
    const auto& table = d ? offsets.d : offsets.h;
    const auto entry = table.find(number);
    entries[{d, number}] = entry == table.end() ? spec::OffsetEntry{} : entry->second;
  }
  std::string blocks;
  for (const auto& [at, entry] : entries) blocks += enter_offset(machine, at.second, entry, at.first);
  return blocks;
}

}  // namespace

Chooser::Chooser(const Machine& machine, const Outcomes& outcomes, const std::vector<corpus::Vector>& vectors,
                 std::uint32_t first_offset, double tolerance, std::function<void(const std::string&)> progress)
    : machine_(machine),
      outcomes_(outcomes),
      runner_(machine, outcomes),
      table_(machine, first_offset),
      tools_(first_offset),
      progress_(std::move(progress)),
      tolerance_(tolerance) {
  candidates_.reserve(vectors.size());
  for (const corpus::Vector& vector : vectors) {
    candidates_.push_back({});
    candidates_.back().vector = &vector.c;
    prepare(candidates_.back());
    if (candidates_.size() % 100 == 0) say(fmt::format("{} of {} vectors", candidates_.size(), vectors.size()));
  }
  // Those of this very machine first, then short ones.
  sort_by(candidates_, [](const Candidate& c) { return std::pair(!c.same_machine, block_count(c.text)); });
}

void Chooser::prepare(Candidate& candidate) {
  const spec::Case& vector = *candidate.vector;
  candidate.same_machine = is_same_machine(machine_.setup, vector.setup);
  candidate.at_home = outcomes_.reached(judge::run_model(vector).recorder);
  candidate.text.id = vector.id;
  candidate.why =
      machine_.setup.control == spec::Control::fanuc ? prepare_fanuc(candidate) : prepare_klartext(candidate);
  if (!candidate.why.empty()) return;
  const auto start = start_of(machine_.setup, vector.setup);
  if (!start) candidate.why = "its start position is finer than the least increment of the machine";
  if (!candidate.why.empty()) return;
  candidate.text.start = *start;
  candidate.overlay = overlay_for(machine_.setup, vector.setup);
  candidate.here = runner_.run(candidate.text, {}, candidate.offsets);
  candidate.why_here = candidate.here.why;
}

// Blocks and offsets of the candidate; why it has none.
std::string Chooser::prepare_fanuc(Candidate& candidate) const {
  Screened screened = screen(machine_, *candidate.vector);
  if (!screened.why.empty()) return screened.why;
  candidate.text.blocks = std::move(screened.blocks);
  const auto numbers = offsets_for(machine_, *candidate.vector, candidate.text.blocks);
  if (!numbers) return "an offset has too many digits, or is out of range, for the offset memory";
  candidate.numbers = *numbers;
  candidate.offsets.h = numbers->h;
  candidate.offsets.d = numbers->d;
  return {};
}

std::string Chooser::prepare_klartext(Candidate& candidate) const {
  ScreenedKlartext screened = screen_klartext(machine_, *candidate.vector);
  candidate.text.statements = std::move(screened.statements);
  candidate.offsets.tools = candidate.vector->setup.tools;
  return screened.why;
}

void Chooser::leave_out(const WhyNot& why_not) {
  as_it_is_ = true;
  std::vector<Candidate*> asked;
  std::vector<spec::Case> cases;
  for (Candidate& candidate : candidates_) {
    if (!candidate.why.empty() || !candidate.here.why.empty()) continue;
    if (candidate.here.stop) {
      candidate.why = "it ends in an alarm, and this control has alarms of its own";
      continue;
    }
    asked.push_back(&candidate);
    spec::Case& c = cases.emplace_back();
    c.setup = program_setup(machine_, {}, candidate.offsets);
    c.program = write_program(machine_, kFirstProgram + 1, "", ProgramKind::recorded, {candidate.here.text}).text;
  }
  const std::vector<std::string> answers = why_not(cases);
  for (std::size_t i = 0; i < asked.size(); ++i) asked[i]->why = answers.at(i);
}

Choice Chooser::choose(OutcomeSet wanted) {
  wanted_ = std::move(wanted);
  choice_ = {};
  choice_.groups = {{}};
  for (const bool stopped : {false, true}) {
    std::vector<std::pair<std::size_t, CaseRun>> runs;
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (candidates_[i].why.empty() && candidates_[i].here.why.empty()) runs.emplace_back(i, candidates_[i].here);
    cover(0, runs, stopped);
    if (!as_it_is_) cover_with_parameters(stopped);
  }
  choice_.missing = wanted_;
  for (const std::size_t outcome : wanted_) choice_.why[outcome] = why_missing(outcome);
  return choice_;
}

void Chooser::cover(std::size_t group, const std::vector<std::pair<std::size_t, CaseRun>>& runs, bool stopped) {
  std::vector<const std::pair<std::size_t, CaseRun>*> of_kind;
  std::vector<OutcomeSet> sets;
  for (const auto& run : runs)
    if (run.second.why.empty() && run.second.stop.has_value() == stopped) {
      of_kind.push_back(&run);
      sets.push_back(run.second.shows);
    }
  const Overlay overlay = choice_.groups[group];
  OutcomeSet proven;
  greedy_cover(
      std::move(sets), wanted_,
      [&](std::size_t i, const OutcomeSet& claimed) {
        const Candidate& candidate = candidates_[of_kind[i]->first];
        if (stopped) return proven = claimed;
        OutcomeSet hopeful = claimed;
        std::erase_if(hopeful, [this](std::size_t outcome) { return not_told_[outcome] >= kMostTried; });
        proven = runner_.told_apart(of_kind[i]->second.text, overlay, candidate.offsets, hopeful, tolerance_);
        for (const std::size_t outcome : without(hopeful, proven)) ++not_told_[outcome];
        return proven;
      },
      [&](std::size_t i) { return accept(candidates_[of_kind[i]->first], of_kind[i]->second, group, proven); });
}

std::size_t Chooser::group_of(const Overlay& overlay) {
  const auto found = std::ranges::find(choice_.groups, overlay);
  if (found != choice_.groups.end()) return static_cast<std::size_t>(found - choice_.groups.begin());
  choice_.groups.push_back(overlay);
  return choice_.groups.size() - 1;
}

// Leaves out one parameter after another that what the case still brings does not need.
Overlay Chooser::reduced(const Candidate& candidate, const Overlay& overlay, bool stopped) {
  Overlay least = overlay;
  const auto gain = [&](const Overlay& with) {
    const CaseRun run = runner_.run(candidate.text, with, candidate.offsets);
    const bool usable = run.why.empty() && run.stop.has_value() == stopped;
    return usable ? count_common(run.shows, wanted_) : 0;
  };
  const std::size_t all = gain(overlay);
  for (const auto& [id, value] : overlay) {
    Overlay fewer = least;
    fewer.erase(id);
    if (!fewer.empty() && gain(fewer) >= all) least = std::move(fewer);
  }
  return least;
}

void Chooser::cover_with_parameters(bool stopped) {
  std::set<std::size_t> tried;
  std::map<std::size_t, CaseRun> own;  // under the parameters of the vector
  while (!wanted_.empty()) {
    say(fmt::format("{} outcomes left, {} settings of parameters", wanted_.size(), choice_.groups.size()));
    std::size_t best = candidates_.size();
    std::size_t most = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const Candidate& candidate = candidates_[i];
      if (!candidate.why.empty() || candidate.overlay.empty() || tried.contains(i)) continue;
      if (count_common(candidate.at_home, wanted_) == 0) continue;
      if (!own.contains(i)) own[i] = runner_.run(candidate.text, candidate.overlay, candidate.offsets);
      const CaseRun& run = own.at(i);
      if (!run.why.empty() || run.stop.has_value() != stopped) continue;
      const std::size_t gain = count_common(run.shows, wanted_);
      const bool better = gain > most || (gain == most && gain > 0 && best < candidates_.size() &&
                                          candidate.overlay.size() < candidates_[best].overlay.size());
      if (!better) continue;
      most = gain;
      best = i;
    }
    if (best == candidates_.size()) return;
    tried.insert(best);
    const Overlay overlay = reduced(candidates_[best], candidates_[best].overlay, stopped);
    std::vector<std::pair<std::size_t, CaseRun>> runs;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const Candidate& candidate = candidates_[i];
      const bool meant = std::ranges::all_of(overlay, [&](const auto& entry) {
        const auto own_entry = candidate.overlay.find(entry.first);
        return own_entry != candidate.overlay.end() && own_entry->second == entry.second;
      });
      if (!candidate.why.empty() || !meant || count_common(candidate.at_home, wanted_) == 0) continue;
      runs.emplace_back(i, runner_.run(candidate.text, overlay, candidate.offsets));
    }
    const std::size_t before = wanted_.size();
    const std::size_t group = group_of(overlay);
    cover(group, runs, stopped);
    if (wanted_.size() == before && group + 1 == choice_.groups.size()) {
      const auto used = [group](const Chosen& chosen) { return chosen.group == group; };
      if (std::ranges::none_of(choice_.recorded, used) && std::ranges::none_of(choice_.stopped, used))
        choice_.groups.pop_back();
    }
  }
}

// Takes the case if it keeps inside the travels also between the ends of its blocks, and if the model says the same of
// it with the numbers that its offsets have in the kit.
bool Chooser::accept(const Candidate& candidate, const CaseRun& run, std::size_t group, const OutcomeSet& shows) {
  const Overlay& overlay = choice_.groups[group];
  CaseText text = run.text;
  if (run.stop) cut_to(text, blocks_needed(candidate, run, overlay));
  const CaseRun before = runner_.run(text, overlay, candidate.offsets, kSamples);
  if (!before.why.empty() || before.stop.has_value() != run.stop.has_value()) return false;
  OffsetTable table = table_;
  ToolTable tools = tools_;
  if (!table.take(candidate.numbers, text.blocks) || !tools.take(candidate.offsets.tools, text.statements))
    return false;
  spec::Setup offsets;
  offsets.h = table.h();
  offsets.d = table.d();
  offsets.tools = tools.rows();
  CaseRun after = runner_.run(text, overlay, offsets, kSamples);
  if (after.why != before.why || after.events != before.events) return false;
  if (!after.settings.empty()) {
    text.restore = restoring(machine_.setup, offsets, after.settings);
    after = runner_.run(text, overlay, offsets, kSamples);
    if (after.why != before.why || after.events != before.events) return false;
  }
  table_ = std::move(table);
  tools_ = std::move(tools);
  Chosen chosen{candidate.vector, group, candidate.same_machine, std::move(after), shows};
  (chosen.run.stop ? choice_.stopped : choice_.recorded).push_back(std::move(chosen));
  return true;
}

// How many blocks of the case it takes for the alarm: what stands behind would run if the control did not raise it.
std::size_t Chooser::blocks_needed(const Candidate& candidate, const CaseRun& run, const Overlay& overlay) const {
  const std::size_t all = block_count(run.text);
  const CaseRun whole = runner_.run(run.text, overlay, candidate.offsets, kSamples);
  for (std::size_t count = run.stop->block + 1; count < all; ++count) {
    CaseText text = run.text;
    cut_to(text, count);
    const CaseRun shorter = runner_.run(text, overlay, candidate.offsets, kSamples);
    if (shorter.why.empty() && shorter.stop && shorter.shows == whole.shows && shorter.events == whole.events)
      return count;
  }
  return all;
}

std::string Chooser::why_missing(std::size_t outcome) const {
  std::map<std::string, std::size_t> reasons;
  for (const Candidate& candidate : candidates_) {
    if (!std::ranges::binary_search(candidate.at_home, outcome)) continue;
    std::string why = !candidate.why.empty() ? candidate.why : candidate.why_here;
    if (why.empty())
      why = candidate.here.stop ? "it ends in an alarm, which shows another clause"
            : std::ranges::binary_search(candidate.here.shows, outcome)
                ? "the positions are the same, whatever the decision is"
                : "it is not reached on this machine";
    ++reasons[why];
  }
  if (reasons.empty()) return "no golden vector of these sections reaches it";
  std::vector<std::pair<std::string, std::size_t>> list(reasons.begin(), reasons.end());
  sort_by(list, [](const auto& entry) { return SIZE_MAX - entry.second; });  // the commonest first
  std::string text;
  for (const auto& [why, count] : list)
    text += fmt::format("{}{} {}: {}", text.empty() ? "" : "; ", count, count == 1 ? "vector" : "vectors", why);
  return text;
}

}  // namespace toolcomp::certify::kit
