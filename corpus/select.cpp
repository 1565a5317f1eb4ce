// SPDX-License-Identifier: Apache-2.0
#include "corpus/select.h"

#include <algorithm>
#include <set>
#include <string>

#include "corpus/generate.h"
#include "corpus/vector.h"
#include "fuzz/campaign/features.h"
#include "fuzz/gen/generator.h"
#include "host/sha256.h"
#include "spec/language/parameter.h"
#include "spec/language/setup_key.h"

namespace toolcomp::corpus {
namespace {

// One unrestricted case for every so many directed ones.
constexpr std::size_t kUnrestrictedEvery = 8;

spec::Case candidate(std::string_view section, std::uint64_t seed, std::size_t index) {
  const bool unrestricted = index % kUnrestrictedEvery == kUnrestrictedEvery - 1;
  const std::uint64_t own = seed_of(section, seed, index);
  fuzz::SeededSource source(own);
  spec::Case c = fuzz::generate(section, unrestricted ? fuzz::Mode::unrestricted : fuzz::Mode::directed, source);
  c.section = section;
  // What is chosen last stays at its default here, so that no vector changes for a key that comes; examples have it.
  for (const spec::KeyInfo& key : spec::keys())
    if (key.percent != 0) key.set(c.setup, key.default_value);
  c.source = {std::string(kGenerator.substr(0, kGenerator.rfind(' '))),
              std::string(kGenerator.substr(kGenerator.rfind(' ') + 1)), std::to_string(own)};
  if (unrestricted) c.flags = {"generated-unrestricted"};
  return c;
}

// What has been chosen so far, and what the candidates looked at reach. A candidate that reaches nothing new here
// reaches nothing new behind more candidates either: that is why shares can be looked at by themselves.
class Choice {
 public:
  Choice(std::string_view section, const SelectOptions& options) : section_(section), options_(options) {}

  // Runs a candidate, as far as it may be chosen.
  [[nodiscard]] std::optional<Contender> look(std::size_t index) const {
    spec::Case c = candidate(section_, options_.seed, index);
    if (!spec::has_allowed_parameters(c.setup)) return std::nullopt;  // no reader would take it
    const judge::Trial trial = judge::try_case(c);
    if (trial.found()) return Contender{index, {}, std::nullopt};
    std::vector<std::uint32_t> features = fuzz::features(trial.run.recorder);
    if (!adds(features) && !wants_spare()) return std::nullopt;
    if (!complete(c).empty()) return std::nullopt;
    return Contender{index, std::move(features), std::move(c)};
  }

  // Whether it was kept.
  bool take(Contender contender) {
    if (!contender.c) {
      chosen_.push_back(candidate(section_, options_.seed, contender.index));
      return true;
    }
    const bool adds_something = adds(contender.features);
    if (!adds_something && !wants_spare()) return false;
    if (!ids_.insert(contender.c->id).second) return false;
    reached_.insert(contender.features.begin(), contender.features.end());
    (adds_something ? chosen_ : spare_).push_back(std::move(*contender.c));
    return true;
  }

  // Whether candidates that reach nothing new may still be chosen.
  [[nodiscard]] bool wants_spare() const { return spare_.size() < options_.vectors; }

  std::vector<spec::Case> finish() {
    for (std::size_t i = 0; i < spare_.size() && chosen_.size() < options_.vectors; ++i)
      chosen_.push_back(std::move(spare_[i]));
    return std::move(chosen_);
  }

 private:
  [[nodiscard]] bool adds(const std::vector<std::uint32_t>& features) const {
    return std::ranges::any_of(features, [&](std::uint32_t feature) { return !reached_.contains(feature); });
  }

  std::string_view section_;
  SelectOptions options_;
  std::set<std::uint32_t> reached_;
  std::set<std::string> ids_;
  std::vector<spec::Case> chosen_;
  std::vector<spec::Case> spare_;
};

}  // namespace

std::uint64_t seed_of(std::string_view section, std::uint64_t seed, std::size_t index) {
  const std::string digest =
      host::sha256(std::string(section) + ' ' + std::to_string(seed) + ' ' + std::to_string(index));
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 16; ++i)
    value = value << 4U | static_cast<std::uint64_t>(digest[i] <= '9' ? digest[i] - '0' : digest[i] - 'a' + 10);
  return value;
}

std::vector<spec::Case> select(std::string_view section, const SelectOptions& options) {
  Choice choice(section, options);
  for (std::size_t i = 0; i < options.candidates; ++i)
    if (auto contender = choice.look(i)) choice.take(std::move(*contender));
  return choice.finish();
}

void look(std::string_view section, const SelectOptions& options, const Share& share,
          const std::function<void(const Contender&)>& found) {
  Choice choice(section, options);
  for (std::size_t i = share.index - 1; i < options.candidates; i += share.count)
    if (const auto contender = choice.look(i); contender && choice.take(*contender)) found(*contender);
}

std::vector<spec::Case> select(std::string_view section, const SelectOptions& options,
                               std::vector<Contender> contenders) {
  std::ranges::sort(contenders, {}, &Contender::index);
  Choice choice(section, options);
  auto next = contenders.begin();
  for (std::size_t i = 0; i < options.candidates; ++i) {
    if (next != contenders.end() && next->index == i) {
      choice.take(std::move(*next++));
    } else if (choice.wants_spare()) {
      // Passed over by its share, which had enough that reach nothing new; the whole may have fewer.
      if (auto contender = choice.look(i)) choice.take(std::move(*contender));
    }
  }
  return choice.finish();
}

}  // namespace toolcomp::corpus
