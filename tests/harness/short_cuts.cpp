// program: faults
// link: toolcomp_fast_faulty
// The law of short cuts: where one is closed (fast/basis/short_cut.h), the general path gives the same events, bit for
// bit. Three of them compute in doubles what the general path computes otherwise: there the events are the same, and
// their numbers what the model permits. Every mistake seeded into a short cut breaks the law.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fast/basis/fault.h"
#include "fast/basis/short_cut.h"
#include "fuzz/faults/faults.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "fuzz/oracle/verdict.h"
#include "spec/language/event_json.h"
#include "spec/language/input_error.h"
#include "spec/language/text_buffer.h"
#include "tests/sanitized.h"

namespace toolcomp::fuzz {
namespace {

using fast::Fault;
using fast::ShortCut;

constexpr unsigned set_of(ShortCut s) { return 1U << static_cast<unsigned>(s); }
constexpr unsigned kSameArithmetic = set_of(ShortCut::cutter_line);
constexpr unsigned kOwnArithmetic =
    set_of(ShortCut::tool_side_line) | set_of(ShortCut::pair) | set_of(ShortCut::posture);

// What a run gives with some short cuts closed and a fault in force; nothing: a setup that no control could have.
std::optional<std::vector<fast::Event>> run(const spec::Case& c, unsigned closed, Fault fault = Fault::none) {
  struct Restore {
    ~Restore() {
      fast::closed_short_cuts = 0;
      fast::active_fault = Fault::none;
    }
  } const restore;
  fast::closed_short_cuts = closed;
  fast::active_fault = fault;
  try {
    return run_fast(c);
  } catch (const spec::InputError&) {
    return std::nullopt;
  }
}

enum class Numbers : bool { left_out, exact };

// Every field of the events.
std::string text(const std::vector<fast::Event>& events, const spec::Axes& axes, Numbers numbers) {
  std::string all;
  for (const fast::Event& event : events) {
    spec::append_event_json(all, event, axes, [numbers](std::string& to, double value) {
      to += numbers == Numbers::exact ? fmt::format("{:a}", value) : "0";
    });
    all += '\n';
  }
  return all;
}

spec::Case random_case(std::string_view section, std::uint64_t seed) {
  SeededSource source(seed);
  return generate(section, seed % 4 == 0 ? Mode::unrestricted : Mode::directed, source);
}

// Why the law is broken on a case; nothing: it holds.
std::string broken(const spec::Case& c, Fault fault = Fault::none) {
  const auto usual = run(c, 0, fault);
  const auto general = run(c, kSameArithmetic, fault);
  if (usual.has_value() != general.has_value()) return "a setup is refused";
  if (!usual) return "";
  const spec::Axes& axes = c.setup.axes;
  const std::string all = text(*usual, axes, Numbers::exact);
  if (const std::string other = text(*general, axes, Numbers::exact); all != other)
    return "with short cuts\n" + all + "without\n" + other;
  const auto otherwise = run(c, kSameArithmetic | kOwnArithmetic, fault);
  if (text(*otherwise, axes, Numbers::exact) == all) return "";
  if (text(*otherwise, axes, Numbers::left_out) != text(*usual, axes, Numbers::left_out))
    return "with short cuts\n" + all + "without\n" + text(*otherwise, axes, Numbers::exact);
  const ModelRun model = run_model(c);
  for (const auto* events : {&*usual, &*otherwise})
    if (const Verdict verdict = judge(c, model, *events); verdict.outcome == Outcome::differs)
      return explain(*verdict.difference);
  return "";
}

TEST(ShortCuts, GiveWhatTheGeneralPathGives) {
  constexpr std::uint64_t cases = test::kSanitized ? 100 : 1500;
  for (const std::string_view section : sections())
    if (section.starts_with("fanuc/"))
      for (std::uint64_t seed = 1; seed <= cases; ++seed) {
        const spec::Case c = random_case(section, seed);
        const std::string why = broken(c);
        ASSERT_EQ(why, "") << section << " seed " << seed << '\n' << encode(c);
      }
}

// A short cut that were never taken would make the law empty.
TEST(ShortCuts, AMistakeInOneBreaksTheLaw) {
  constexpr std::pair<std::string_view, Fault> kFaults[] = {
#define TOOLCOMP_FAULT(name, mistake, section, budget, clauses) {#name, Fault::name},
#include "fast/basis/faults.inc"
#undef TOOLCOMP_FAULT
  };
  int faults = 0;
  for (const SeededFault& fault : seeded_faults()) {
    if (!fault.name.starts_with("usual_")) continue;
    ++faults;
    const auto* found =
        std::find_if(std::begin(kFaults), std::end(kFaults), [&](const auto& f) { return f.first == fault.name; });
    std::uint64_t seed = 1;
    while (seed <= fault.budget && broken(random_case(fault.section, seed), found->second).empty()) ++seed;
    fmt::print("{:34}{:28}{:>8}\n", fault.name, fault.section, seed);
    EXPECT_LE(seed, fault.budget) << fault.name;
  }
  EXPECT_GE(faults, 8);
}

}  // namespace
}  // namespace toolcomp::fuzz
