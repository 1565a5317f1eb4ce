// SPDX-License-Identifier: Apache-2.0
#include "cli/manual_texts.h"

#include <algorithm>

namespace toolcomp::cli {
namespace {

const NamedText kSetupFile{"setup.toml",
                           "Beside a program: its setup, where --setup names none. See toolcomp-setup(5)."};

const std::vector<ManualText>& texts() {
  static const std::vector<ManualText> all{
      {"",
       {"toolcomp says what a numerical control makes of a program under tool compensation, exactly and block by "
        "block, "
        "by the rules of its manual; and it judges controls against that.",
        "Standard output carries data, standard error progress and diagnostics. What is wrong with an input is one "
        "line "
        "FILE:LINE:COLUMN: and what was expected; lines and columns count from 1, columns in characters."},
       {{"A setup to begin with:", "toolcomp config example > setup.toml"},
        {"What a program comes to:", "toolcomp run part.nc --setup setup.toml"},
        {"What the rules are:", "toolcomp spec sections"}},
       {kSetupFile,
        {"/usr/share/toolcomp", "Golden corpus, adapters, schemas and files for editors of an installed command."}},
       {}},
      {"run",
       {"Runs the program under the rules of its control and prints each event: moves, samples, alarms, settings. The "
        "model computes exactly and prints correctly rounded decimals; the fast engine computes in double.",
        "An alarm of the control is a result, not a failure: it is the last event, with one line on standard error "
        "that names its place, and the exit status is 0."},
       {{"Events as JSON, one a line:", "toolcomp run part.nc --setup setup.toml"},
        {"A table, twenty decimals:", "toolcomp run part.nc --format csv --digits 20 > part.csv"},
        {"A plain program for a simulator:", "toolcomp run part.nc --format gcode > plain.nc"},
        {"A page to step through:", "toolcomp run part.nc --format html > part.html"}},
       {kSetupFile},
       {"explain", "diff"}},
      {"diff",
       {"Runs the program in the exact model and in the fast engine and judges every value. The first difference is "
        "printed with its clause."},
       {{"Whether the engines agree on a program:", "toolcomp diff part.nc"}},
       {kSetupFile},
       {"explain", "certify"}},
      {"explain",
       {"Says block by block which clauses acted, what was decided and how near each decision was, with exact and "
        "double values."},
       {{"One block:", "toolcomp explain part.nc --block 5"}, {"All of them:", "toolcomp explain part.nc > why.txt"}},
       {kSetupFile},
       {"run", "spec"}},
      {"view",
       {"Writes one page to step through a program: its blocks, the drawing in space, and the clauses and exact "
        "numbers of "
        "the block under the cursor. It needs nothing beside it and no network. --serve shows it on 127.0.0.1 and "
        "makes "
        "it anew whenever program or setup change (docs/view.md)."},
       {{"A page beside the program:", "toolcomp view part.nc"}},
       {kSetupFile},
       {"run", "explain"}},
      {"serve",
       {"Answers the controller protocol (docs/protocol.md): a JSON object a line in, an answer a line out. It is how "
        "our own engines are certified, and an example of a controller."},
       {{"What it can do:", "echo '{\"hello\":1}' | toolcomp serve --engine fast"}},
       {},
       {"certify"}},
      {"certify",
       {"Judges a controller against the exact model: the golden corpus and generated cases of each section, or the "
        "cases and programs named. The controller is a command that speaks the protocol, an adapter, or a recording "
        "of axis positions (--trace).",
        "The report is a folder with index.html for people and findings for toolcomp-replay(1)."},
       {{"One section of the built-in fast engine:",
         "toolcomp certify --controller 'toolcomp serve --engine fast' --section fanuc/tool-offset --cases 20"},
        {"A program of one's own, with evidence:",
         "toolcomp certify --controller 'toolcomp serve --engine fast' part.nc --evidence part.tar.zst"}},
       {{"report/index.html", "The certificate."},
        {"report/findings", "Cases on which the controller differs, for toolcomp-replay(1)."},
        kSetupFile},
       {"verify", "replay", "kit", "fuzz"}},
      {"verify",
       {"Checks that a bundle of evidence is whole and says what its certificate says, and judges cases of it again: a "
        "sample of any seed, or all."},
       {{"A certificate of one program, with its evidence:",
         "toolcomp certify --controller 'toolcomp serve --engine fast' part.nc --evidence part.tar.zst"},
        {"Whether it is what it says:", "toolcomp verify part.tar.zst"}},
       {},
       {"certify"}},
      {"replay",
       {"Asks the controller of a finding once more, and judges the answer. A finding is a case: any case can be "
        "replayed."},
       {{"A case of one's own:", "toolcomp replay case.json"}},
       {},
       {"certify", "fuzz"}},
      {"kit",
       {"For a control that nobody can pipe cases into. make writes programs, offsets and a run sheet for the machine "
        "of "
        "a setup; judge takes the recordings of these runs and writes a certificate."},
       {{"The setup of the machine, to be edited:", "toolcomp config example > machine.toml"},
        {"A kit for it:",
         "toolcomp kit make --setup machine.toml --sections fanuc/tool-length-offset --travel X=-500,500 --travel "
         "Y=-500,500 --travel Z=-300,300 --travel B=-120,120 --travel C=-360,360 --out kit"}},
       {{"kit/kit.json", "What the kit holds, for kit judge."}},
       {"certify"}},
      {"fuzz",
       {"Searches for programs on which two engines, or a controller and the model, differ. Every finding is shrunk "
        "and kept in a folder of its own. --campaign keeps everything in a folder and goes on where it stopped "
        "(docs/campaigns.md)."},
       {{"One section, for a hundred programs:",
         "toolcomp fuzz --section fanuc/tool-offset --runs 100 --seed 1 --built-in"}},
       {{"findings/NAME/finding.json", "A finding, for toolcomp-replay(1)."}},
       {"replay", "certify"}},
      {"corpus",
       {"The golden corpus: cases with proven results. check judges the engines or a controller by it; generate makes "
        "it "
        "anew; diff says what changed. mine and hard are about the cases that are hardest for doubles; contour, flank "
        "and "
        "freeform write programs of real length."},
       {{"The fast engine against some of the corpus:",
         "toolcomp corpus check --section fanuc/tool-offset --shard 1/10"},
        {"A program of a thousand blocks, with its setup:", "toolcomp corpus contour --blocks 1000 --out long.nc"}},
       {},
       {"certify", "spec"}},
      {"spec",
       {"Prints the clauses the rules are made of, where each is found in the sources, and what the golden corpus "
        "exercises of them; and the keys and parameters that a setup may have."},
       {{"A clause with its source:", "toolcomp spec show fanuc.cutter-b.mode"},
        {"The parameters that are known:", "toolcomp spec parameters"}},
       {},
       {"explain", "config"}},
      {"config",
       {"example prints a commented setup, schema a JSON Schema, check reads a setup or a case and says whether it is "
        "valid. The first line of the example names the schema for editors (docs/editors.md)."},
       {{"A setup to begin with:", "toolcomp config example --control heidenhain > heidenhain.toml"},
        {"Whether it is valid:", "toolcomp config check heidenhain.toml"}},
       {kSetupFile},
       {"run", "spec"}},
      {"completion",
       {"Prints a script that completes verbs, options, their values, sections, clauses, adapters and files. An "
        "installed command has its scripts where shells look for them."},
       {{"For this shell:", "toolcomp completion bash > completion.bash && . ./completion.bash"}},
       {},
       {}},
  };
  return all;
}

}  // namespace

const ManualText& manual_text(std::string_view verb) {
  static const ManualText none{};
  const auto found = std::ranges::find(texts(), verb, &ManualText::verb);
  return found == texts().end() ? none : *found;
}

const std::vector<NamedText>& environment_texts() {
  static const std::vector<NamedText> all{
      {"NO_COLOR", "If it is set and not empty, output has no colors."},
      {"CLICOLOR_FORCE", "If it is set and not 0, output has colors also where it is no terminal."},
      {"CLICOLOR", "If it is 0, output has no colors."},
      {"COLUMNS", "How wide output is; else the terminal is asked."},
      {"TERM", "On a terminal called dumb there is no progress and no color."},
      {"TOOLCOMP_ADAPTERS", "Folders of adapters, parted by colons, searched before the installed ones."},
      {"SOURCE_DATE_EPOCH", "Seconds since 1970: the date in reports, for bytes that repeat."},
  };
  return all;
}

}  // namespace toolcomp::cli
