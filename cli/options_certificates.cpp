// SPDX-License-Identifier: Apache-2.0
// Verbs that judge a control: certify, results, verify, replay, kit.
#include <memory>

#include "cli/command_line.h"
#include "cli/options.h"
#include "cli/verbs.h"

namespace toolcomp::cli {
namespace {

void define_certify(CommandLine& line) {
  const auto options = std::make_shared<CertifyOptions>();
  CLI::App* sub = line.verb(
      "certify",
      "Certify a controller, or a recorded trace, and write a report\n"
      "Judges a controller against the exact model. The cases are the golden corpus and generated cases of each "
      "section, or the cases and programs that you name. The controller is a command that speaks the controller "
      "protocol, an adapter, or a recording of axis positions (--trace).\n"
      "The report is a folder with a page for people (index.html) and with findings for `toolcomp replay`.",
      [options, &line] {
        options->words = line.words();
        options->arguments = line.typed();
        return certify(*options);
      });
  sub->footer(R"(Examples:
  One section of the built-in fast engine:
    $ toolcomp certify --controller fast --section fanuc/tool-offset --cases 20
  A program of one's own, with evidence:
    $ toolcomp certify --controller 'toolcomp serve --engine fast' part.nc \
        --evidence part.tar.zst)");
  take(sub, "inputs", options->inputs, "FILE",
       "Cases, files of cases (.jsonl) and programs to judge; without them, the golden corpus and generated cases");
  take(sub, "--controller", options->controller, "CONTROLLER",
       "Command that speaks the controller protocol, or the name of an adapter "
       "(docs/adapters.md); fast: the fast engine in "
       "this process");
  take(sub, "--adapters", options->adapters, "FOLDER", "Folder of adapters, searched first (repeatable)");
  sub->add_flag("--packages", options->packages, "Only print the Debian packages that the adapter needs");
  take(sub, "--altered", options->altered, "PARAMETER=VALUE",
       "For an adapter that records: change this parameter for the judge only, to test that the judge finds the "
       "difference");
  take(sub, "--trace", options->trace, "FILE", "CSV of recorded axis positions of one run of one program");
  take(sub, "--setup", options->setup, "SETUP", "Setup of the programs; without it, setup.toml beside each program");
  take_sections(sub, options->sections);
  take(sub, "--report", options->report, "FOLDER", "Folder of the report");
  take(sub, "--evidence", options->evidence, "FILE",
       "Write everything needed to repeat the certificate into FILE.tar.zst (docs/evidence.md); `toolcomp verify` "
       "checks it");
  take(sub, "--badge", options->badge, "FILE",
       "Write a badge for shields.io (JSON of an endpoint): the sections that conform, or the number of findings");
  take(sub, "--sign", options->sign, "KEY",
       "Sign the evidence with this gpg key, and write the signature to FILE.tar.zst.asc");
  take(sub, "--cases", options->cases, "N",
       "Generated cases in each section (default: 1000, and 0 if inputs are named)");
  take(sub, "--corpus", options->corpus, "FOLDER",
       "Folder of the golden corpus (default: toolcomp's own); if inputs are named, judge it too");
  take(sub, "--seed", options->seed, "N", "Seed of every random choice");
  take_timeout(sub, options->timeout, "Seconds that a case may take");
  take(sub, "--time-limit", options->time_limit, "TIME",
       "Stop after 60s, 10m or 1h; the report says which cases were not run");
  take(sub, "--settle", options->settle, "TIME",
       "Time (30s, 5m or 0) to reproduce and shorten one finding of each group; the report says which findings "
       "were not settled")
      ->capture_default_str();
  take_accept_resolution(sub, options->accept_resolution);
  take(sub, "--known", options->known, "KINDS",
       "manual,sister,recollection,ours: judge only by clauses that are known in one of these ways (default: all)");
  sub->add_flag("--widths", options->widths, "Print the tolerances of the verdicts, section by section");
  take(sub, "--tolerance", options->tolerance, "LENGTH",
       "For a trace or an adapter that records: largest distance from the exact path, in the units of the events");
  take(sub, "--rotary-tolerance", options->rotary_tolerance, "DEGREES",
       "For a trace: largest deviation of each rotary axis, in degrees (default: the number of --tolerance)");
  choose(sub, "--frame", options->frame, {"workpiece", "machine"},
         "For a trace: its coordinates, workpiece (default) or machine");
  take(sub, "--operator", options->operated, "NAME",
       "Name of the person who certifies, for the first page of the report");
  take(sub, "--serial", options->serial, "TEXT", "Serial number of the controller, for the first page of the report");
  take_samples(sub, options->samples);
}

void define_results(CommandLine& line) {
  const auto options = std::make_shared<ResultsOptions>();
  CLI::App* sub = line.verb(
      "results",
      "One table of the certificates of several controllers\n"
      "Reads the certificate.json of each folder, as `certify --report` writes it, and makes a page of them: the "
      "sections of the manuals, and what each controller does there: conforms, differs by design, has findings, was "
      "judged in part, or was not asked. Each place leads to the clauses.\n"
      "A certificate is believed as it stands: `toolcomp verify` checks the evidence of one.",
      [options] { return results(*options); });
  sub->footer(R"(Examples:
  Two sections of the built-in fast engine, and a page of them:
    $ toolcomp certify --controller fast --section fanuc/tool-offset \
        --section fanuc/tool-length-offset --cases 20 --report fast
    $ toolcomp results fast --out results.html)");
  take(sub, "folders", options->folders, "FOLDER", "Folders that certify --report wrote, one for each controller")
      ->required();
  take(sub, "--out", options->out, "FILE", "The page (default: results.html)");
  sub->add_flag("--json", options->json, "The table as JSON on standard output; then there is a page with --out alone");
}

void define_verify(CommandLine& line) {
  const auto options = std::make_shared<VerifyOptions>();
  CLI::App* sub = line.verb(
      "verify",
      "Check the evidence of a certificate, and judge some of its cases again\n"
      "Checks that a bundle of evidence is complete and agrees with its certificate. Then judges cases of the bundle "
      "again: a random sample, or all of them.",
      [options] { return verify(*options); });
  sub->footer(R"(Examples:
  A certificate of one program, with its evidence:
    $ toolcomp certify --controller 'toolcomp serve --engine fast' part.nc \
        --evidence part.tar.zst
  Whether it is what it says:
    $ toolcomp verify part.tar.zst)");
  take(sub, "file", options->file, "FILE", "The file that certify --evidence wrote")->required();
  take(sub, "--sample", options->sample, "N", "Number of cases to judge again")->capture_default_str();
  take(sub, "--seed", options->seed, "N", "Seed of the sample (default: random)");
  sub->add_flag("--all", options->all, "Judge all cases again, and generate the generated ones again");
  take(sub, "--corpus", options->corpus, "FOLDER", "Folder of the golden corpus that the certificate used");
}

void define_replay(CommandLine& line) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* sub = line.verb(
      "replay",
      "Judge a finding again\n"
      "Asks the controller of a finding again, and judges the answer. The command first shows the controller's command "
      "and folder that the finding names, and runs them only after you confirm, at the terminal or with --yes. Any "
      "case "
      "can be replayed.",
      [options] { return replay(*options); });
  sub->footer(R"(Examples:
  A case of one's own:
    $ toolcomp replay case.json)");
  take(sub, "finding", options->finding, "FILE", "Finding or case (JSON)")->required();
  take(sub, "--controller", options->controller, "CONTROLLER",
       "Judge this controller (default: the one of the finding)");
  sub->add_flag("--yes,-y", options->yes, "Run the command that the finding names without asking");
  take_timeout(sub, options->timeout, "Seconds that the case may take");
}

void define_kit_make(CommandLine& line, CLI::App* kit) {
  const auto options = std::make_shared<KitOptions>();
  CLI::App* sub = line.verb(kit, "make", "Write programs, offsets and a run sheet for the machine of a setup",
                            [options] { return kit_make(*options); });
  take_sections(sub, options->sections);
  take(sub, "--setup", options->setup, "SETUP", "Setup of the machine; [position] is where programs begin and end")
      ->required();
  take(sub, "--travel", options->travels, "AXIS=LEAST,GREATEST",
       "Travel of an axis in machine coordinates; give it once for every axis");
  take(sub, "--out", options->out, "FOLDER", "Folder of the kit, empty or not yet there")->required();
  take(sub, "--corpus", options->corpus, "FOLDER", "Folder of the golden corpus");
  take(sub, "--controller", options->controller, "ADAPTER",
       "Adapter of the control (docs/adapters.md); programs that it cannot run are left out");
  take(sub, "--adapters", options->adapters, "FOLDER", "Folder of adapters, searched first (repeatable)");
  take(sub, "--cases", options->cases, "N",
       "FANUC: number of programs that are generated for this machine as further candidates");
  take(sub, "--seed", options->seed, "N", "Seed of these programs")->capture_default_str();
  take(sub, "--first-offset", options->first_offset, "N", "First offset number that the kit may overwrite", 1U, 999U);
  take(sub, "--tolerance", options->tolerance, "LENGTH",
       "Tolerance of the recordings; a smaller change of the path does not count as shown (default: 0.05)");
}

void define_kit_judge(CommandLine& line, CLI::App* kit) {
  const auto options = std::make_shared<KitOptions>();
  CLI::App* sub = line.verb(kit, "judge", "Judge the recordings of these runs, and write a certificate",
                            [options] { return kit_judge(*options); });
  take(sub, "folder", options->folder, "FOLDER", "Folder of the kit")->required();
  take(sub, "recordings", options->recordings, "FILE", "CSV files, or folders of them");
  take(sub, "--alarms", options->alarms, "FILE", "The alarm form, filled in (default: alarms.csv of the kit)");
  take(sub, "--tolerance", options->tolerance, "LENGTH",
       "Largest distance of a recording from the exact path, at most that of the kit");
  sub->add_flag("--machine-coordinates", options->machine_coordinates,
                "The recordings are in machine coordinates, not in those of G54");
  sub->add_flag("--rapids-by-axis", options->rapids_by_axis,
                "The control positions axis by axis: judge the ends of rapid moves, and each axis in between");
  take(sub, "--report", options->report, "FOLDER", "Folder of the certificate");
}

void define_kit(CommandLine& line) {
  CLI::App* kit =
      line.family("kit",
                  "Programs, offsets and a run sheet for a control on a shop floor, and a judge for its recordings\n"
                  "For a control that no command can drive, but that can record its axes (docs/kits.md).");
  define_kit_make(line, kit);
  define_kit_judge(line, kit);
  kit->footer(R"(Examples:
  The setup of the machine, to be edited:
    $ toolcomp config example > machine.toml
  A kit for it:
    $ toolcomp kit make --setup machine.toml --section fanuc/tool-length-offset \
        --travel X=-500,500 --travel Y=-500,500 --travel Z=-300,300 \
        --travel B=-120,120 --travel C=-360,360 --out kit)");
}

}  // namespace

void define_certificates(CommandLine& line) {
  define_certify(line);
  define_results(line);
  define_verify(line);
  define_replay(line);
  define_kit(line);
}

}  // namespace toolcomp::cli
