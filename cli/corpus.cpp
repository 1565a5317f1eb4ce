// SPDX-License-Identifier: Apache-2.0
// toolcomp corpus: the golden corpus, hard cases, long programs.
#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "cli/controller.h"
#include "cli/manners.h"
#include "cli/program.h"
#include "cli/progress.h"
#include "cli/verbs.h"
#include "corpus/check.h"
#include "corpus/contour.h"
#include "corpus/diff.h"
#include "corpus/flank.h"
#include "corpus/freeform.h"
#include "corpus/generate.h"
#include "corpus/hard.h"
#include "corpus/lint.h"
#include "corpus/proofs/proofs.h"
#include "corpus/shard.h"
#include "corpus/vector.h"
#include "host/file_writer.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const CorpusOptions& options) {
  const fs::path folder = options.directory.empty() ? corpus::default_folder() : fs::path(options.directory);
  detail("corpus " + folder.string());
  return folder;
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
    throw spec::InputError("toolcomp corpus generate --shard", 0, 0, "name the folder of the shards with --dir");
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

// Writes the program named by --out and its setup beside it, whose place it returns.
std::string write_program(const LongProgramOptions& options, const std::string& text, const std::string& setup_text) {
  const fs::path program = fs::absolute(options.out);
  fs::path setup = program;
  setup.replace_extension(".toml");
  expect_folder(program.parent_path(), "--out");
  if (fs::is_directory(program)) throw spec::InputError(options.out, 0, 0, "is a folder");
  if (setup == program)
    throw spec::InputError(options.out, 0, 0, "must not end in .toml, which is the name of the setup next to it");
  host::write_file(setup, setup_text);
  host::write_file(program, text);
  return setup.string();
}

}  // namespace

int corpus_generate(const CorpusOptions& options) {
  if (!options.shard.empty()) return generate_shard(options);
  const Progress progress("vectors");
  return report(corpus::generate(generate_options(options)), fmt::format("seed {}", options.seed));
}

int corpus_merge(const CorpusOptions& options) {
  const Progress progress("vectors");
  return report(corpus::merge_shards(options.against, generate_options(options)), "merged");
}

int corpus_check(const CorpusOptions& options) {
  corpus::CheckOptions how;
  how.folder = folder_of(options);
  how.selection = selection_of(options);
  if (!options.controller.empty()) how.judged_by = judge_of_controller(options.controller, 10);
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

int corpus_lint(const CorpusOptions& options) {
  const std::vector<std::string> breaches = corpus::lint(folder_of(options));
  for (const std::string& breach : breaches) fmt::print("{}\n", breach);
  return breaches.empty() ? kAgrees : kDiffers;
}

int corpus_diff(const CorpusOptions& options) {
  const std::vector<spec::Case> before = corpus::read_golden(options.against);
  const std::vector<spec::Case> after = corpus::read_golden(folder_of(options));
  std::vector<corpus::Change> changes = corpus::diff(before, after);
  {
    const Progress progress("removed vectors");
    corpus::ask_again(changes, before, &Progress::count);
  }
  for (const corpus::Change& change : changes) fmt::print("{}\n", corpus::to_string(change));
  for (const auto& [clause, vectors] : corpus::by_clause(changes))
    fmt::print("{} with another answer: {}\n", vectors, clause.empty() ? "no clause" : clause);
  const corpus::Version version = corpus::parse_version(corpus::read_manifest(options.against).version);
  fmt::print("{} changes; version {} becomes {}\n", changes.size(), corpus::to_string(version),
             corpus::to_string(corpus::raised(version, changes)));
  return changes.empty() ? kAgrees : kDiffers;
}

int corpus_proofs(const CorpusOptions& options) {
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

int corpus_hard(const CorpusOptions& options) {
  const Progress progress("cases");
  const fs::path folder = options.directory.empty() ? corpus::hard_folder() : fs::path(options.directory);
  const corpus::HardCheck result = corpus::check_hard(corpus::read_hard(folder), options.sections,
                                                      [](std::uint64_t done) { Progress::count(done); });
  for (const std::string& failure : result.failures) fmt::print("{}\n", failure);
  fmt::print("{} hard cases, {} statements, {} deviations smaller than stated, {} failures\n", result.cases,
             result.statements, result.lower, result.failures.size());
  if (!result.failures.empty()) return kDiffers;
  return result.cases == 0 ? kUndecided : kAgrees;
}

int corpus_contour(const LongProgramOptions& options) {
  const corpus::Contour made = corpus::make_contour(options.contour);
  const std::string setup = write_program(options, made.program, made.setup);
  fmt::print("seed {}; {} lines, {} arcs; setup {}\n", options.contour.seed, made.lines, made.arcs, setup);
  if (made.alarm_line) fmt::print("{} arcs that lose vectors; PS0041 at line {}\n", made.dropped, *made.alarm_line);
  return kAgrees;
}

int corpus_flank(const LongProgramOptions& options) {
  const corpus::Flank made = corpus::make_flank(options.flank);
  const std::string setup = write_program(options, made.program, made.setup);
  fmt::print("{} blocks in {} passes; setup {}\n", options.flank.blocks, made.passes, setup);
  return kAgrees;
}

int corpus_freeform(const LongProgramOptions& options) {
  const corpus::Freeform made = corpus::make_freeform(options.freeform);
  const std::string setup = write_program(options, made.program, made.setup);
  fmt::print("{} LN blocks in {} passes; setup {}\n", options.freeform.blocks, made.passes, setup);
  return kAgrees;
}

}  // namespace toolcomp::cli
