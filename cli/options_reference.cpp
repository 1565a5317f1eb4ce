// SPDX-License-Identifier: Apache-2.0
// Verbs for what stands written: corpus, spec, config.
#include <map>
#include <memory>
#include <string>

#include "cli/command_line.h"
#include "cli/options.h"
#include "cli/verbs.h"

namespace toolcomp::cli {
namespace {

const std::map<std::string, corpus::ContourVariant> kVariants{{"pocket", corpus::ContourVariant::pocket},
                                                              {"island", corpus::ContourVariant::island},
                                                              {"tight", corpus::ContourVariant::tight}};
const std::map<std::string, corpus::FlankTool> kTools{{"rotary", corpus::FlankTool::rotary},
                                                      {"vector", corpus::FlankTool::vector}};
const std::map<std::string, corpus::TightPlace> kPlaces{{"arc", corpus::TightPlace::arc},
                                                        {"groove", corpus::TightPlace::groove}};

void define_corpus(CommandLine& line) {
  const auto options = std::make_shared<CorpusOptions>();
  CLI::App* sub = line.verb("corpus",
                            "The golden corpus: generate, merge, check, lint, diff, proofs; hard cases: mine, hard; "
                            "long programs: contour, flank, freeform",
                            [options] { return corpus(*options); });
  choose(sub, "verb", options->verb,
         {"generate", "merge", "check", "lint", "diff", "proofs", "mine", "hard", "contour", "flank", "freeform"},
         "generate, merge, check, lint, diff, proofs, mine, hard, contour, flank or freeform")
      ->required();
  take(sub, "against", options->against, "FOLDER", "diff: the folder of the other corpus; merge: that of the shards");
  take_sections(sub, options->sections);
  take(
      sub, "--dir", options->directory, "FOLDER",
      "Folder of the corpus (default: corpus/golden of the source tree; hard: corpus/hard), or of the shards (generate "
      "--shard)");
  take(sub, "--shard", options->shard, "I/N",
       "I/N: only every N-th vector, from the I-th (1 <= I <= N); generate: the share of one machine of N, for merge");
  take(sub, "--controller", options->controller, "CONTROLLER", "check: judge this controller instead of both engines");
  take(sub, "--seed", options->seed, "N", "Seed of every random choice");
  take(sub, "--into", options->into, "FOLDER",
       "proofs: folder for Coq's files; mine: folder of the hard cases; those there are where the search begins");
  take(sub, "--sample", options->sample, "N", "proofs: so many vectors of each section, by the seed; 0: all");
  sub->add_flag("--tell", options->only_tell, "proofs: have Coq tell which vectors it can compute, instead of proofs");
  take(sub, "--for", options->duration, "TIME", "mine: how long in all: 60s, 10m, 1h (default 10m without --runs)");
  take(sub, "--runs", options->runs, "N", "mine: runs of the model a section instead of a time");
  take(sub, "--jobs", options->jobs, "N", "mine: sections side by side", 1U, 256U);
  take(sub, "--findings", options->findings, "FOLDER", "mine: folder for cases on which the engines differ");
  take(sub, "--out", options->out, "FILE",
       "contour, flank, freeform: the program to write; its setup goes beside it, ending in .toml");
  take(
      sub, "--blocks", options->blocks, "N",
      "contour: how many lines and arcs (default: 100000); flank: how many blocks (default: 20000); freeform: how many "
      "LN blocks (default: 500000)");
  choose(sub, "--tool", options->tool, kTools, "flank: the tool axis by B and C (rotary) or by I J K (vector)");
  sub->add_flag("--no-tool-vector", options->no_tool_vector, "freeform: without TX TY TZ, the tool stays along Z");
  take(sub, "--arcs", options->contour.arcs, "N", "contour: how many of 100 blocks are arcs (default: 40)", 0U, 100U);
  choose(sub, "--variant", options->contour.variant, kVariants, "contour: pocket, island or tight (ends in PS0041)");
  choose(sub, "--place", options->contour.place, kPlaces,
         "contour, tight: the place that raises PS0041, arc or groove");
  take(sub, "--at", options->contour.at, "N", "contour, tight: from which block on the place is (default: the middle)");
}

void define_spec(CommandLine& line) {
  const auto options = std::make_shared<SpecOptions>();
  CLI::App* sub = line.verb("spec", "The clauses: list, show, trace, coverage, sections; keys and parameters of setups",
                            [options] { return spec(*options); });
  choose(sub, "verb", options->verb, {"list", "show", "trace", "coverage", "sections", "keys", "parameters"},
         "list, show, trace, coverage, sections, keys or parameters")
      ->required();
  take(sub, "id", options->id, "CLAUSE", "show: the clause");
  take(sub, "--dir", options->directory, "FOLDER",
       "Source tree (trace) or corpus (coverage); default: where it was built");
  sub->add_flag("--json", options->json, "JSON instead of text");
}

void define_config(CommandLine& line) {
  const auto options = std::make_shared<ConfigOptions>();
  CLI::App* sub =
      line.verb("config", "Setups and cases: example, schema, check FILE", [options] { return config(*options); });
  choose(sub, "verb", options->verb, {"example", "schema", "check"}, "example, schema or check")->required();
  take(sub, "file", options->file, "FILE",
       "check: the setup or case; schema: setup (default), case, event, hello or answer");
  choose(sub, "--control", options->control, {"fanuc", "heidenhain"}, "fanuc or heidenhain");
}

}  // namespace

void define_reference(CommandLine& line) {
  define_corpus(line);
  define_spec(line);
  define_config(line);
}

}  // namespace toolcomp::cli
