// SPDX-License-Identifier: Apache-2.0
// Generators of cases over an abstract source of choices.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "spec/language/case.h"

namespace toolcomp::fuzz {

// Where a generator's choices come from: a seeded random source, bytes of a fuzzer, RapidCheck.
class ChoiceSource {
 public:
  virtual ~ChoiceSource() = default;
  // A choice in [0, n), n >= 1.
  virtual std::uint64_t below(std::uint64_t n) = 0;
};

// The same seed gives the same choices on every compiler.
class SeededSource final : public ChoiceSource {
 public:
  explicit SeededSource(std::uint64_t seed) : state_(seed) {}
  std::uint64_t below(std::uint64_t n) override;

 private:
  std::uint64_t state_;
};

// Directed cases are mostly valid programs of the section; unrestricted ones are any words.
enum class Mode : std::uint8_t { directed, unrestricted };

// The sections that are built, in the order in which they build on each other.
std::span<const std::string_view> sections();
// A case of `section` with `blocks` blocks or fewer (0: the generator chooses: mostly 4 to 8, some
// tens, seldom hundreds). Throws std::invalid_argument
// for an unknown section.
spec::Case generate(std::string_view section, Mode mode, ChoiceSource& source, std::uint32_t blocks = 0);

// A directed case in whose program one word is changed, moved or left out. Throws as generate().
spec::Case generate_with_slip(std::string_view section, ChoiceSource& source);

}  // namespace toolcomp::fuzz
