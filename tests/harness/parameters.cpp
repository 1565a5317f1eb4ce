// SPDX-License-Identifier: Apache-2.0
// The registry of keys and parameters against both engines, on examples and generated programs: its defaults are what
// counts where a setup gives nothing, every key and parameter has an effect, and those that are accepted without effect
// have none.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "corpus/examples.h"
#include "corpus/golden.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/verdict.h"
#include "spec/language/event_format.h"
#include "spec/language/input_error.h"
#include "spec/language/number_text.h"
#include "spec/language/parameter.h"
#include "spec/language/setup_key.h"
#include "tests/effort.h"

namespace toolcomp::fuzz {
namespace {

const std::uint64_t kSeeds = test::effort(4U, 40U);
constexpr const char* kRefused = "refused";

struct Texts {
  std::string model;
  std::string fast;
  friend bool operator==(const Texts&, const Texts&) = default;
};

template <class Events, class Append>
std::string text(const Events& events, const spec::Axes& axes, const Append& append) {
  std::string out;
  for (const auto& event : events) {
    spec::append_event_json(out, event, axes, append);
    out += '\n';
  }
  return out;
}

std::string run_fast_text(const spec::Case& c) {
  try {
    return text(judge::run_fast(c), c.setup.axes, spec::append_shortest);
  } catch (const spec::InputError&) {
    return kRefused;
  }
}

Texts run(const spec::Case& c) {
  Texts texts;
  texts.fast = run_fast_text(c);
  try {
    texts.model = text(judge::run_model(c).events, c.setup.axes,
                       [](std::string& out, const exact::Real& value) { out += '"' + value.decimal(12) + '"'; });
  } catch (const spec::InputError&) {
    texts.model = kRefused;
  }
  return texts;
}

bool has_effect(const spec::ParameterInfo& p) {
  const bool has_choice = p.values.empty() || p.values.find(' ') != std::string_view::npos;
  return has_choice && p.text.find("Accepted, without effect") == std::string_view::npos;
}

// The case with every parameter that its setup does not give, as the registry has it.
spec::Case with_defaults(spec::Case c) {
  for (const spec::ParameterInfo& p : spec::parameters())
    if (const auto value = spec::default_value(p.id, c.setup.units)) c.setup.parameters.try_emplace(p.id, *value);
  return c;
}

template <class Visit>
void for_cases(std::uint64_t seed, const Visit& visit) {
  for (const std::string_view section : sections()) {
    if (!section.starts_with("fanuc/")) continue;
    SeededSource source(seed);
    visit(generate(section, Mode::directed, source, 8));
  }
}

// The examples by hand, which give most keys and parameters a value that matters.
template <class Visit>
void for_examples(const Visit& visit) {
  for (const corpus::ExampleFile& file : corpus::example_files())
    for (const spec::Case& c :
         corpus::read_cases(corpus::default_folder() / file.section / (std::string(file.name) + ".jsonl")))
      visit(c);
}

bool differ_in_both(const Texts& a, const Texts& b) { return a.model != b.model && a.fast != b.fast; }

TEST(Parameters, OfDirectedCasesAreAllowedAndOfAllOthersKnown) {
  for (const std::string_view section : sections())
    for (std::uint64_t seed = 1; seed <= 10 * kSeeds; ++seed) {
      SeededSource source(seed);
      EXPECT_TRUE(spec::has_allowed_parameters(generate(section, Mode::directed, source).setup)) << section << seed;
      SeededSource other(seed);
      for (const auto& [id, value] : generate(section, Mode::unrestricted, other).setup.parameters)
        EXPECT_TRUE(spec::is_known(id)) << section << seed << ' ' << spec::to_string(id);
    }
}

TEST(Parameters, DefaultsAreWhatCountsWhereNothingIsGiven) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
    for_cases(seed, [](const spec::Case& c) {
      const Texts given = run(with_defaults(c));
      const Texts absent = run(c);
      EXPECT_EQ(given.model, absent.model) << c.section << '\n' << c.program;
      EXPECT_EQ(given.fast, absent.fast) << c.section << '\n' << c.program;
    });
}

TEST(Parameters, ThoseWithoutEffectHaveNone) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
    for_cases(seed, [](const spec::Case& c) {
      spec::Case other = c;
      for (const spec::ParameterInfo& p : spec::parameters())
        if (!has_effect(p)) other.setup.parameters[p.id] = p.greatest;
      EXPECT_TRUE(run(c) == run(other)) << c.section << '\n' << c.program;
    });
}

// A default of a parameter that changes nothing could not be wrong: each of the others has a value that changes
// the events of both engines, or that both refuse beside the others (the linear axes of a group).
TEST(Parameters, AllOthersHaveOne) {
  constexpr std::int64_t values[] = {0, 1, 2, 3, 4, 5, 12, 21, 30};
  constexpr std::uint64_t most = 1000;
  std::set<spec::ParameterId> left;
  for (const spec::ParameterInfo& p : spec::parameters())
    if (has_effect(p)) left.insert(p.id);
  for_examples([&](const spec::Case& c) {
    for (const auto& [id, value] : c.setup.parameters) {
      if (!left.contains(id)) continue;
      spec::Case other = c;
      other.setup.parameters.erase(id);
      if (differ_in_both(run(c), run(other))) left.erase(id);
    }
    // M codes that stop reading ahead: what one number of a row does another one does, and so do pairs of them.
    for (const auto& [begin, first, last, width] :
         {std::tuple{3411U, 3411U, 3420U, 1U}, std::tuple{3421U, 3431U, 3432U, 2U}}) {
      if (!c.setup.parameters.contains({first, -1})) continue;
      const Texts texts = run(c);
      spec::Case without = c;
      for (std::uint32_t k = 0; k < width; ++k) without.setup.parameters.erase({first + k, -1});
      if (!differ_in_both(texts, run(without))) continue;
      for (std::uint32_t number = begin; number <= last; number += width) {
        spec::Case other = without;
        for (std::uint32_t k = 0; k < width; ++k)
          other.setup.parameters[{number + k, -1}] = c.setup.parameters.at({first + k, -1});
        if (!(run(other) == texts)) continue;
        for (std::uint32_t k = 0; k < width; ++k) left.erase({number + k, -1});
      }
    }
  });
  for (std::uint64_t seed = 1; seed <= most && !left.empty(); ++seed) {
    for_cases(seed, [&](const spec::Case& c) {
      const Texts texts = run(c);
      std::erase_if(left, [&](const spec::ParameterId& id) {
        spec::Case other = c;
        const auto value = spec::decimal(values[(seed + id.number) % std::size(values)]);
        const bool set =
            id.bit >= 0 &&
            c.setup.bit(id.number, id.bit, !spec::default_value(id, c.setup.units).value_or(spec::Decimal()).is_zero());
        other.setup.parameters[id] = id.bit < 0 ? value : spec::decimal(set ? 0 : 1);
        if (!spec::has_allowed_parameters(other.setup)) return false;
        return differ_in_both(run(other), texts);
      });
    });
  }
  for (const spec::ParameterId& id : left) ADD_FAILURE() << spec::to_string(id) << " changed nothing";
}

// Every value of a key means something else to both engines.
TEST(Keys, AllHaveAnEffect) {
  constexpr std::uint64_t most = 4000;
  std::set<std::pair<std::string, std::size_t>> left;
  for (const spec::KeyInfo& key : spec::keys())
    for (std::size_t value = 0; value < key.values.size(); ++value) left.insert({std::string(key.id), value});
  // A value that is exchanged for the default shows what both do.
  for_examples([&](const spec::Case& c) {
    for (const spec::KeyInfo& key : spec::keys()) {
      const std::size_t value = key.get(c.setup);
      const std::size_t usual = key.get(spec::Setup{});
      if (!key.is_of(c.setup.control) || value == usual || !left.contains({std::string(key.id), value})) continue;
      spec::Case other = c;
      key.set(other.setup, usual);
      if (!differ_in_both(run(c), run(other))) continue;
      left.erase({std::string(key.id), value});
      left.erase({std::string(key.id), usual});
    }
  });
  for (std::uint64_t seed = 1; seed <= most && !left.empty(); ++seed)
    for (const std::string_view section : sections()) {
      SeededSource source(seed);
      const spec::Case c = generate(section, Mode::directed, source, 8);
      const Texts texts = run(c);
      for (const spec::KeyInfo& key : spec::keys())
        std::erase_if(left, [&](const auto& open) {
          if (open.first != key.id || !key.is_of(c.setup.control) || key.get(c.setup) == open.second) return false;
          spec::Case other = c;
          key.set(other.setup, open.second);
          return differ_in_both(run(other), texts);
        });
    }
  for (const auto& [id, value] : left) ADD_FAILURE() << id << ", value " << value;
}

// A fault that every key is seeded with by itself: a fast engine that ignores the key, which directed cases must find,
// as they are generated, in so many executions. A key that nothing else chooses shows its clause too.
TEST(Keys, IgnoredAreFound) {
  const std::uint64_t budget = test::effort(500U, 2000U);
  // One of the events up to the first that differs rests on the key's clauses.
  const auto shows = [](const judge::ModelRun& run, const judge::Difference& difference, const spec::KeyInfo& key) {
    const auto count = static_cast<std::ptrdiff_t>(std::min(difference.event + 1, run.events.size()));
    return std::any_of(run.events.begin(), run.events.begin() + count, [&](const model::Event& event) {
      return std::ranges::any_of(event.clauses, [&](spec::Clause clause) {
        return std::ranges::find(key.clauses, spec::info(clause).id) != key.clauses.end();
      });
    });
  };
  const auto finds = [&](const spec::Case& c, const spec::KeyInfo& key) {
    if (!key.is_of(c.setup.control) || key.is_default(c.setup)) return false;
    spec::Case ignored = c;
    key.set(ignored.setup, key.default_value);
    try {
      const judge::ModelRun run = judge::run_model(c);
      const judge::Verdict verdict = judge::judge(c, run, judge::run_fast(ignored));
      return verdict.outcome == judge::Outcome::differs && (key.percent == 0 || shows(run, *verdict.difference, key));
    } catch (const spec::InputError&) {
      return false;  // no control could have it at its default
    }
  };
  std::set<std::string_view> left;
  for (const spec::KeyInfo& key : spec::keys()) left.insert(key.id);
  for (std::uint64_t seed = 1; seed <= budget && !left.empty(); ++seed)
    for (const std::string_view section : sections()) {
      SeededSource source(seed);
      const spec::Case c = generate(section, Mode::directed, source);
      for (const spec::KeyInfo& key : spec::keys()) {
        if (!left.contains(key.id) || !finds(c, key)) continue;
        left.erase(key.id);
        fmt::print("{:32} found in execution {} of {}\n", key.id, seed, section);
      }
    }
  for (const std::string_view id : left) ADD_FAILURE() << "an engine that ignores " << id << " is not found";
}

}  // namespace
}  // namespace toolcomp::fuzz
