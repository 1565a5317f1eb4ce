#include "corpus/select.h"

#include <algorithm>
#include <set>
#include <string>

#include "corpus/generate.h"
#include "corpus/sha256.h"
#include "corpus/vector.h"
#include "fuzz/campaign/features.h"
#include "fuzz/gen/generator.h"
#include "spec/language/parameter.h"
#include "spec/language/setup_key.h"

namespace toolcomp::corpus {
namespace {

// One unrestricted case for every so many directed ones.
constexpr std::size_t kUnrestrictedEvery = 8;

struct Candidate {
  spec::Case c;
  std::vector<std::uint32_t> features;
  bool differs = false;  // the engines do
};

Candidate candidate(std::string_view section, std::uint64_t seed, std::size_t index) {
  const bool unrestricted = index % kUnrestrictedEvery == kUnrestrictedEvery - 1;
  const std::uint64_t own = seed_of(section, seed, index);
  fuzz::SeededSource source(own);
  Candidate made;
  made.c = fuzz::generate(section, unrestricted ? fuzz::Mode::unrestricted : fuzz::Mode::directed, source);
  made.c.section = section;
  // What is chosen last stays at its default here, so that no vector changes for a key that comes; examples have it.
  for (const spec::KeyInfo& key : spec::keys())
    if (key.percent != 0) key.set(made.c.setup, key.default_value);
  made.c.source = {std::string(kGenerator.substr(0, kGenerator.rfind(' '))),
                   std::string(kGenerator.substr(kGenerator.rfind(' ') + 1)), std::to_string(own)};
  if (unrestricted) made.c.flags = {"generated-unrestricted"};
  return made;
}

}  // namespace

std::uint64_t seed_of(std::string_view section, std::uint64_t seed, std::size_t index) {
  const std::string digest = sha256(std::string(section) + ' ' + std::to_string(seed) + ' ' + std::to_string(index));
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 16; ++i)
    value = value << 4U | static_cast<std::uint64_t>(digest[i] <= '9' ? digest[i] - '0' : digest[i] - 'a' + 10);
  return value;
}

std::vector<spec::Case> select(std::string_view section, const SelectOptions& options) {
  std::set<std::uint32_t> reached;
  std::set<std::string> ids;
  std::vector<spec::Case> chosen;
  std::vector<spec::Case> spare;
  for (std::size_t i = 0; i < options.candidates; ++i) {
    Candidate made = candidate(section, options.seed, i);
    if (!spec::has_allowed_parameters(made.c.setup)) continue;  // no reader would take it
    const fuzz::Trial trial = fuzz::try_case(made.c);
    if (trial.found()) {
      chosen.push_back(std::move(made.c));
      continue;
    }
    const std::vector<std::uint32_t> features = fuzz::features(trial.run.recorder);
    const bool adds = std::ranges::any_of(features, [&](std::uint32_t f) { return !reached.contains(f); });
    if (!adds && spare.size() >= options.vectors) continue;
    if (!complete(made.c).empty() || !ids.insert(made.c.id).second) continue;
    reached.insert(features.begin(), features.end());
    (adds ? chosen : spare).push_back(std::move(made.c));
  }
  for (std::size_t i = 0; i < spare.size() && chosen.size() < options.vectors; ++i)
    chosen.push_back(std::move(spare[i]));
  return chosen;
}

}  // namespace toolcomp::corpus
