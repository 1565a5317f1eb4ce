// SPDX-License-Identifier: Apache-2.0
// Verbs that judge a control: certify, verify, replay, kit.
#include <memory>

#include "cli/command_line.h"
#include "cli/options.h"
#include "cli/verbs.h"

namespace toolcomp::cli {
namespace {

void define_certify(CommandLine& line) {
  const auto options = std::make_shared<CertifyOptions>();
  CLI::App* sub =
      line.verb("certify", "Certify a controller, or a recorded trace, and write a report", [options, &line] {
        options->words = line.words();
        options->arguments = line.typed();
        return certify(*options);
      });
  take(sub, "inputs", options->inputs, "FILE",
       "Cases, files of cases (.jsonl) and programs to judge; without them, the golden corpus and generated cases");
  take(sub, "--controller", options->controller, "CONTROLLER",
       "Command that speaks the controller protocol, or the name of an adapter "
       "(docs/adapters.md); fast: the fast engine in "
       "this process");
  take(sub, "--adapters", options->adapters, "FOLDER", "Folder of adapters, searched first (repeatable)");
  sub->add_flag("--packages", options->packages,
                "Print the Debian packages that the adapter needs, and do nothing else");
  take(sub, "--altered", options->altered, "PARAMETER=VALUE",
       "Adapter that records: PARAMETER=VALUE for the judge alone, which must then find a difference");
  take(sub, "--trace", options->trace, "FILE", "CSV of recorded axis positions of one run of one program");
  take(sub, "--setup", options->setup, "SETUP", "Setup of the programs; without it, setup.toml beside each");
  take_sections(sub, options->sections);
  take(sub, "--report", options->report, "FOLDER", "Folder of the report");
  take(sub, "--evidence", options->evidence, "FILE",
       "FILE.tar.zst: everything needed to repeat the certificate (docs/evidence.md); see verify");
  take(sub, "--sign", options->sign, "KEY", "Key of gpg that signs it: FILE.tar.zst.asc");
  take(sub, "--cases", options->cases, "N", "Generated cases a section (default: 1000, none with inputs)");
  take(sub, "--corpus", options->corpus, "FOLDER", "Folder of the golden corpus, to be judged besides the inputs");
  take(sub, "--seed", options->seed, "N", "Seed of every random choice");
  take_timeout(sub, options->timeout, "Seconds a case may take");
  take(sub, "--time-limit", options->time_limit, "TIME",
       "60s, 10m, 1h: what is not judged by then is not run; the report says so");
  take_accept_resolution(sub, options->accept_resolution);
  sub->add_flag("--widths", options->widths, "Print how wide what the verdict policy grants is, section by section");
  take(sub, "--tolerance", options->tolerance, "LENGTH",
       "Trace, adapter that records: greatest distance from the exact path, in the units of the events");
  take(sub, "--rotary-tolerance", options->rotary_tolerance, "DEGREES",
       "Trace: the same of each rotary axis, in degrees (default: the number of --tolerance)");
  choose(sub, "--frame", options->frame, {"workpiece", "machine"},
         "Trace: its coordinates, workpiece (default: the axes of the events) or machine");
  take(sub, "--operator", options->operated, "NAME", "Who certifies, for the first page of the report");
  take(sub, "--serial", options->serial, "TEXT", "Serial number of the controller, for the first page of the report");
  take_samples(sub, options->samples);
}

void define_verify(CommandLine& line) {
  const auto options = std::make_shared<VerifyOptions>();
  CLI::App* sub = line.verb("verify", "Check the evidence of a certificate, and judge cases of it again",
                            [options] { return verify(*options); });
  take(sub, "file", options->file, "FILE", "The file that certify --evidence wrote")->required();
  take(sub, "--sample", options->sample, "N", "So many cases are judged again")->capture_default_str();
  take(sub, "--seed", options->seed, "N", "Seed of their choice (default: any)");
  sub->add_flag("--all", options->all, "All cases are judged again, and generated ones made again");
  take(sub, "--corpus", options->corpus, "FOLDER", "Folder of the golden corpus it rests on");
}

void define_replay(CommandLine& line) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* sub = line.verb("replay", "Judge a finding again", [options] { return replay(*options); });
  take(sub, "finding", options->finding, "FILE", "Finding or case (JSON)")->required();
  take(sub, "--controller", options->controller, "CONTROLLER",
       "Judge this controller (default: the one of the finding)");
  take_timeout(sub, options->timeout, "Seconds the case may take");
}

void define_kit(CommandLine& line) {
  const auto options = std::make_shared<KitOptions>();
  CLI::App* sub =
      line.verb("kit", "Programs, offsets and run sheet for a control without a pipe; its recordings judged",
                [options] { return kit(*options); });
  choose(sub, "verb", options->verb, {"make", "judge"}, "make or judge")->required();
  take(sub, "folder", options->folder, "FOLDER", "judge: folder of the kit");
  take(sub, "recordings", options->recordings, "FILE", "judge: CSV files, or folders of them");
  choose(sub, "--dialect", options->dialect, {"fanuc", "heidenhain"}, "make: fanuc or heidenhain, as the setup says");
  take_sections(sub, options->sections);
  take(sub, "--sections", options->sections, "SECTION,…", "make: the same, with commas between")->delimiter(',');
  take(sub, "--setup", options->setup, "SETUP",
       "make: setup of the machine; [position] is where programs begin and end");
  take(sub, "--travel", options->travels, "AXIS=LEAST,GREATEST",
       "make: AXIS=LEAST,GREATEST in machine coordinates, once for every axis");
  take(sub, "--out", options->out, "FOLDER", "make: folder of the kit, empty or not yet there");
  take(sub, "--corpus", options->corpus, "FOLDER", "make: folder of the golden corpus");
  take(sub, "--controller", options->controller, "ADAPTER",
       "make: adapter of the control (docs/adapters.md); what it cannot run stays at home");
  take(sub, "--adapters", options->adapters, "FOLDER", "make: folder of adapters, searched first (repeatable)");
  take(sub, "--cases", options->cases, "N",
       "make, FANUC: so many programs made for this machine are candidates besides");
  take(sub, "--seed", options->seed, "N", "make: seed of these programs")->capture_default_str();
  take(sub, "--first-offset", options->first_offset, "N", "make: offset numbers from here on are overwritten", 1U,
       999U);
  take(sub, "--alarms", options->alarms, "FILE", "judge: the alarm form, filled in (default: alarms.csv of the kit)");
  take(sub, "--tolerance", options->tolerance, "LENGTH",
       "Greatest distance of a recording from the exact path: make: what moves a path by less is not counted (default "
       "0.05); judge: no more than that");
  sub->add_flag("--machine-coordinates", options->machine_coordinates,
                "judge: recordings are of machine coordinates, not of those of G54");
  sub->add_flag(
      "--rapids-by-axis", options->rapids_by_axis,
      "judge: the control positions axis by axis: rapid moves are judged by their ends, and each axis between");
  take(sub, "--report", options->report, "FOLDER", "judge: folder of the certificate");
}

}  // namespace

void define_certificates(CommandLine& line) {
  define_certify(line);
  define_verify(line);
  define_replay(line);
  define_kit(line);
}

}  // namespace toolcomp::cli
