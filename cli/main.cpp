// The toolcomp command: reads the command line, calls a verb, turns errors into exit statuses.
#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "cli/stop.h"
#include "cli/verbs.h"
#include "spec/language/case.h"
#include "spec/language/decimal.h"
#include "spec/language/edit_distance.h"
#include "spec/language/input_error.h"

namespace {

using namespace toolcomp;  // NOLINT(google-build-using-namespace): the top of the program

// A name of the map, given on as its number; CLI11's own check prints both.
template <class Value>
CLI::Validator one_of(const std::map<std::string, Value>& values) {
  std::string names;
  for (const auto& [name, value] : values) names += (names.empty() ? "" : ", ") + name;
  return {[&values, names](std::string& word) {
            const auto found = values.find(word);
            if (found == values.end()) return "\"" + word + "\" is none of " + names;
            word = std::to_string(static_cast<int>(found->second));
            return std::string();
          },
          names};
}

const std::map<std::string, cli::EngineName> kEngines{{"model", cli::EngineName::model},
                                                      {"fast", cli::EngineName::fast}};
// Whether the second is the formal specification.
const std::map<std::string, bool> kPairs{{"model,fast", false}, {"model,spec", true}};
const std::map<std::string, cli::EngineName> kServed{
    {"model", cli::EngineName::model}, {"fast", cli::EngineName::fast}, {"spec", cli::EngineName::specification}};
const std::map<std::string, cli::Format> kFormats{{"jsonl", cli::Format::jsonl},
                                                  {"csv", cli::Format::csv},
                                                  {"gcode", cli::Format::gcode},
                                                  {"svg", cli::Format::svg},
                                                  {"html", cli::Format::html}};
const std::map<std::string, corpus::ContourVariant> kVariants{{"pocket", corpus::ContourVariant::pocket},
                                                              {"island", corpus::ContourVariant::island},
                                                              {"tight", corpus::ContourVariant::tight}};
const std::map<std::string, corpus::FlankTool> kTools{{"rotary", corpus::FlankTool::rotary},
                                                      {"vector", corpus::FlankTool::vector}};
const std::map<std::string, corpus::TightPlace> kPlaces{{"arc", corpus::TightPlace::arc},
                                                        {"groove", corpus::TightPlace::groove}};

// One parser, one action: each verb adds its options and leaves the call to make in `action`.
class CommandLine {
 public:
  CommandLine()
      : app_(
            "An exact reference of CNC tool compensation, a fast engine certified against it, and the harness that "
            "certifies.\n"
            "Exit status: 0 agrees, 1 a difference was found, 2 bad usage or input, 3 could not be decided, 4 "
            "self-check failed.") {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", "toolcomp " TOOLCOMP_VERSION);
    add_run();
    add_diff();
    add_explain();
    add_certify();
    add_verify();
    add_fuzz();
    add_fuzz_worker();
    add_fuzz_specification();
    add_fuzz_settle();
    add_replay();
    add_kit();
    add_corpus();
    add_spec();
    add_serve();
    add_config();
  }

  int execute(int argc, char** argv) {
    if (argc > 1 && *argv[1] != '-') expect_verb(argv[1]);
    certify_.words.assign(argv, argv + argc);
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return app_.exit(error) == 0 ? cli::kAgrees : cli::kBadInput;
    }
    certify_.arguments = as_typed(argc, argv);
    return action_();
  }

 private:
  // The command line as a shell reads it.
  static std::string as_typed(int argc, char** argv) {
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+,-./:=@_";
    std::string line = "toolcomp";
    for (int i = 1; i < argc; ++i) {
      const std::string_view word = argv[i];
      line += ' ';
      if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) {
        line += word;
        continue;
      }
      line += '\'';
      for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
      line += '\'';
    }
    return line;
  }

  void expect_verb(const std::string& word) const {
    std::string nearest;
    std::string all;
    constexpr std::size_t kNear = 2;
    for (const CLI::App* sub : app_.get_subcommands({})) {
      const std::string& name = sub->get_name();
      if (name == word) return;
      if (sub->get_group().empty()) continue;
      all += (all.empty() ? "" : ", ") + name;
      if (spec::edit_distance(word, name) <= kNear &&
          (nearest.empty() || spec::edit_distance(word, name) < spec::edit_distance(word, nearest)))
        nearest = name;
    }
    throw spec::InputError(
        "toolcomp", 0, 0,
        "no verb \"" + word + "\"; " + (nearest.empty() ? "there are " + all : "did you mean " + nearest + "?"));
  }

  CLI::App* verb(const std::string& name, const std::string& about, std::function<int()> action) {
    CLI::App* sub = app_.add_subcommand(name, about);
    sub->callback([this, action = std::move(action)] { action_ = action; });
    return sub;
  }
  static void add_program(CLI::App* sub, std::string& program, std::string& setup) {
    sub->add_option("program", program, "Case (JSON) or program; - reads standard input")->required();
    sub->add_option("--setup", setup, "Setup (TOML or JSON); without it, setup.toml beside the program");
  }
  static void add_samples(CLI::App* sub, std::optional<std::uint32_t>& samples) {
    sub->add_option("--samples", samples,
                    "Parts into which each block under tool center point control is divided, with a sample between two")
        ->check(CLI::Range(0U, spec::kMostSamples));
  }
  static void add_jobs(CLI::App* sub, unsigned& jobs) {
    sub->add_option(
           "--jobs", jobs,
           "Processors for one large program (default: all; run --engine fast: one); what comes out is the same")
        ->check(CLI::Range(1, 256));
  }
  static void add_sections(CLI::App* sub, std::vector<std::string>& sections) {
    sub->add_option("--section", sections, "Section, e.g. fanuc/leading-edge-offset (repeatable; default: all)")
        ->allow_extra_args(false);
  }

  static void add_accept_resolution(CLI::App* sub, std::string& resolution) {
    sub->add_option("--accept-resolution", resolution,
                    "Controller: judge one that announces a resolution above 0.01 mm (0.0004 inch), up to this")
        ->check([](const std::string& text) {
          const auto value = spec::parse_decimal(text);
          return value && !value->negative && !value->is_zero() ? "" : "\"" + text + "\" is no positive decimal";
        });
  }

  void add_run() {
    CLI::App* sub = verb("run", "Run a program and print its events", [this] { return cli::run(run_); });
    add_program(sub, run_.program, run_.setup);
    sub->add_option("--engine", run_.engine, "model (exact) or fast")->transform(one_of(kEngines));
    sub->add_option(
           "--format", run_.format,
           "jsonl, csv, gcode (ends of blocks; with --samples, also inside), svg or html (a page to step through)")
        ->transform(one_of(kFormats));
    sub->add_option("--digits", run_.digits, "Decimals the model prints")->check(CLI::Range(0, 1000));
    add_samples(sub, run_.samples);
    add_jobs(sub, run_.jobs);
  }
  void add_diff() {
    CLI::App* sub =
        verb("diff", "Model against fast; the first difference explained", [this] { return cli::diff(diff_); });
    add_program(sub, diff_.program, diff_.setup);
    add_samples(sub, diff_.samples);
    add_jobs(sub, diff_.jobs);
    sub->add_option("--engines", diff_.specification,
                    "model,fast (default), or model,spec: the formal specification in its place")
        ->type_name("PAIR")
        ->transform(one_of(kPairs));
  }
  void add_explain() {
    CLI::App* sub = verb("explain", "Block by block: clauses, decisions, exact and double values",
                         [this] { return cli::explain(explain_); });
    add_program(sub, explain_.program, explain_.setup);
    sub->add_option("--block", explain_.block,
                    "Only the block with this sequence number, or on this line if none has it");
    sub->add_option("--digits", explain_.digits, "Decimals printed")->check(CLI::Range(0, 1000));
    add_samples(sub, explain_.samples);
  }
  void add_certify() {
    CLI::App* sub = verb("certify", "Certify a controller, or a recorded trace, and write a report",
                         [this] { return cli::certify(certify_); });
    sub->add_option(
        "inputs", certify_.inputs,
        "Cases, files of cases (.jsonl) and programs to judge; without them, the golden corpus and generated cases");
    sub->add_option("--controller", certify_.controller,
                    "Command that speaks the controller protocol, or the name of an adapter (docs/adapters.md)");
    sub->add_option("--adapters", certify_.adapters, "Folder of adapters, searched first (repeatable)")
        ->allow_extra_args(false);
    sub->add_flag("--packages", certify_.packages,
                  "Print the Debian packages that the adapter needs, and do nothing else");
    sub->add_option("--altered", certify_.altered,
                    "Adapter that records: PARAMETER=VALUE for the judge alone, which must then find a difference")
        ->allow_extra_args(false);
    sub->add_option("--trace", certify_.trace, "CSV of recorded axis positions of one run of one program");
    sub->add_option("--setup", certify_.setup, "Setup of the programs; without it, setup.toml beside each");
    add_sections(sub, certify_.sections);
    sub->add_option("--report", certify_.report, "Folder of the report");
    sub->add_option("--evidence", certify_.evidence,
                    "FILE.tar.zst: everything needed to repeat the certificate (docs/evidence.md); see verify");
    sub->add_option("--sign", certify_.sign, "Key of gpg that signs it: FILE.tar.zst.asc");
    sub->add_option("--cases", certify_.cases, "Generated cases a section (default: 1000, none with inputs)");
    sub->add_option("--corpus", certify_.corpus, "Folder of the golden corpus, to be judged besides the inputs");
    sub->add_option("--seed", certify_.seed, "Seed of every random choice");
    sub->add_option("--timeout", certify_.timeout, "Seconds a case may take")->check(CLI::PositiveNumber);
    sub->add_option("--time-limit", certify_.time_limit,
                    "60s, 10m, 1h: what is not judged by then is not run; the report says so");
    add_accept_resolution(sub, certify_.accept_resolution);
    sub->add_flag("--widths", certify_.widths, "Print how wide what the verdict policy grants is, section by section");
    sub->add_option("--tolerance", certify_.tolerance,
                    "Trace, adapter that records: greatest distance from the exact path, in the units of the events");
    sub->add_option("--rotary-tolerance", certify_.rotary_tolerance,
                    "Trace: the same of each rotary axis, in degrees (default: the number of --tolerance)");
    sub->add_option("--frame", certify_.frame,
                    "Trace: its coordinates, workpiece (default: the axes of the events) or machine")
        ->check(CLI::IsMember({"workpiece", "machine"}));
    sub->add_option("--operator", certify_.operated, "Who certifies, for the first page of the report");
    sub->add_option("--serial", certify_.serial, "Serial number of the controller, for the first page of the report");
    add_samples(sub, certify_.samples);
  }
  void add_verify() {
    CLI::App* sub = verb("verify", "Check the evidence of a certificate, and judge cases of it again",
                         [this] { return cli::verify(verify_); });
    sub->add_option("file", verify_.file, "The file that certify --evidence wrote")->required();
    sub->add_option("--sample", verify_.sample, "So many cases are judged again")->capture_default_str();
    sub->add_option("--seed", verify_.seed, "Seed of their choice (default: any)");
    sub->add_flag("--all", verify_.all, "All cases are judged again, and generated ones made again");
    sub->add_option("--corpus", verify_.corpus, "Folder of the golden corpus it rests on");
  }
  void add_fuzz() {
    CLI::App* sub = verb("fuzz", "Search for differences", [this] {
      return fuzz_.campaign.empty() && fuzz_.merge.empty() ? cli::fuzz(fuzz_) : cli::fuzz_campaign(fuzz_);
    });
    add_sections(sub, fuzz_.sections);
    sub->add_option(
        "--for", fuzz_.duration,
        "How long a section: 60s, 10m, 1h (default 60s without --runs); a campaign: in all (default: without end)");
    sub->add_option("--runs", fuzz_.runs, "Executions a section instead of a time");
    sub->add_option("--jobs", fuzz_.jobs, "Searches side by side")->check(CLI::Range(1, 256));
    sub->add_option("--seed", fuzz_.seed, "Seed of every random choice");
    sub->add_option("--controller", fuzz_.controller, "Judge this controller instead of the fast engine");
    sub->add_option("--findings", fuzz_.findings, "Folder for findings");
    add_accept_resolution(sub, fuzz_.accept_resolution);
    sub->add_option("--timeout", fuzz_.timeout, "Seconds a case may take the controller")->check(CLI::PositiveNumber);
    sub->add_option("--campaign", fuzz_.campaign,
                    "Folder of a campaign (docs/campaigns.md): corpus, findings, log, state; goes on where it stopped");
    sub->add_option("--target", fuzz_.targets, "Campaign: this target (repeatable), besides those of --section")
        ->allow_extra_args(false);
    sub->add_option("--shard", fuzz_.shard, "Campaign: I/N, with other seeds than the other shards");
    sub->add_option("--merge", fuzz_.merge, "Merge these campaigns into the new one of --campaign");
    sub->add_flag("--built-in", fuzz_.built_in, "Without the clang targets, where they are");
    sub->add_flag("--no-specification", fuzz_.no_specification,
                  "Campaign: without the formal specification as third voice");
    sub->add_flag("--json", fuzz_.json, "Campaign: the summary as JSON on standard output");
  }
  // For campaigns alone: not listed.
  void add_fuzz_worker() {
    CLI::App* sub = verb("fuzz-worker", "A worker of a campaign", [this] { return cli::fuzz_worker(worker_); });
    sub->group("");
    sub->add_option("--target", worker_.target)->required();
    sub->add_option("--work", worker_.work)->required();
    sub->add_option("--corpus", worker_.corpus)->required();
    sub->add_option("--inputs", worker_.inputs)->allow_extra_args(false);
    sub->add_option("--seed", worker_.seed);
    sub->add_option("--seconds", worker_.seconds);
    sub->add_option("--runs", worker_.runs);
    sub->add_option("--controller", worker_.controller);
    sub->add_option("--timeout", worker_.timeout);
  }
  void add_fuzz_specification() {
    CLI::App* sub =
        verb("fuzz-specification", "The third voice of a campaign", [this] { return cli::fuzz_specification(voice_); });
    sub->group("");
    sub->add_option("--target", voice_.targets)->allow_extra_args(false);
    sub->add_option("--work", voice_.work)->required();
    sub->add_option("--corpus", voice_.corpus)->required();
    sub->add_option("--asked", voice_.asked)->required();
    sub->add_option("--seed", voice_.seed);
    sub->add_option("--seconds", voice_.seconds);
  }
  void add_fuzz_settle() {
    CLI::App* sub = verb("fuzz-settle", "A sighting looked at", [this] { return cli::fuzz_settle(settle_); });
    sub->group("");
    sub->add_option("--campaign", settle_.campaign)->required();
    sub->add_option("--target", settle_.target)->required();
    sub->add_option("--as-seen", settle_.as_seen);
    sub->add_option("--timeout", settle_.timeout);
    sub->add_option("file", settle_.file)->required();
  }
  void add_replay() {
    CLI::App* sub = verb("replay", "Judge a finding again", [this] { return cli::replay(replay_); });
    sub->add_option("finding", replay_.finding, "Finding or case (JSON)")->required();
    sub->add_option("--controller", replay_.controller, "Judge this controller (default: the one of the finding)");
    sub->add_option("--timeout", replay_.timeout, "Seconds the case may take")->check(CLI::PositiveNumber);
  }
  void add_kit() {
    CLI::App* sub = verb("kit", "Programs, offsets and run sheet for a control without a pipe; its recordings judged",
                         [this] { return cli::kit(kit_); });
    sub->add_option("verb", kit_.verb, "make or judge")->required()->check(CLI::IsMember({"make", "judge"}));
    sub->add_option("folder", kit_.folder, "judge: folder of the kit");
    sub->add_option("recordings", kit_.recordings, "judge: CSV files, or folders of them");
    sub->add_option("--dialect", kit_.dialect, "make: fanuc or heidenhain, as the setup says")
        ->check(CLI::IsMember({"fanuc", "heidenhain"}));
    add_sections(sub, kit_.sections);
    sub->add_option("--sections", kit_.sections, "make: the same, with commas between")->delimiter(',');
    sub->add_option("--setup", kit_.setup, "make: setup of the machine; [position] is where programs begin and end");
    sub->add_option("--travel", kit_.travels, "make: AXIS=LEAST,GREATEST in machine coordinates, once for every axis");
    sub->add_option("--out", kit_.out, "make: folder of the kit, empty or not yet there");
    sub->add_option("--corpus", kit_.corpus, "make: folder of the golden corpus");
    sub->add_option("--controller", kit_.controller,
                    "make: adapter of the control (docs/adapters.md); what it cannot run stays at home");
    sub->add_option("--adapters", kit_.adapters, "make: folder of adapters, searched first (repeatable)");
    sub->add_option("--cases", kit_.cases,
                    "make, FANUC: so many programs made for this machine are candidates besides");
    sub->add_option("--seed", kit_.seed, "make: seed of these programs")->capture_default_str();
    sub->add_option("--first-offset", kit_.first_offset, "make: offset numbers from here on are overwritten")
        ->check(CLI::Range(1U, 999U));
    sub->add_option("--alarms", kit_.alarms, "judge: the alarm form, filled in (default: alarms.csv of the kit)");
    sub->add_option("--tolerance", kit_.tolerance,
                    "Greatest distance of a recording from the exact path: make: what moves a path by less is not "
                    "counted (default 0.05); judge: no more than that");
    sub->add_flag("--machine-coordinates", kit_.machine_coordinates,
                  "judge: recordings are of machine coordinates, not of those of G54");
    sub->add_flag(
        "--rapids-by-axis", kit_.rapids_by_axis,
        "judge: the control positions axis by axis: rapid moves are judged by their ends, and each axis between");
    sub->add_option("--report", kit_.report, "judge: folder of the certificate");
  }
  void add_corpus() {
    CLI::App* sub =
        verb("corpus",
             "The golden corpus: generate, merge, check, lint, diff, proofs; hard cases: mine, hard; long programs: "
             "contour, flank, freeform",
             [this] { return cli::corpus(corpus_); });
    sub->add_option("verb", corpus_.verb,
                    "generate, merge, check, lint, diff, proofs, mine, hard, contour, flank or freeform")
        ->required()
        ->check(CLI::IsMember(
            {"generate", "merge", "check", "lint", "diff", "proofs", "mine", "hard", "contour", "flank", "freeform"}));
    sub->add_option("against", corpus_.against, "diff: the folder of the other corpus; merge: that of the shards");
    add_sections(sub, corpus_.sections);
    sub->add_option("--dir", corpus_.directory,
                    "Folder of the corpus (default: corpus/golden of the source tree; hard: corpus/hard), or of the "
                    "shards (generate --shard)");
    sub->add_option(
        "--shard", corpus_.shard,
        "I/N: only every N-th vector, from the I-th (1 <= I <= N); generate: the share of one machine of N, for merge");
    sub->add_option("--controller", corpus_.controller, "check: judge this controller instead of both engines");
    sub->add_option("--seed", corpus_.seed, "Seed of every random choice");
    sub->add_option("--into", corpus_.into,
                    "proofs: folder for Coq's files; mine: folder of the hard cases; those there are where the search "
                    "begins");
    sub->add_option("--sample", corpus_.sample, "proofs: so many vectors of each section, by the seed; 0: all");
    sub->add_flag("--tell", corpus_.only_tell, "proofs: have Coq tell which vectors it can compute, instead of proofs");
    sub->add_option("--for", corpus_.duration, "mine: how long in all: 60s, 10m, 1h (default 10m without --runs)");
    sub->add_option("--runs", corpus_.runs, "mine: runs of the model a section instead of a time");
    sub->add_option("--jobs", corpus_.jobs, "mine: sections side by side")->check(CLI::Range(1, 256));
    sub->add_option("--findings", corpus_.findings, "mine: folder for cases on which the engines differ");
    sub->add_option("--out", corpus_.out,
                    "contour, flank, freeform: the program to write; its setup goes beside it, ending in .toml");
    sub->add_option("--blocks", corpus_.blocks,
                    "contour: how many lines and arcs (default: 100000); flank: how many blocks (default: 20000); "
                    "freeform: how many LN blocks (default: 500000)");
    sub->add_option("--tool", corpus_.tool, "flank: the tool axis by B and C (rotary) or by I J K (vector)")
        ->transform(one_of(kTools));
    sub->add_flag("--no-tool-vector", corpus_.no_tool_vector, "freeform: without TX TY TZ, the tool stays along Z");
    sub->add_option("--arcs", corpus_.contour.arcs, "contour: how many of 100 blocks are arcs (default: 40)")
        ->check(CLI::Range(0, 100));
    sub->add_option("--variant", corpus_.contour.variant, "contour: pocket, island or tight (ends in PS0041)")
        ->transform(one_of(kVariants));
    sub->add_option("--place", corpus_.contour.place, "contour, tight: the place that raises PS0041, arc or groove")
        ->transform(one_of(kPlaces));
    sub->add_option("--at", corpus_.contour.at,
                    "contour, tight: from which block on the place is (default: the middle)");
  }
  void add_spec() {
    CLI::App* sub = verb("spec", "The clauses: list, show, trace, coverage, sections; keys and parameters of setups",
                         [this] { return cli::spec(spec_); });
    sub->add_option("verb", spec_.verb, "list, show, trace, coverage, sections, keys or parameters")
        ->required()
        ->check(CLI::IsMember({"list", "show", "trace", "coverage", "sections", "keys", "parameters"}));
    sub->add_option("id", spec_.id, "show: the clause");
    sub->add_option("--dir", spec_.directory, "Source tree (trace) or corpus (coverage); default: where it was built");
    sub->add_flag("--json", spec_.json, "JSON instead of text");
  }
  void add_serve() {
    CLI::App* sub = verb("serve", "Speak the controller protocol on standard input and output",
                         [this] { return cli::serve(serve_); });
    sub->add_option("--engine", serve_, "model, fast or spec (the formal specification)")
        ->required()
        ->transform(one_of(kServed));
  }
  void add_config() {
    CLI::App* sub =
        verb("config", "Setups and cases: example, schema, check FILE", [this] { return cli::config(config_); });
    sub->add_option("verb", config_.verb, "example, schema or check")
        ->required()
        ->check(CLI::IsMember({"example", "schema", "check"}));
    sub->add_option("file", config_.file,
                    "check: the setup or case; schema: setup (default), case, event, hello or answer");
    sub->add_option("--control", config_.control, "fanuc or heidenhain")->check(CLI::IsMember({"fanuc", "heidenhain"}));
  }

  CLI::App app_;
  std::function<int()> action_;
  cli::RunOptions run_;
  cli::DiffOptions diff_;
  cli::ExplainOptions explain_;
  cli::CertifyOptions certify_;
  cli::VerifyOptions verify_;
  cli::FuzzOptions fuzz_;
  cli::SpecificationWorkerOptions voice_;
  cli::WorkerOptions worker_;
  cli::SettleOptions settle_;
  cli::ReplayOptions replay_;
  cli::KitOptions kit_;
  cli::CorpusOptions corpus_;
  cli::SpecOptions spec_;
  cli::EngineName serve_ = cli::EngineName::fast;
  cli::ConfigOptions config_;
};

}  // namespace

int main(int argc, char** argv) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) static_cast<void>(std::signal(signal, cli::on_signal));
  try {
    CommandLine command_line;
    return command_line.execute(argc, argv);
  } catch (const spec::InputError& error) {
    std::cout.flush();
    std::cerr << error.what() << '\n';
    return cli::kBadInput;
  } catch (const std::exception& error) {
    std::cout.flush();
    std::cerr << "toolcomp: internal error: " << error.what() << '\n';
    return cli::kSelfCheckFailed;
  }
}
