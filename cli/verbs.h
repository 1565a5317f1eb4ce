// SPDX-License-Identifier: Apache-2.0
// The verbs of the toolcomp command: what each takes, already read from the command line. Each returns an exit status.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "corpus/contour.h"
#include "corpus/flank.h"
#include "corpus/freeform.h"

namespace toolcomp::cli {

// Exit status. Several causes at once: 4 before 2 before 1 before 3.
inline constexpr int kAgrees = 0;
inline constexpr int kDiffers = 1;
inline constexpr int kBadInput = 2;
inline constexpr int kUndecided = 3;
inline constexpr int kSelfCheckFailed = 4;

enum class EngineName : std::uint8_t { model, fast, specification };
enum class Format : std::uint8_t { jsonl, csv, gcode, svg, html };

struct RunOptions {
  std::string program;
  std::string setup;
  EngineName engine = EngineName::model;
  Format format = Format::jsonl;
  int digits = 15;
  std::optional<std::uint32_t> samples;  // instead of those of a case
  bool notes = true;
};
int run(const RunOptions& options);

struct DiffOptions {
  std::string program;
  std::string setup;
  std::optional<std::uint32_t> samples;
  bool specification = false;  // the formal specification against the model, instead of the fast engine
};
int diff(const DiffOptions& options);

struct ExplainOptions {
  std::string program;
  std::string setup;
  std::optional<std::uint64_t> block;
  int digits = 15;
  std::optional<std::uint32_t> samples;
};
int explain(const ExplainOptions& options);

struct ViewOptions {
  std::string program;
  std::string setup;
  std::string out;                       // empty: the program's name with .html; "-": standard output
  bool serve = false;                    // on 127.0.0.1, again whenever program or setup change
  std::optional<std::uint16_t> port;     // 0: any; without: the usual one, or any
  std::optional<std::uint32_t> samples;  // instead of those of a case
  int digits = 15;
};
int view(const ViewOptions& options);

struct CertifyOptions {
  std::string controller;
  std::string trace;
  std::vector<std::string> sections;
  std::vector<std::string> inputs;
  std::string setup;
  std::string report = "report";
  std::optional<std::uint32_t> cases;  // generated, a section
  std::string corpus;                  // folder of the golden corpus, to be judged besides cases named
  std::uint64_t seed = 1;
  double timeout = 10;
  std::string time_limit;      // "60s", "10m", "1h"
  std::string settle = "30s";  // the same, or "0"
  std::string tolerance;
  std::string rotary_tolerance;
  std::string frame = "workpiece";
  std::optional<std::string> known;      // "manual,sister"; none: all
  bool widths = false;                   // print how wide what the policy granted is
  std::string accept_resolution;         // a decimal
  std::optional<std::uint32_t> samples;  // of the cases and programs named
  std::vector<std::string> adapters;     // folders of adapters
  bool packages = false;                 // print those the adapter needs, and nothing else
  std::vector<std::string> altered;      // "PARAMETER=VALUE": told to the judge of a recorded controller alone
  std::string operated;                  // by whom, for the report
  std::string serial;                    // of the controller, for the report
  std::string arguments;                 // the command line as a shell reads it
  std::string evidence;                  // the file of the bundle; empty: none
  std::string sign;                      // the key of its signature; empty: none
  std::string badge;                     // the file of the badge; empty: none
  std::vector<std::string> words;        // of the command line
};
int certify(const CertifyOptions& options);

struct FuzzOptions {
  std::vector<std::string> sections;
  std::string duration;  // "60s", "10m", "1h"
  std::uint64_t runs = 0;
  unsigned jobs = 1;
  std::uint64_t seed = 1;
  std::string controller;
  std::string findings;  // folder; empty: "findings", of a campaign its own alone
  double timeout = 10;
  std::string accept_resolution;  // a decimal
  std::string campaign;           // its folder; empty: a temporary one
  std::vector<std::string> targets;
  std::vector<std::string> merge;  // folders of campaigns
  std::string shard;               // "I/N"
  bool built_in = false;           // without the clang targets
  bool no_specification = false;   // without the third voice
  bool json = false;
};
int fuzz(const FuzzOptions& options);

// What a campaign runs in processes of their own.
struct WorkerOptions {
  std::string target;
  std::string work;                 // its folder
  std::string corpus;               // what reaches something new goes there
  std::vector<std::string> inputs;  // folders of first inputs
  std::uint64_t seed = 1;
  std::uint64_t seconds = 0;
  std::uint64_t runs = 0;  // instead of seconds
  std::string controller;
  double timeout = 10;
};
int fuzz_worker(const WorkerOptions& options);
struct SpecificationWorkerOptions {
  std::string work;                  // its folder
  std::string corpus;                // of the campaign
  std::string asked;                 // file of the inputs it has had
  std::vector<std::string> targets;  // whose inputs
  std::uint64_t seed = 1;
  std::uint64_t seconds = 0;  // 0: what is kept
};
int fuzz_specification(const SpecificationWorkerOptions& options);
struct SettleOptions {
  std::string campaign;
  std::string file;  // the sighting
  std::string target;
  std::string as_seen;  // why it is not looked at again
  double timeout = 10;
};
int fuzz_settle(const SettleOptions& options);

struct ResultsOptions {
  std::vector<std::string> folders;  // each with a certificate.json
  std::string out;                   // the page; empty: results.html, and none with `json`
  bool json = false;
};
int results(const ResultsOptions& options);

struct VerifyOptions {
  std::string file;
  std::string corpus;  // folder of the golden corpus
  std::size_t sample = 100;
  std::optional<std::uint64_t> seed;  // without one, any
  bool all = false;
};
// 0 accepted, 1 refused.
int verify(const VerifyOptions& options);

struct ReplayOptions {
  std::string finding;
  std::string controller;
  bool yes = false;  // run the command that the finding names
  double timeout = 10;
};
int replay(const ReplayOptions& options);

// Each verb of `toolcomp corpus` takes some of them.
struct CorpusOptions {
  std::vector<std::string> sections;
  std::string directory;
  std::string shard;  // "I/N"
  std::string controller;
  std::string against;  // diff: the other corpus; merge: the shards
  std::uint64_t seed = 1;
  std::string into;        // proofs: a folder for Coq's files
  std::size_t sample = 0;  // proofs: so many vectors a section; 0: all
  bool only_tell = false;  // proofs: which vectors Coq can compute, instead of lemmas
};
int corpus_generate(const CorpusOptions& options);
int corpus_merge(const CorpusOptions& options);
int corpus_check(const CorpusOptions& options);
int corpus_lint(const CorpusOptions& options);
int corpus_diff(const CorpusOptions& options);
int corpus_proofs(const CorpusOptions& options);
int corpus_hard(const CorpusOptions& options);

struct LongProgramOptions {
  std::string out;  // the program; its setup stands beside it, ending in .toml
  corpus::ContourOptions contour;
  corpus::FlankOptions flank;
  corpus::FreeformOptions freeform;
};
int corpus_contour(const LongProgramOptions& options);
int corpus_flank(const LongProgramOptions& options);
int corpus_freeform(const LongProgramOptions& options);

struct SpecOptions {
  std::string id;         // show
  std::string directory;  // trace, coverage
  bool json = false;
};
int spec_list(const SpecOptions& options);
int spec_show(const SpecOptions& options);
int spec_trace(const SpecOptions& options);
int spec_coverage(const SpecOptions& options);
int spec_sections(const SpecOptions& options);
int spec_keys(const SpecOptions& options);
int spec_alarms(const SpecOptions& options);
int spec_parameters(const SpecOptions& options);

struct KitOptions {
  std::string folder;  // judge: the kit
  std::string setup;
  std::vector<std::string> sections;
  std::vector<std::string> travels;  // "X=-300,300"
  std::string out;
  std::string corpus;                 // folder of the golden corpus
  std::string controller;             // make: name of an adapter
  std::vector<std::string> adapters;  // make: folders of adapters
  std::uint32_t cases = 0;            // make: generated for this machine, besides
  std::uint64_t seed = 1;             // make: of these
  std::uint32_t first_offset = 1;
  std::vector<std::string> recordings;  // judge: files and folders
  std::string alarms;                   // judge: the form; without it, that of the kit
  std::string tolerance;
  bool rapids_by_axis = false;       // judge
  bool machine_coordinates = false;  // judge
  std::string report = "report";     // judge
};
int kit_make(const KitOptions& options);
int kit_judge(const KitOptions& options);

int serve(EngineName engine);

int config_example(const std::string& control);
// "setup", "case", "event", "hello", "answer"; empty: setup.
int config_schema(const std::string& name);
int config_check(const std::string& file);

}  // namespace toolcomp::cli
