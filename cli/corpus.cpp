// SPDX-License-Identifier: Apache-2.0
// toolcomp corpus: the golden corpus, hard cases, long programs.
#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "cli/controller.h"
#include "cli/manners.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "cli/verbs.h"
#include "corpus/check.h"
#include "corpus/contour.h"
#include "corpus/diff.h"
#include "corpus/flank.h"
#include "corpus/freeform.h"
#include "corpus/generate.h"
#include "corpus/hard.h"
#include "corpus/lint.h"
#include "corpus/mine/mine.h"
#include "corpus/proofs/proofs.h"
#include "corpus/shard.h"
#include "corpus/vector.h"
#include "spec/language/case_format.h"
#include "spec/language/file_writer.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const CorpusOptions& options) {
  return options.directory.empty() ? corpus::default_folder() : fs::path(options.directory);
}

corpus::Selection selection_of(const CorpusOptions& options) {
  corpus::Selection selection;
  selection.sections = options.sections;
  if (!options.shard.empty()) corpus::set_shard(selection.share, options.shard);
  return selection;
}

corpus::GenerateOptions generate_options(const CorpusOptions& options) {
  corpus::GenerateOptions how;
  how.folder = folder_of(options);
  how.sections = options.sections;
  how.seed = options.seed;
  how.progress = [](const std::string& file, std::size_t vectors) {
    Progress::line(fmt::format("{}: {} vectors", file, vectors));
  };
  return how;
}

// One machine's share, as a file in the folder of shards.
int generate_shard(const CorpusOptions& options) {
  if (options.directory.empty())
    throw spec::InputError("toolcomp corpus generate --shard", 0, 0, "name the folder of the shards: --dir");
  corpus::Share share;
  corpus::set_shard(share, options.shard);
  const Progress progress("vectors");
  corpus::write_shard(generate_options(options), share);
  fmt::print("{}\n", corpus::shard_file(options.directory, share).string());
  return kAgrees;
}

int report(const corpus::GenerateResult& result, const std::string& seed) {
  for (const corpus::Rejection& rejection : result.rejected)
    fmt::print("{}.rej:{}: {}\n", rejection.file, rejection.line, rejection.why);
  if (!result.rejected.empty()) return kSelfCheckFailed;
  fmt::print("{}; {} vectors; corpus {}\n", seed, result.vectors, result.version);
  return kAgrees;
}

int generate(const CorpusOptions& options) {
  if (!options.shard.empty()) return generate_shard(options);
  const Progress progress("vectors");
  return report(corpus::generate(generate_options(options)), fmt::format("seed {}", options.seed));
}

int merge(const CorpusOptions& options) {
  if (options.against.empty()) throw spec::InputError("toolcomp corpus merge", 0, 0, "name the folder of the shards");
  const Progress progress("vectors");
  return report(corpus::merge_shards(options.against, generate_options(options)), "merged");
}

int check(const CorpusOptions& options) {
  corpus::CheckOptions how;
  how.folder = folder_of(options);
  how.selection = selection_of(options);
  if (!options.controller.empty()) how.subject = controller_subject(options.controller, 10);
  const Progress progress("vectors");
  how.progress = [](std::uint64_t done, std::uint64_t) { Progress::count(done); };
  const corpus::CheckResult result = corpus::check(how);
  for (const corpus::Failure& failure : result.failures)
    fmt::print("{}:{}: {}: {}\n", failure.file, failure.line, failure.id, failure.what);
  fmt::print("{} vectors, {} values judged, {} ties, {} undecided, {} failures\n", result.vectors, result.values,
             result.ties, result.undecided, result.failures.size());
  if (!result.failures.empty()) return kDiffers;
  return result.undecided > 0 || result.values == 0 ? kUndecided : kAgrees;
}

int lint(const CorpusOptions& options) {
  const std::vector<std::string> breaches = corpus::lint(folder_of(options));
  for (const std::string& breach : breaches) fmt::print("{}\n", breach);
  return breaches.empty() ? kAgrees : kDiffers;
}

int diff(const CorpusOptions& options) {
  if (options.against.empty())
    throw spec::InputError("toolcomp corpus diff", 0, 0, "name the folder of the other corpus");
  const std::vector<spec::Case> before = corpus::read_golden(options.against);
  const std::vector<spec::Case> after = corpus::read_golden(folder_of(options));
  const std::vector<corpus::Change> changes = corpus::diff(before, after);
  for (const corpus::Change& change : changes) fmt::print("{}\n", corpus::to_string(change));
  const corpus::Version version = corpus::parse_version(corpus::read_manifest(options.against).version);
  fmt::print("{} changes; version {} becomes {}\n", changes.size(), corpus::to_string(version),
             corpus::to_string(corpus::raised(version, changes)));
  return changes.empty() ? kAgrees : kDiffers;
}

// Each case a file; toolcomp replay takes it.
void write_met(const std::string& folder, std::vector<corpus::Met> cases, std::string_view what) {
  for (corpus::Met& met : cases) {
    met.c.id = corpus::vector_id(met.c);
    met.c.expect.clear();
    met.c.has_expect = false;
    const fs::path file = fs::path(folder) / (met.c.id + ".json");
    spec::write_file(file, spec::write_case(met.c));
    fmt::print("{}: {}: {}\n", what, file.string(), met.what);
  }
}

int proofs(const CorpusOptions& options) {
  if (options.into.empty()) throw spec::InputError("toolcomp corpus proofs", 0, 0, "name the folder to write: --into");
  corpus::ProofOptions how;
  how.sections = options.sections;
  how.a_section = options.sample;
  how.seed = options.seed;
  how.only_tell = options.only_tell;
  const corpus::ProofFiles written = corpus::write_proofs(folder_of(options), options.into, how);
  for (const auto& [section, vectors] : written.vectors) fmt::print("{}: {} vectors\n", section, vectors);
  fmt::print("{} files; corpus/proofs/check proves them\n", written.files);
  return kAgrees;
}

int mine(const CorpusOptions& options) {
  if (options.into.empty()) throw spec::InputError("toolcomp corpus mine", 0, 0, "name the folder to write: --into");
  if (options.runs != 0 && !options.duration.empty())
    throw spec::InputError("toolcomp corpus mine", 0, 0, "--for or --runs, not both");
  corpus::MineOptions how;
  how.sections = options.sections;
  how.seed = options.seed;
  how.jobs = options.jobs;
  how.runs = options.runs;
  if (options.runs == 0)
    how.seconds =
        static_cast<double>(duration_of(options.duration.empty() ? "10m" : options.duration, "--for").count());
  const Stop stop;
  how.stop = [&stop] { return !stop.why().empty(); };
  const Progress progress("runs");
  how.progress = [](const std::string& section, std::uint64_t runs) {
    Progress::line(fmt::format("{}: {} runs", section, runs));
  };
  const bool begun = fs::exists(fs::path(options.into) / "manifest.json");
  corpus::MineResult result = corpus::mine(begun ? corpus::read_hard(options.into) : corpus::HardCases(), how);
  const std::size_t nearest = result.hard.nearest.size();
  const std::size_t worst = result.hard.worst.size();
  const bool differ = !result.differ.empty();
  write_met(options.findings, std::move(result.differ), "FINDING");
  write_met(options.findings, std::move(result.undecided), "undecided");
  corpus::write_hard(options.into, std::move(result.hard));
  if (const std::string why = stop.why(); !why.empty())
    fmt::print(stderr, "{}: what was found until then is written\n", why);
  fmt::print("seed {}; {} runs; {} nearest cases, {} largest deviations; {} cases larger than what is searched\n",
             options.seed, result.runs, nearest, worst, result.not_searched);
  return differ ? kDiffers : kAgrees;
}

int hard(const CorpusOptions& options) {
  const Progress progress("cases");
  const corpus::HardCheck result =
      corpus::check_hard(options.directory.empty() ? corpus::hard_folder() : fs::path(options.directory),
                         options.sections, [](std::uint64_t done) { Progress::count(done); });
  for (const std::string& failure : result.failures) fmt::print("{}\n", failure);
  fmt::print("{} hard cases, {} statements, {} deviations smaller than stated, {} failures\n", result.cases,
             result.statements, result.lower, result.failures.size());
  if (!result.failures.empty()) return kDiffers;
  return result.cases == 0 ? kUndecided : kAgrees;
}

// Writes the program named by --out and its setup beside it, whose place it returns.
std::string write_program(const CorpusOptions& options, const std::string& text, const std::string& setup_text) {
  const fs::path program = fs::absolute(options.out);
  fs::path setup = program;
  setup.replace_extension(".toml");
  expect_folder(program.parent_path(), "--out");
  if (fs::is_directory(program)) throw spec::InputError(options.out, 0, 0, "is a folder");
  if (setup == program) throw spec::InputError(options.out, 0, 0, "the ending .toml is that of the setup beside it");
  spec::write_file(setup, setup_text);
  spec::write_file(program, text);
  return setup.string();
}

void expect_program_name(const CorpusOptions& options) {
  if (options.out.empty())
    throw spec::InputError("toolcomp corpus " + options.verb, 0, 0, "name the program to write: --out");
}

void expect_blocks(const CorpusOptions& options, std::size_t least, std::size_t most) {
  if (options.blocks && (*options.blocks < least || *options.blocks > most))
    throw spec::InputError("toolcomp corpus " + options.verb, 0, 0, fmt::format("--blocks: {} to {}", least, most));
}

int contour(const CorpusOptions& options) {
  constexpr std::size_t kMost = 100'000'000;
  expect_program_name(options);
  expect_blocks(options, corpus::kLeastContour, kMost);
  corpus::ContourOptions how = options.contour;
  how.blocks = options.blocks.value_or(how.blocks);
  how.seed = options.seed;
  const corpus::Contour made = corpus::make_contour(how);
  const std::string setup = write_program(options, made.program, made.setup);
  fmt::print("seed {}; {} lines, {} arcs; setup {}\n", options.seed, made.lines, made.arcs, setup);
  if (made.alarm_line) fmt::print("{} arcs that lose vectors; PS0041 at line {}\n", made.dropped, *made.alarm_line);
  return kAgrees;
}

int flank(const CorpusOptions& options) {
  expect_program_name(options);
  expect_blocks(options, corpus::kLeastFlank, corpus::kMostFlank);
  corpus::FlankOptions how;
  how.blocks = options.blocks.value_or(how.blocks);
  how.tool = options.tool;
  const corpus::Flank made = corpus::make_flank(how);
  const std::string setup = write_program(options, made.program, made.setup);
  fmt::print("{} blocks in {} passes; setup {}\n", how.blocks, made.passes, setup);
  return kAgrees;
}

int freeform(const CorpusOptions& options) {
  expect_program_name(options);
  expect_blocks(options, corpus::kLeastFreeform, corpus::kMostFreeform);
  corpus::FreeformOptions how;
  how.blocks = options.blocks.value_or(how.blocks);
  how.tool_vector = !options.no_tool_vector;
  const corpus::Freeform made = corpus::make_freeform(how);
  const std::string setup = write_program(options, made.program, made.setup);
  fmt::print("{} LN blocks in {} passes; setup {}\n", how.blocks, made.passes, setup);
  return kAgrees;
}

}  // namespace

int corpus(const CorpusOptions& options) {
  detail(fmt::format("corpus {}, seed {}, {} jobs", folder_of(options).string(), options.seed, options.jobs));
  if (options.verb == "generate") return generate(options);
  if (options.verb == "merge") return merge(options);
  if (options.verb == "check") return check(options);
  if (options.verb == "lint") return lint(options);
  if (options.verb == "proofs") return proofs(options);
  if (options.verb == "mine") return mine(options);
  if (options.verb == "hard") return hard(options);
  if (options.verb == "contour") return contour(options);
  if (options.verb == "flank") return flank(options);
  if (options.verb == "freeform") return freeform(options);
  return diff(options);
}

}  // namespace toolcomp::cli
