// SPDX-License-Identifier: Apache-2.0
// Fuzzer bytes are cases: whatever a generator makes comes back, and any bytes are some case.
#include <gtest/gtest.h>

#include <string>

#include "fuzz/gen/encode.h"
#include "fuzz/gen/mutate.h"
#include "tests/effort.h"
#include "tests/setup_members.h"

namespace toolcomp::fuzz {
namespace {

void expect_same(const spec::Case& a, const spec::Case& b) {
  EXPECT_TRUE(a.setup == b.setup) << encode(a);
  EXPECT_EQ(a.program, b.program);
  EXPECT_EQ(a.section, b.section);
}

TEST(Encoding, GivesBackEveryGeneratedAndEveryMutatedCase) {
  const std::uint64_t seeds = test::random_cases(2000);
  for (std::uint64_t seed = 0; seed < seeds; ++seed)
    for (const std::string_view section : sections())
      for (const Mode mode : {Mode::directed, Mode::unrestricted}) {
        SeededSource source(seed);
        spec::Case c = generate(section, mode, source);
        expect_same(c, decode(section, encode(c)));
        mutate(c, mode, source);
        expect_same(c, decode(section, encode(c)));
      }
}

TEST(Encoding, NoMemberOfASetupIsForgotten) {
  for (const test::Changed& changed : test::changed_setups()) {
    spec::Case c;
    c.setup = changed.changed;
    EXPECT_TRUE(decode("", encode(c)).setup == c.setup) << changed.what << '\n' << encode(c);
  }
}

// Seeds on disks everywhere say it so: letters of keys stay.
TEST(Encoding, LinesOfKeys) {
  const auto read = [](std::string_view lines) { return decode("", lines).setup; };
  EXPECT_EQ(read("u inch\n").units, spec::Units::inch);
  EXPECT_EQ(read("u inch\nu mm\n").units, spec::Units::mm);
  EXPECT_EQ(read("i A\n").increment, spec::IncrementSystem::is_a);
  EXPECT_EQ(read("i C\n").increment, spec::IncrementSystem::is_c);
  EXPECT_EQ(read("k b\n").cutter_compensation, spec::CutterCompensationType::b);
  EXPECT_TRUE(read("s\n").block_skip);
  EXPECT_TRUE(read("x\n").type_b_without_perpendicular);
  EXPECT_EQ(read("v\n").rotary_angles, spec::RotaryAngles::programmed);
  EXPECT_TRUE(read("c heidenhain\ns\n").block_skip);
  EXPECT_EQ(read("c heidenhain\nu inch\n").units, spec::Units::inch);
  spec::Setup heidenhain;
  heidenhain.control = spec::Control::heidenhain;
  EXPECT_TRUE(read("c heidenhain\ni A\nk b\nx\nv\n") == heidenhain);
  EXPECT_TRUE(read("i D\nk a\nu\nu foot\nU inch\n") == spec::Setup{});
}

TEST(Encoding, AnyBytesAreACase) {
  SeededSource source(1);
  for (int i = 0; i < 20'000; ++i) {
    std::string bytes;
    if (i % 2 == 0) {
      SeededSource seed(static_cast<std::uint64_t>(i));
      bytes = encode(generate(sections()[0], Mode::unrestricted, seed));
      for (int n = 0; n < 5; ++n) bytes[source.below(bytes.size())] = static_cast<char>(source.below(256));
    } else {
      for (std::uint64_t n = source.below(200); n > 0; --n) bytes += static_cast<char>(source.below(256));
    }
    const spec::Case c = decode(sections()[0], bytes);
    // What was read is what is written: decoding is a projection.
    expect_same(c, decode(sections()[0], encode(c)));
  }
}

TEST(Generators, AreTheSameForTheSameSeed) {
  for (const std::string_view section : sections()) {
    SeededSource a(42);
    SeededSource b(42);
    SeededSource other(43);
    const std::string first = encode(generate(section, Mode::directed, a));
    EXPECT_EQ(first, encode(generate(section, Mode::directed, b)));
    EXPECT_NE(first, encode(generate(section, Mode::directed, other)));
  }
}

// SplitMix64 with seed 0, from the reference implementation of its authors: the first output is 0xE220A8397B1DCDAF.
TEST(Generators, TheSeededSourceIsSplitMix64) {
  SeededSource source(0);
  EXPECT_EQ(source.below(~0ULL), 0xE220A8397B1DCDAFULL);
  EXPECT_EQ(source.below(~0ULL), 0x6E789E6AA1B965F4ULL);
}

TEST(Generators, UnknownSectionsAreRefused) {
  SeededSource source(1);
  EXPECT_THROW(generate("fanuc/no-such-section", Mode::directed, source), std::invalid_argument);
}

}  // namespace
}  // namespace toolcomp::fuzz
