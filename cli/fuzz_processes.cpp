// SPDX-License-Identifier: Apache-2.0
// The processes of a campaign: the built-in driver as a worker, the third voice, a sighting looked at.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "certify/finding.h"
#include "certify/fuzzing/settler.h"
#include "certify/fuzzing/third_voice.h"
#include "cli/controller.h"
#include "cli/verbs.h"
#include "fuzz/campaign/diary.h"
#include "fuzz/campaign/driver.h"
#include "fuzz/campaign/target.h"
#include "fuzz/gen/encode.h"
#include "host/file_writer.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"
#include "spec_engine/engine.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;
namespace fuzzing = certify::fuzzing;

// A worker's seed in all of its 64 bits, so that the executions of two workers never meet.
std::uint64_t spread(std::uint64_t seed) {
  seed += 0x9E3779B97F4A7C15ULL;
  seed = (seed ^ (seed >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  seed = (seed ^ (seed >> 27U)) * 0x94D049BB133111EBULL;
  return seed ^ (seed >> 31U);
}

class BuiltIn {
 public:
  BuiltIn(const WorkerOptions& options, const fuzz::Target& target)
      : options_(options),
        target_(target),
        diary_(options.work, target.name, options.seed),
        driver_(driver_options()) {}

  int run() {
    visit_corpus();
    for (std::uint64_t i = 0; goes_on(i); ++i) {
      driver_.step(i);
      diary_.tick(driver_.result());
    }
    diary_.write(driver_.result());
    return diary_.failed() ? fuzz::Diary::kCannotWrite : kAgrees;
  }

 private:
  bool goes_on(std::uint64_t i) {
    if (diary_.failed()) return false;
    return options_.runs > 0 ? i < options_.runs : diary_.seconds() < static_cast<double>(options_.seconds);
  }

  // In the order of their names, so that the same inputs give the same search.
  void visit_corpus() {
    std::vector<std::string> folders = options_.inputs;
    folders.push_back(options_.corpus);
    for (const std::string& folder : folders) {
      std::vector<fs::path> files;
      for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().extension() != ".part") files.push_back(entry.path());
      std::ranges::sort(files);
      for (const fs::path& file : files) {
        if (!goes_on(0)) return;
        spec::Case c = fuzz::decode(target_.section, spec::read_file(file.string()));
        c.section = target_.section;
        driver_.revisit(std::move(c));
        diary_.tick(driver_.result());
      }
    }
  }

  fuzz::DriverOptions driver_options() {
    fuzz::DriverOptions driver;
    driver.section = target_.section;
    driver.mode = target_.mode;
    driver.seed = spread(options_.seed);
    driver.on_input = [this](const spec::Case& c) { diary_.begin(fuzz::encode(c)); };
    driver.on_corpus = [this](const spec::Case& c) { keep(fuzz::encode(c)); };
    driver.on_open = [this](const spec::Case& c, const std::string& why) { note(c, fuzz::not_decided(why)); };
    if (options_.controller.empty())
      driver.on_finding = [this](const spec::Case& c, const judge::Difference& difference) { note(c, difference); };
    else
      driver.judged_by = judge_of_controller(options_.controller, options_.timeout, {},
                                             [this](certify::Finding seen) { note(std::move(seen)); });
    return driver;
  }

  void note(const spec::Case& c, const judge::Difference& difference) {
    diary_.hit(
        fuzz::group_of(c.section, difference), driver_.result().executions,
        [&](const fuzz::HowFound& how) { return fuzz::seen_text(c, difference, how); }, ".json");
  }

  // Of a controller all that was seen belongs to it: what it was asked before, and what it said.
  void note(certify::Finding seen) {
    diary_.hit(
        fuzz::group_of(seen.key.section, seen.difference), driver_.result().executions + 1,
        [&](const fuzz::HowFound& how) {
          seen = certify::signed_finding(std::move(seen), options_.controller, options_.seed);
          seen.target = how.target;
          seen.executions = how.executions;
          seen.seconds = how.seconds;
          return certify::write_finding(seen);
        },
        ".json");
  }

  void keep(const std::string& input) {
    try {
      host::write_file(fs::path(options_.corpus) / fuzz::digest(input), input);
    } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch)
      // Where the disk is full the diary cannot be written either, and that ends this worker.
    }
  }

  const WorkerOptions& options_;
  const fuzz::Target& target_;
  fuzz::Diary diary_;
  fuzz::Driver driver_;
};

}  // namespace

int fuzz_worker(const WorkerOptions& options) {
  const fuzz::Target* const target = fuzz::find_target(options.target);
  if (target == nullptr || target->is_reader())
    throw spec::InputError("toolcomp fuzz-worker", 0, 0, "not a fuzz target of a section: " + options.target);
  try {
    return BuiltIn(options, *target).run();
  } catch (const spec::InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    std::cerr << error.what() << '\n';
    return fuzz::Diary::kCannotWrite;
  }
}

int fuzz_specification(const SpecificationWorkerOptions& options) {
  if (!spec_engine::available())
    throw spec::InputError("toolcomp fuzz-specification", 0, 0, "built without the formal specification");
  fuzzing::ThirdVoiceOptions voice;
  voice.work = options.work;
  voice.corpus = options.corpus;
  voice.asked = options.asked;
  voice.seed = options.seed;
  voice.seconds = options.seconds;
  for (const std::string& name : options.targets)
    if (const fuzz::Target* target = fuzz::find_target(name); target != nullptr && !target->is_reader())
      voice.targets.push_back(target);
  return fuzzing::run_third_voice(voice);
}

int fuzz_settle(const SettleOptions& options) {
  try {
    fuzzing::SettleOptions how;
    how.timeout = std::chrono::milliseconds(static_cast<std::int64_t>(options.timeout * 1000));
    const fuzzing::Folder folder{options.campaign};
    std::cout << fuzzing::write_settled(
                     fuzzing::settle_file(folder, options.file, options.target, options.as_seen, how))
              << std::endl;
    return kAgrees;
  } catch (const spec::InputError& error) {
    std::cerr << error.what() << '\n';
    return kBadInput;
  } catch (const std::runtime_error& error) {
    // What looking at it throws is in its dossier: it is the dossier that could not be written.
    std::cerr << error.what() << '\n';
    return fuzz::Diary::kCannotWrite;
  }
}

}  // namespace toolcomp::cli
