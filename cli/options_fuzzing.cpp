// SPDX-License-Identifier: Apache-2.0
// The verb fuzz, and the unlisted ones of the processes that a campaign begins.
#include <memory>

#include "cli/command_line.h"
#include "cli/options.h"
#include "cli/verbs.h"

namespace toolcomp::cli {
namespace {

void define_fuzz(CommandLine& line) {
  const auto options = std::make_shared<FuzzOptions>();
  CLI::App* sub = line.verb(
      "fuzz",
      "Search for differences\n"
      "Searches for programs on which two engines, or a controller and the model, differ. It shortens the program of "
      "every finding, and keeps the finding in a folder of its own (NAME/finding.json, for `toolcomp replay`). With "
      "--campaign it keeps everything in a folder, and resumes a search where it stopped (docs/campaigns.md).",
      [options] { return fuzz(*options); });
  sub->footer(R"(Examples:
  One section, for a hundred programs:
    $ toolcomp fuzz --section fanuc/tool-offset --runs 100 --seed 1 --built-in)");
  take_sections(sub, options->sections);
  take(sub, "--for", options->duration, "TIME",
       "Total time: 60s, 10m, 1h (default without --runs: 60s; with --campaign: no limit)");
  take(sub, "--runs", options->runs, "N",
       "Number of executions of each section, instead of --for; each of the two targets of a section gets half");
  take(sub, "--jobs", options->jobs, "N", "Number of workers in parallel", 1U, 256U);
  take(sub, "--seed", options->seed, "N", "Seed of every random choice");
  take(sub, "--controller", options->controller, "CONTROLLER", "Judge this controller instead of the fast engine");
  take(sub, "--findings", options->findings, "FOLDER",
       "Write each finding into a folder of its own in this folder (default without --campaign: findings)");
  take_accept_resolution(sub, options->accept_resolution);
  take_timeout(sub, options->timeout, "Seconds that the controller may take for a case");
  take(sub, "--campaign", options->campaign, "FOLDER",
       "Keep everything in this folder (docs/campaigns.md), and resume where it stopped");
  take(sub, "--target", options->targets, "TARGET", "Search this target, besides those of --section (repeatable)");
  take(sub, "--shard", options->shard, "I/N", "This is machine I of N; every machine has its own seeds");
  take(sub, "--merge", options->merge, "FOLDER",
       "Merge the campaigns in these folders into a new one in the folder of --campaign")
      ->allow_extra_args();
  sub->add_flag("--built-in", options->built_in, "Use the built-in driver even if the clang targets are built");
  sub->add_flag("--no-specification", options->no_specification,
                "Do not ask the formal specification as a third engine");
  sub->add_flag("--json", options->json, "Print the summary as JSON on standard output");
}

void define_worker(CommandLine& line) {
  const auto options = std::make_shared<WorkerOptions>();
  CLI::App* sub = line.unlisted("fuzz-worker", "A worker of a campaign", [options] { return fuzz_worker(*options); });
  sub->add_option("--target", options->target)->required();
  sub->add_option("--work", options->work)->required();
  sub->add_option("--corpus", options->corpus)->required();
  sub->add_option("--inputs", options->inputs)->allow_extra_args(false);
  sub->add_option("--seed", options->seed);
  sub->add_option("--seconds", options->seconds);
  sub->add_option("--runs", options->runs);
  sub->add_option("--controller", options->controller);
  sub->add_option("--timeout", options->timeout);
}

void define_specification(CommandLine& line) {
  const auto options = std::make_shared<SpecificationWorkerOptions>();
  CLI::App* sub = line.unlisted("fuzz-specification", "The third voice of a campaign",
                                [options] { return fuzz_specification(*options); });
  sub->add_option("--target", options->targets)->allow_extra_args(false);
  sub->add_option("--work", options->work)->required();
  sub->add_option("--corpus", options->corpus)->required();
  sub->add_option("--asked", options->asked)->required();
  sub->add_option("--seed", options->seed);
  sub->add_option("--seconds", options->seconds);
}

void define_settle(CommandLine& line) {
  const auto options = std::make_shared<SettleOptions>();
  CLI::App* sub = line.unlisted("fuzz-settle", "A sighting looked at", [options] { return fuzz_settle(*options); });
  sub->add_option("--campaign", options->campaign)->required();
  sub->add_option("--target", options->target)->required();
  sub->add_option("--as-seen", options->as_seen);
  sub->add_option("--timeout", options->timeout);
  sub->add_option("file", options->file)->required();
}

}  // namespace

void define_fuzzing(CommandLine& line) {
  define_fuzz(line);
  define_worker(line);
  define_specification(line);
  define_settle(line);
}

}  // namespace toolcomp::cli
