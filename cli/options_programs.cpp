// SPDX-License-Identifier: Apache-2.0
// Verbs for one program: run, diff, explain, view, serve.
#include <map>
#include <memory>
#include <string>

#include "cli/command_line.h"
#include "cli/options.h"
#include "cli/verbs.h"

namespace toolcomp::cli {
namespace {

// Whether the second is the formal specification.
const std::map<std::string, bool> kPairs{{"model,fast", false}, {"model,spec", true}};
const std::map<std::string, EngineName> kEngines{
    {"model", EngineName::model}, {"fast", EngineName::fast}, {"spec", EngineName::specification}};
const std::map<std::string, Format> kFormats{{"jsonl", Format::jsonl},
                                             {"csv", Format::csv},
                                             {"gcode", Format::gcode},
                                             {"svg", Format::svg},
                                             {"html", Format::html}};
const std::map<std::string, bool> kOnOff{{"on", true}, {"off", false}};
constexpr int kMostDigits = 1000;

void define_run(CommandLine& line) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* sub = line.verb(
      "run",
      "Run a program and print its events\n"
      "Runs the program under the rules of its control and prints each event: moves, samples, alarms, settings. The "
      "model computes exactly and prints correctly rounded decimals; the fast engine computes in double.\n"
      "An alarm of the control is a result, not a failure. It is the last event. One line on standard error names its "
      "place, and the exit status is 0. If a word is not supported, or positions are not known after it, the run ends "
      "there with exit status 3. A line on standard error then says where, and how many blocks did not run.",
      [options] { return run(*options); });
  sub->footer(R"(Examples:
  Events as JSON, one a line:
    $ toolcomp run part.nc --setup setup.toml
  A table, twenty decimals:
    $ toolcomp run part.nc --format csv --digits 20 > part.csv
  A plain program for a simulator:
    $ toolcomp run part.nc --format gcode > plain.nc
  A page to step through:
    $ toolcomp run part.nc --format html > part.html)");
  take_program(sub, options->program, options->setup);
  choose(sub, "--engine", options->engine, kEngines, "model (exact), fast or spec (the formal specification, exact)");
  choose(sub, "--format", options->format, kFormats,
         "jsonl, csv, gcode (the ends of blocks; with --samples, also points inside blocks), svg or html (a page to "
         "step through)");
  take(sub, "--digits", options->digits, "N", "Decimals the model prints", 0, kMostDigits);
  choose(sub, "--notes", options->notes, kOnOff,
         "on (default) or off: give hints to the reader of the program, as events of kind note and on standard error; "
         "no verdict depends on them");
  take_samples(sub, options->samples);
}

void define_diff(CommandLine& line) {
  const auto options = std::make_shared<DiffOptions>();
  CLI::App* sub = line.verb(
      "diff",
      "Compare the model with the fast engine, and explain the first difference\n"
      "Runs the program in the exact model and in the fast engine and judges every value. The first difference is "
      "printed with its clause.",
      [options] { return diff(*options); });
  sub->footer(R"(Examples:
  Whether the engines agree on a program:
    $ toolcomp diff part.nc)");
  take_program(sub, options->program, options->setup);
  take_samples(sub, options->samples);
  choose(sub, "--engines", options->specification, kPairs,
         "model,fast (default), or model,spec for the formal specification instead of fast");
}

void define_explain(CommandLine& line) {
  const auto options = std::make_shared<ExplainOptions>();
  CLI::App* sub = line.verb("explain",
                            "Block by block: clauses, decisions, exact and double values\n"
                            "Prints for each block the clauses that applied, each decision and how close it was, with "
                            "exact and double values.",
                            [options] { return explain(*options); });
  sub->footer(R"(Examples:
  One block:
    $ toolcomp explain part.nc --block 5
  All of them:
    $ toolcomp explain part.nc > why.txt)");
  take_program(sub, options->program, options->setup);
  take(sub, "--block", options->block, "N", "Only the block with this sequence number, or on this line if none has it");
  take(sub, "--digits", options->digits, "N", "Decimals printed", 0, kMostDigits);
  take_samples(sub, options->samples);
}

void define_view(CommandLine& line) {
  constexpr int kLastPort = 65535;
  const auto options = std::make_shared<ViewOptions>();
  CLI::App* sub = line.verb(
      "view",
      "A page to step through a program: blocks, drawing, clauses and exact numbers\n"
      "The page has the blocks of the program, the drawing in space, and the clauses and exact numbers of the block "
      "under the cursor. It is one file and needs no network (docs/view.md).",
      [options] { return view(*options); });
  sub->footer(R"(Examples:
  A page beside the program:
    $ toolcomp view part.nc)");
  take_program(sub, options->program, options->setup);
  take(sub, "--out", options->out, "FILE",
       "Where to write the page (default: the program's name with .html, in this folder); - prints it");
  CLI::Option* const serve =
      sub->add_flag("--serve", options->serve,
                    "Serve the page on 127.0.0.1 instead, and reload it when the program or its setup changes");
  take(sub, "--port", options->port, "N", "Port of --serve; 0: any free port (default: 8600, or any free port)", 0,
       kLastPort)
      ->needs(serve);
  take_samples(sub, options->samples);
  take(sub, "--digits", options->digits, "N", "Decimals of exact numbers", 0, kMostDigits);
}

void define_serve(CommandLine& line) {
  const auto engine = std::make_shared<EngineName>(EngineName::fast);
  CLI::App* sub = line.verb("serve",
                            "Speak the controller protocol on standard input and output\n"
                            "Answers the controller protocol (docs/protocol.md): reads a JSON object from each line, "
                            "and answers with one line. "
                            "This is how our own engines are certified. It is also an example of a controller.",
                            [engine] { return serve(*engine); });
  sub->footer(R"(Examples:
  What it can do:
    $ echo '{"hello":1}' | toolcomp serve --engine fast)");
  choose(sub, "--engine", *engine, kEngines, "model, fast or spec (the formal specification)")->required();
}

}  // namespace

void define_programs(CommandLine& line) {
  define_run(line);
  define_diff(line);
  define_explain(line);
  define_view(line);
  define_serve(line);
}

}  // namespace toolcomp::cli
