// SPDX-License-Identifier: Apache-2.0
#include "certify/selection.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "fuzz/campaign/features.h"
#include "fuzz/gen/generator.h"
#include "fuzz/gen/mutate.h"
#include "fuzz/gen/program_text.h"
#include "judge/oracle/compare.h"
#include "judge/oracle/control.h"
#include "judge/oracle/verdict.h"
#include "spec/language/input_error.h"
#include "spec/language/parameter.h"

namespace toolcomp::certify {
namespace {

// Of a hundred fresh cases: mostly valid programs, those with a slip, and any words, which mostly end in alarms.
constexpr std::uint64_t kDirected = 68;
constexpr std::uint64_t kSlipped = 20;
// Cases that are to reach the same: what is wrong in one clause shows in some of them only.
constexpr std::uint8_t kWitnesses = 4;
// An alarm is looked for behind so many events less one.
constexpr std::size_t kFewEvents = 4;
// Rounds of half the cases wanted; at least so many candidates each, for small numbers.
constexpr std::size_t kSmallestRound = 25;
constexpr std::size_t kMostRounds = 10;
// From the second round on, one of so many candidates is fresh: the others change what was chosen.
constexpr std::uint64_t kFreshOf = 3;
constexpr std::uint64_t kSpliceOneOf = 8;

// Mixes two numbers so that neighbours have nothing in common.
std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  fuzz::SeededSource source(a);
  return source.below(UINT64_MAX) ^ fuzz::SeededSource(b ^ 0x5bd1e995).below(UINT64_MAX);
}

std::uint64_t number_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

// Could a control have this setup, with the tables the program asks for?
bool possible(const spec::Case& c) {
  struct Nowhere final : spec::EventSink<exact::Real> {
    void on(const model::Event& /*event*/) override {}
  } nowhere;
  model::Recorder recorder;
  try {
    judge::with_control(c.setup, [&]<class Control>(Control) {
      const auto engine = Control::model(c.setup, recorder, nowhere, 0);
      typename Control::Reader reader = Control::reader(spec::text_source(c.program), c.setup, "program");
      const auto block = std::make_unique<typename Control::Block>();
      while (reader.next(*block)) {
      }
    });
    return true;
  } catch (const spec::InputError&) {
    return false;
  }
}

// A case that the model cannot decide certifies nothing; what the specification leaves open is another thing.
bool is_decided(const judge::ModelRun& run) {
  return run.events.empty() || run.events.back().kind != spec::EventKind::undecided ||
         judge::left_open(run.events.back());
}
bool is_decided(const spec::Case& c) {
  try {
    return is_decided(judge::run_model(c));
  } catch (const spec::InputError&) {
    return true;  // of the setup: told where the case is asked
  }
}

// An alarm beside a word of its block: an alarm that has several reasons must come for each.
using AlarmAndWord = std::pair<spec::Clause, std::string>;

// G1 and G01 are one word, X1 and X2 too; of Klartext the letters of a word count.
std::string kind_of(const std::string& word) {
  const std::size_t letters = std::min(word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), word.size());
  std::string kind = word.substr(0, letters);
  const std::size_t digit = std::min(word.find_first_not_of('0', letters), word.size());
  if (kind == "G" || kind == "M") kind += word.substr(digit);
  return kind;
}

std::set<AlarmAndWord> alarms_and_words(const spec::Case& c, const std::vector<model::Event>& events) {
  std::set<AlarmAndWord> found;
  // Cases that end at once say little else.
  if (events.size() < kFewEvents) return found;
  const std::vector<std::string> lines = fuzz::lines(c.program);
  const bool klartext = c.setup.control == spec::Control::heidenhain;
  for (const model::Event& event : events) {
    if (event.kind != spec::EventKind::alarm || event.clauses.empty()) continue;
    if (event.line == 0 || event.line > lines.size()) continue;
    const std::string& line = lines[event.line - 1];
    for (const std::string& word : klartext ? fuzz::words_between_blanks(line) : fuzz::words(line))
      found.emplace(event.clauses.back(), kind_of(word));
  }
  return found;
}

struct Candidate {
  spec::Case c;
  std::vector<std::uint32_t> features;
  std::set<AlarmAndWord> alarms;
};

class Selecting {
 public:
  Selecting(std::string_view section, std::uint64_t seed, std::size_t count)
      : section_(section), seed_(seed), count_(count), reached_(fuzz::kFeatures, 0) {}

  Selection run(const std::function<void(std::uint64_t)>& progress) {
    const std::size_t round = std::max(kSmallestRound, count_ / 2);
    bool anything_new = true;
    for (std::size_t rounds = 0; rounds < kMostRounds && anything_new && !full(); ++rounds) {
      anything_new = false;
      for (std::size_t i = 0; i < round && !full(); ++i) {
        anything_new = look_at(candidate(rounds > 0)) || anything_new;
        if (progress) progress(selection_.looked_at);
      }
    }
    for (auto candidate = put_by_.begin(); candidate != put_by_.end() && !full(); ++candidate)
      if (reaches_what_few_do(*candidate, kWitnesses)) choose(std::move(*candidate));
    selection_.reaching = selection_.cases.size();
    while (!full())
      if (spec::Case c = candidate(false); is_decided(c)) choose(std::move(c));
    return std::move(selection_);
  }

 private:
  [[nodiscard]] bool full() const { return selection_.cases.size() >= count_; }

  // A case that some control could be given; choices of one candidate are independent of those of another.
  spec::Case candidate(bool may_change) {
    fuzz::SeededSource source(mix(mix(seed_, number_of(section_)), made_++));
    const bool change = may_change && !selection_.cases.empty() && source.below(kFreshOf) != 0;
    spec::Case c = change ? changed(source) : fresh(source);
    while (!possible(c)) c = fresh(source);
    return c;
  }

  spec::Case fresh(fuzz::ChoiceSource& source) {
    const std::uint64_t kind = source.below(100);
    if (kind < kDirected) return fuzz::generate(section_, fuzz::Mode::directed, source);
    if (kind < kDirected + kSlipped) return fuzz::generate_with_slip(section_, source);
    return fuzz::generate(section_, fuzz::Mode::unrestricted, source);
  }

  spec::Case changed(fuzz::ChoiceSource& source) {
    const auto any = [&]() -> const spec::Case& { return selection_.cases[source.below(selection_.cases.size())]; };
    spec::Case c = any();
    if (source.below(kSpliceOneOf) == 0) c = fuzz::splice(c, any(), source);
    fuzz::mutate(c, source.below(4) == 0 ? fuzz::Mode::unrestricted : fuzz::Mode::directed, source);
    return c;
  }

  // Whether the case reaches something for the first time; it is chosen then, and else put by.
  bool look_at(spec::Case c) {
    ++selection_.looked_at;
    if (!spec::has_allowed_parameters(c.setup)) return false;  // no reader would take it
    Candidate candidate{std::move(c), {}, {}};
    try {
      const judge::ModelRun run = judge::run_model(candidate.c);
      if (!is_decided(run)) return false;
      candidate.features = fuzz::features(run.recorder);
      candidate.alarms = alarms_and_words(candidate.c, run.events);
    } catch (const spec::InputError&) {
      return false;
    }
    const bool new_alarm = !std::ranges::includes(alarms_, candidate.alarms);
    if (new_alarm || reaches_what_few_do(candidate, 1)) {
      choose(std::move(candidate));
      return true;
    }
    put_by_.push_back(std::move(candidate));
    return false;
  }

  [[nodiscard]] bool reaches_what_few_do(const Candidate& candidate, std::uint8_t few) const {
    return std::ranges::any_of(candidate.features, [&](std::uint32_t feature) { return reached_[feature] < few; });
  }

  void choose(Candidate candidate) {
    for (const std::uint32_t feature : candidate.features) {
      selection_.features += reached_[feature] == 0 ? 1 : 0;
      if (reached_[feature] < kWitnesses) ++reached_[feature];
    }
    alarms_.merge(candidate.alarms);
    choose(std::move(candidate.c));
  }

  void choose(spec::Case c) {
    const std::string index = std::to_string(selection_.cases.size());
    c.id = generated_id(section_, seed_, selection_.cases.size());
    c.source = {"toolcomp certify", TOOLCOMP_VERSION, std::to_string(seed_) + ":" + index};
    selection_.cases.push_back(std::move(c));
  }

  std::string_view section_;
  std::uint64_t seed_;
  std::size_t count_;
  std::uint64_t made_ = 0;
  std::vector<std::uint8_t> reached_;  // by feature: in how many of the cases chosen, up to kWitnesses
  std::set<AlarmAndWord> alarms_;
  std::vector<Candidate> put_by_;
  Selection selection_;
};

}  // namespace

std::string generated_id(std::string_view section, std::uint64_t seed, std::size_t index) {
  std::string id(section);
  std::ranges::replace(id, '/', '.');
  return id + ".seed-" + std::to_string(seed) + "." + std::to_string(index);
}

Selection select_cases(std::string_view section, std::uint64_t seed, std::size_t count,
                       const std::function<void(std::uint64_t)>& progress) {
  return Selecting(section, seed, count).run(progress);
}

}  // namespace toolcomp::certify
