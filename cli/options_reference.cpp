// SPDX-License-Identifier: Apache-2.0
// Verbs for what stands written: corpus, spec, config.
#include <cstddef>
#include <map>
#include <memory>
#include <string>

#include "cli/command_line.h"
#include "cli/options.h"
#include "cli/verbs.h"
#include "corpus/contour.h"
#include "corpus/flank.h"
#include "corpus/freeform.h"

namespace toolcomp::cli {
namespace {

const std::map<std::string, corpus::ContourVariant> kVariants{{"pocket", corpus::ContourVariant::pocket},
                                                              {"island", corpus::ContourVariant::island},
                                                              {"tight", corpus::ContourVariant::tight}};
const std::map<std::string, corpus::FlankTool> kTools{{"rotary", corpus::FlankTool::rotary},
                                                      {"vector", corpus::FlankTool::vector}};
const std::map<std::string, corpus::TightPlace> kPlaces{{"arc", corpus::TightPlace::arc},
                                                        {"groove", corpus::TightPlace::groove}};

// Those that write a program of real length.
void define_long_programs(CommandLine& line, CLI::App* family) {
  constexpr std::size_t kMostContour = 100'000'000;
  const auto options = std::make_shared<LongProgramOptions>();
  const auto add = [&](const char* name, const char* about, int (*action)(const LongProgramOptions&)) {
    CLI::App* sub = line.verb(family, name, about, [options, action] { return action(*options); });
    take(sub, "--out", options->out, "FILE", "The program to write; its setup gets the same name, ending in .toml")
        ->required();
    return sub;
  };
  CLI::App* sub = add("contour", "Write a closed contour of short lines and arcs", corpus_contour);
  corpus::ContourOptions& contour = options->contour;
  take(sub, "--blocks", contour.blocks, "N", "Number of lines and arcs (default: 100000)", corpus::kLeastContour,
       kMostContour);
  take(sub, "--seed", contour.seed, "N", "Seed of every random choice");
  take(sub, "--arcs", contour.arcs, "N", "Arcs among 100 blocks (default: 40)", 0U, 100U);
  choose(sub, "--variant", contour.variant, kVariants, "pocket, island or tight (ends in PS0041)");
  choose(sub, "--place", contour.place, kPlaces, "tight: the place that raises PS0041, arc or groove");
  take(sub, "--at", contour.at, "N", "tight: block from which that place is looked for (default: the middle)");

  sub = add("flank", "Write the five-axis flank of a blade", corpus_flank);
  take(sub, "--blocks", options->flank.blocks, "N", "Number of blocks (default: 20000)", corpus::kLeastFlank,
       corpus::kMostFlank);
  choose(sub, "--tool", options->flank.tool, kTools, "The tool axis by B and C (rotary) or by I J K (vector)");

  sub = add("freeform", "Write LN blocks over a free-form surface", corpus_freeform);
  take(sub, "--blocks", options->freeform.blocks, "N", "Number of LN blocks (default: 500000)", corpus::kLeastFreeform,
       corpus::kMostFreeform);
  sub->add_flag("!--no-tool-vector", options->freeform.tool_vector, "No TX TY TZ: the tool stays along Z");
}

void define_corpus(CommandLine& line) {
  CLI::App* family = line.family(
      "corpus",
      "The golden corpus, hard cases, and makers of long programs\n"
      "The golden corpus holds cases with proven results. The hard cases are those that are hardest for doubles.");
  const auto options = std::make_shared<CorpusOptions>();
  const auto add = [&](const char* name, const char* about, int (*action)(const CorpusOptions&)) {
    return line.verb(family, name, about, [options, action] { return action(*options); });
  };
  const auto take_folder = [options](CLI::App* sub, const char* text) {
    take(sub, "--dir", options->directory, "FOLDER", text);
  };
  const char* const folder = "Folder of the corpus (default: corpus/golden of the source tree)";
  const auto take_seed = [options](CLI::App* sub) {
    take(sub, "--seed", options->seed, "N", "Seed of every random choice");
  };

  CLI::App* sub = add("generate", "Generate the corpus", corpus_generate);
  take_sections(sub, options->sections);
  take_folder(sub, "Folder of the corpus (default: corpus/golden of the source tree); with --shard, of the shards");
  take(sub, "--shard", options->shard, "I/N", "Generate only part I of N, for merge (1 <= I <= N)");
  take_seed(sub);

  sub = add("merge", "Combine the parts in a folder into the corpus", corpus_merge);
  take(sub, "shards", options->against, "FOLDER", "Folder of the shards")->required();
  take_folder(sub, folder);

  sub = add("check", "Test both engines, or a controller, with the corpus", corpus_check);
  take_sections(sub, options->sections);
  take_folder(sub, folder);
  take(sub, "--shard", options->shard, "I/N", "Only every N-th vector, from the I-th (1 <= I <= N)");
  take(sub, "--controller", options->controller, "CONTROLLER", "Judge this controller instead of both engines");

  sub = add("lint", "Check order, formatting, ids, digests, and for files that do not belong there", corpus_lint);
  take_folder(sub, folder);

  sub = add("diff", "Print what has changed since another corpus", corpus_diff);
  take(sub, "against", options->against, "FOLDER", "Folder of the other corpus")->required();
  take_folder(sub, folder);

  sub = add("proofs", "Write proofs of vectors, for Coq", corpus_proofs);
  take_sections(sub, options->sections);
  take_folder(sub, folder);
  take(sub, "--into", options->into, "FOLDER", "Folder for Coq's files")->required();
  take(sub, "--sample", options->sample, "N", "Number of vectors of each section, chosen by the seed; 0: all");
  take_seed(sub);
  sub->add_flag("--tell", options->only_tell, "Only have Coq tell which vectors it can compute");

  sub = add("hard", "Run the hard cases again", corpus_hard);
  take_sections(sub, options->sections);
  take_folder(sub, "Folder of the hard cases (default: corpus/hard of the source tree)");

  define_long_programs(line, family);
  family->footer(R"(Examples:
  The fast engine against some of the corpus:
    $ toolcomp corpus check --section fanuc/tool-offset --shard 1/10
  A program of a thousand blocks, with its setup:
    $ toolcomp corpus contour --blocks 1000 --out long.nc)");
}

void define_spec(CommandLine& line) {
  CLI::App* family = line.family(
      "spec",
      "The clauses, the keys and parameters of setups, and the alarms\n"
      "Prints the clauses, where each is implemented in the sources, and which of them the golden corpus exercises.");
  const auto options = std::make_shared<SpecOptions>();
  const auto add = [&](const char* name, const char* about, int (*action)(const SpecOptions&)) {
    CLI::App* sub = line.verb(family, name, about, [options, action] { return action(*options); });
    sub->add_flag("--json", options->json, "JSON instead of text");
    return sub;
  };
  add("list", "The clauses", spec_list);
  take(add("show", "Print a clause with its source", spec_show), "id", options->id, "CLAUSE", "The clause")->required();
  take(add("trace", "Where each clause is in the sources", spec_trace), "--dir", options->directory, "FOLDER",
       "Source tree (default: where it was built)");
  take(add("coverage", "Which clauses the golden corpus exercises", spec_coverage), "--dir", options->directory,
       "FOLDER", "Folder of the corpus (default: where it was built)");
  add("sections", "The sections", spec_sections);
  add("keys", "The keys of a setup", spec_keys);
  add("parameters", "The parameters of a setup", spec_parameters);
  add("alarms", "The alarms by cause, with their numbers", spec_alarms);
  family->footer(R"(Examples:
  Print a clause with its source:
    $ toolcomp spec show fanuc.cutter-b.mode
  The parameters that are known:
    $ toolcomp spec parameters)");
}

void define_config(CommandLine& line) {
  CLI::App* family = line.family(
      "config",
      "Setups and cases: an example, their schemas, and a check\n"
      "A setup describes what is not in the program: the control, its axes, parameters, offsets and tools. `toolcomp "
      "spec keys` and `toolcomp spec parameters` list what a setup may contain.");
  const auto value = std::make_shared<std::string>();
  CLI::App* sub = line.verb(family, "example",
                            "Print a commented setup; its first line names the schema for editors (docs/editors.md)",
                            [value] { return config_example(*value); });
  choose(sub, "--control", *value, {"fanuc", "heidenhain"}, "fanuc (default) or heidenhain");
  sub = line.verb(family, "schema", "Print a JSON Schema", [value] { return config_schema(*value); });
  choose(sub, "name", *value, {"setup", "case", "event", "hello", "answer", "finding", "manifest"},
         "setup (default), case, event, hello, answer, finding, or manifest of a bundle");
  sub =
      line.verb(family, "check", "Check whether a setup or a case is valid", [value] { return config_check(*value); });
  take(sub, "file", *value, "FILE", "The setup or case")->required();
  family->footer(R"(Examples:
  A setup to begin with:
    $ toolcomp config example --control heidenhain > heidenhain.toml
  Whether it is valid:
    $ toolcomp config check heidenhain.toml)");
}

}  // namespace

void define_reference(CommandLine& line) {
  define_corpus(line);
  define_spec(line);
  define_config(line);
}

}  // namespace toolcomp::cli
