// SPDX-License-Identifier: Apache-2.0
#include "fuzz/targets/twin.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <span>
#include <string>

#include "fuzz/campaign/counters.h"
#include "fuzz/campaign/diary.h"
#include "fuzz/campaign/floors.h"
#include "fuzz/campaign/long_program.h"
#include "fuzz/campaign/steering.h"
#include "fuzz/campaign/target.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/mutate.h"
#include "fuzz/targets/worker.h"
#include "judge/oracle/trial.h"

namespace {

using namespace toolcomp::fuzz;
namespace judge = toolcomp::judge;

// libFuzzer reads this section as more coverage and zeroes it before each run. It must be in an object of the
// executable itself: from a shared library it would be lost.
__attribute__((section("__libfuzzer_extra_counters"))) std::array<std::uint8_t, kSteeringSlots> g_counters;

constexpr int kBelowFloor = 76;

Counters g_result;
Mode g_mode = Mode::directed;

void report() {
  if (g_result.executions == 0) return;
  Diary* const diary = worker_diary("");
  if (diary != nullptr) diary->write(g_result);
  std::string text =
      fmt::format("acceptance: {:.1f} % of {} executions", 100 * g_result.accepted_share(), g_result.executions);
  for (std::size_t i = 1; i < judge::kAcceptances; ++i)
    if (g_result.acceptance.at(i) != 0)
      text += fmt::format(", {} {}", name(static_cast<judge::Acceptance>(i)), g_result.acceptance.at(i));
  fmt::print(stderr, "{}\n{} law checks; worst {:.3g} ulp, {:.3g} um\n", text, g_result.law_checks, g_result.worst_ulp,
             g_result.worst_um);
  // A campaign judges the sum of its workers.
  if (diary == nullptr && g_mode == Mode::directed && g_result.executions >= kEnoughToJudge &&
      g_result.accepted_share() < kDirectedFloor) {
    fmt::print(stderr, "acceptance is below its floor of {:.0f} %\n", 100 * kDirectedFloor);
    std::fflush(nullptr);
    std::_Exit(kBelowFloor);
  }
}

// What has to be looked at again.
void note(Diary& diary, const toolcomp::spec::Case& c, const judge::Trial& trial) {
  std::optional<judge::Difference> what = trial.found() ? trial.verdict.difference : std::nullopt;
  if (trial.acceptance == judge::Acceptance::not_decided) what = not_decided(trial.verdict.undecided);
  if (!what) return;
  diary.hit(
      group_of(c.section, *what), g_result.executions, [&](const HowFound& how) { return seen_text(c, *what, how); },
      ".json");
}

std::size_t put(const toolcomp::spec::Case& c, std::uint8_t* out, std::size_t most) {
  const std::string bytes = encode(c);
  if (bytes.size() > most) return 0;
  std::memcpy(out, bytes.data(), bytes.size());
  return bytes.size();
}

}  // namespace

namespace toolcomp::fuzz {

int initialize_target(std::string_view section, Mode mode) {
  g_mode = mode;
  static_cast<void>(worker_diary(twin_name(section, mode).c_str()));
  return std::atexit(report);
}

int run_target(std::string_view section, Mode, const std::uint8_t* data, std::size_t size) {
  const spec::Case c = decode(section, as_text({data, size}));
  Diary* const diary = worker_diary("");
  if (diary != nullptr) diary->begin(as_text({data, size}));
  const judge::Trial trial = try_short(c);
  add(g_result, trial);
  count_reached(trial.run, g_counters);
  if (diary != nullptr) {
    note(*diary, c, trial);
    diary->tick(g_result);
    end_if_failed(*diary, g_result);
    // Not into the corpus: it would be met again and again.
    return trial.found() ? -1 : 0;
  }
  if (!trial.found()) return 0;
  fmt::print(stderr, "\nDIFFERENCE {}\n{}\n", explain(*trial.verdict.difference), encode(c));
  std::abort();
}

std::size_t mutate_input(std::string_view section, Mode mode, std::uint8_t* data, std::size_t size, std::size_t most,
                         unsigned seed) {
  SeededSource source(seed);
  spec::Case c = decode(section, as_text({data, size}));
  // libFuzzer changes an input several times in a row: directed cases start anew often, or they would decay.
  const std::uint64_t anew = mode == Mode::directed ? 2 : 8;
  if (c.program.empty() || source.below(anew) == 0) {
    c = generate(section, mode, source);
  } else {
    change(c, mode, !repeats_much(c), source);
  }
  const std::size_t length = put(c, data, most);
  return length > 0 ? length : size;
}

std::size_t cross_inputs(std::string_view section, const std::uint8_t* a, std::size_t a_size, const std::uint8_t* b,
                         std::size_t b_size, std::uint8_t* out, std::size_t most, unsigned seed) {
  SeededSource source(seed);
  return put(splice(decode(section, as_text({a, a_size})), decode(section, as_text({b, b_size})), source), out, most);
}

}  // namespace toolcomp::fuzz
