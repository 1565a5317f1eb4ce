#include "fuzz/targets/twin.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <span>
#include <string>

#include "fuzz/campaign/features.h"
#include "fuzz/campaign/summary.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/mutate.h"
#include "fuzz/oracle/control.h"
#include "fuzz/oracle/trial.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace {

using namespace toolcomp::fuzz;

// libFuzzer reads this section as more coverage and zeroes it before each run. It must be in an object of the
// executable itself: from a shared library it would be lost.
__attribute__((section("__libfuzzer_extra_counters"))) std::array<std::uint8_t, kFeatures> g_counters;

// Directed cases are made to be judged: a target below this share tests its own generator's mistakes.
constexpr double kFloor = 0.85;
// Fewer executions say nothing about a share (replays, minimisation).
constexpr std::uint64_t kEnough = 2000;
constexpr int kBelowFloor = 76;

CampaignResult g_result;
Mode g_mode = Mode::directed;
std::chrono::steady_clock::time_point g_start;

// To the file named by TOOLCOMP_FUZZ_STATISTICS, if it is set.
void write_statistics() {
  g_result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - g_start).count();
  g_result.cores = 1;
  if (const char* path = std::getenv("TOOLCOMP_FUZZ_STATISTICS"))  // NOLINT(concurrency-mt-unsafe): one thread
    std::ofstream(path) << write_summary(g_result);
}

void report() {
  if (g_result.executions == 0) return;
  write_statistics();
  std::string text =
      fmt::format("acceptance: {:.1f} % of {} executions", 100 * g_result.accepted_share(), g_result.executions);
  for (std::size_t i = 1; i < kAcceptances; ++i)
    if (g_result.acceptance.at(i) != 0)
      text += fmt::format(", {} {}", name(static_cast<Acceptance>(i)), g_result.acceptance.at(i));
  fmt::print(stderr, "{}\n{} questions of laws; worst {:.3g} ulp, {:.3g} um\n", text, g_result.law_checks,
             g_result.worst_ulp, g_result.worst_um);
  if (g_mode == Mode::directed && g_result.executions >= kEnough && g_result.accepted_share() < kFloor) {
    fmt::print(stderr, "acceptance is below its floor of {:.0f} %\n", 100 * kFloor);
    std::fflush(nullptr);
    std::_Exit(kBelowFloor);
  }
}

// Programs that call others may be as long as they like: too long to be run here.
bool repeats_much(const toolcomp::spec::Case& c) {
  constexpr std::size_t kMostBlocks = 4000;
  return toolcomp::fuzz::with_control(c.setup, [&]<class Control>(Control) {
    auto reader = Control::reader(toolcomp::spec::text_source(c.program), c.setup, "program");
    typename Control::Block block;
    std::size_t blocks = 0;
    try {
      while (blocks <= kMostBlocks && reader.next(block)) ++blocks;
    } catch (const toolcomp::spec::InputError&) {
      return false;
    }
    return blocks > kMostBlocks;
  });
}

std::size_t put(const toolcomp::spec::Case& c, std::uint8_t* out, std::size_t most) {
  const std::string bytes = encode(c);
  if (bytes.size() > most) return 0;
  std::memcpy(out, bytes.data(), bytes.size());
  return bytes.size();
}

}  // namespace

namespace toolcomp::fuzz {

int initialize_target(std::string_view, Mode mode) {
  g_mode = mode;
  g_start = std::chrono::steady_clock::now();
  return std::atexit(report);
}

void run_target(std::string_view section, Mode, const std::uint8_t* data, std::size_t size) {
  const spec::Case c = decode(section, as_text({data, size}));
  if (repeats_much(c)) return;
  const Trial trial = try_case(c);
  add(g_result, trial);
  count_features(trial.run.recorder, g_counters);
  if (!trial.found()) return;
  write_statistics();
  fmt::print(stderr, "\nDIFFERENCE {}\n{}\n", explain(*trial.verdict.difference), encode(c));
  std::abort();
}

std::size_t mutate_input(std::string_view section, Mode mode, std::uint8_t* data, std::size_t size, std::size_t most,
                         unsigned seed) {
  SeededSource source(seed);
  spec::Case c = decode(section, as_text({data, size}));
  // libFuzzer changes an input several times in a row: directed cases start anew often, or they would decay.
  const std::uint64_t anew = mode == Mode::directed ? 2 : 8;
  if (c.program.empty() || source.below(anew) == 0)
    c = generate(section, mode, source);
  else
    mutate(c, mode, source);
  const std::size_t length = put(c, data, most);
  return length > 0 ? length : size;
}

std::size_t cross_inputs(std::string_view section, const std::uint8_t* a, std::size_t a_size, const std::uint8_t* b,
                         std::size_t b_size, std::uint8_t* out, std::size_t most, unsigned seed) {
  SeededSource source(seed);
  return put(splice(decode(section, as_text({a, a_size})), decode(section, as_text({b, b_size})), source), out, most);
}

}  // namespace toolcomp::fuzz
