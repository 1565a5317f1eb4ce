// SPDX-License-Identifier: Apache-2.0
#include "corpus/generate.h"

#include <algorithm>
#include <map>

#include "corpus/diff.h"
#include "corpus/examples.h"
#include "corpus/select.h"
#include "corpus/vector.h"
#include "fuzz/gen/generator.h"
#include "host/file_writer.h"
#include "host/sha256.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;

using Chosen = std::function<std::vector<spec::Case>(std::string_view section)>;

class Writer {
 public:
  Writer(const GenerateOptions& options, const Chosen& chosen) : options_(options), chosen_(chosen) {}

  GenerateResult run() {
    read_old();
    for (const std::string_view section : fuzz::sections()) {
      if (!wants(options_, section)) continue;
      for (const ExampleFile& file : example_files())
        if (file.section == section) write(std::string(section), std::string(file.name), by_hand(file));
      write(std::string(section), "generated", chosen_(section));
    }
    if (result_.rejected.empty()) finish();
    return std::move(result_);
  }

 private:
  // What is there before: files of sections that are not wanted stay.
  void read_old() {
    expect_sections(options_.sections);
    if (!fs::exists(options_.folder / "manifest.json")) return;
    old_manifest_ = read_manifest(options_.folder);
    has_old_ = true;
    for (const ManifestFile& file : old_manifest_.files)
      if (!wants(options_, file.section)) files_[file.file] = file;
    // A corpus of another clause set may not be readable: then everything in it counts as changed.
    try {
      old_ = read_golden(options_.folder);
    } catch (const spec::InputError&) {
      old_readable_ = false;
    }
  }

  static std::vector<spec::Case> by_hand(const ExampleFile& file) {
    std::vector<spec::Case> cases;
    for (const Example& example : file.examples) {
      spec::Case c;
      c.section = file.section;
      c.comment = example.comment;
      c.setup = spec::read_setup_toml(example.setup, "setup of: " + std::string(example.comment));
      // Few are about F, without which a cutting move is an alarm.
      if (c.setup.control == spec::Control::fanuc) c.setup.parameters.try_emplace({1411, -1}, spec::decimal(100));
      c.dialect = spec::dialect_of(c.setup.control);
      c.program = example.program;
      c.samples = example.samples;
      c.source.generator = "by hand";
      complete(c);  // what cannot be completed is refused when it is read again
      cases.push_back(std::move(c));
    }
    return cases;
  }

  // Written beside, read again, run again, then moved into place.
  void write(const std::string& section, const std::string& name, const std::vector<spec::Case>& cases) {
    std::string text;
    for (const spec::Case& c : cases) text += spec::write_case_line(c) + '\n';
    const std::string file = section + '/' + name + ".jsonl";
    const fs::path path = options_.folder / file;
    fs::path refused = path;
    refused += ".rej";
    host::write_file(refused, text);
    const std::size_t before = result_.rejected.size();
    std::size_t line = 0;
    for (const spec::Case& c : read_again(refused, cases.size(), file)) {
      ++line;
      std::string wrong = verify(c, judge::try_case(c));
      if (wrong.empty() && c.id != vector_id(c)) wrong = "the id does not belong to this vector";
      if (!wrong.empty()) result_.rejected.push_back({file, line, wrong});
    }
    if (result_.rejected.size() != before) return;
    fs::rename(refused, path);
    files_[file] = {file, section, cases.size(), host::sha256(text)};
    result_.vectors += cases.size();
    if (options_.progress) options_.progress(file, cases.size());
  }

  std::vector<spec::Case> read_again(const fs::path& path, std::size_t count, const std::string& file) {
    try {
      std::vector<spec::Case> cases = read_cases(path);
      if (cases.size() != count) result_.rejected.push_back({file, 0, "vectors were lost while writing"});
      return cases;
    } catch (const spec::InputError& error) {
      result_.rejected.push_back({file, error.line(), error.message()});
      return {};
    }
  }

  void finish() {
    Manifest manifest;
    manifest.generator = kGenerator;
    manifest.seed = std::to_string(options_.seed);
    for (const auto& [name, file] : files_) manifest.files.push_back(file);
    manifest.version = next_version(manifest);
    result_.version = manifest.version;
    host::write_file(options_.folder / "manifest.json", write_manifest(manifest));
  }

  std::string next_version(const Manifest& manifest) {
    if (!options_.version.empty()) return to_string(parse_version(options_.version));
    // A new folder: it is the corpus of the tree that is made there.
    if (!has_old_)
      return fs::exists(default_folder() / "manifest.json") ? read_manifest(default_folder()).version
                                                            : manifest.version;
    const Version old = parse_version(old_manifest_.version);
    if (!old_readable_) return to_string(Version{old.major + 1, 0, 0});
    std::vector<spec::Case> now;
    for (const ManifestFile& file : manifest.files)
      for (spec::Case& c : read_cases(options_.folder / file.file)) now.push_back(std::move(c));
    return to_string(raised(old, diff(old_, now)));
  }

  const GenerateOptions& options_;
  const Chosen& chosen_;
  GenerateResult result_;
  Manifest old_manifest_;
  std::vector<spec::Case> old_;
  bool has_old_ = false;
  bool old_readable_ = true;
  std::map<std::string, ManifestFile> files_;
};

}  // namespace

void expect_sections(const std::vector<std::string>& sections) {
  for (const std::string& section : sections)
    if (std::ranges::find(fuzz::sections(), section) == fuzz::sections().end())
      throw spec::InputError("--section", 0, 0, "there is no section " + section);
}

bool wants(const GenerateOptions& options, std::string_view section) {
  return options.sections.empty() || std::ranges::find(options.sections, section) != options.sections.end();
}

GenerateResult generate(const GenerateOptions& options) {
  return generate(options, [&](std::string_view section) {
    return select(section, {options.seed, options.vectors, options.candidates});
  });
}

GenerateResult generate(const GenerateOptions& options, const Chosen& chosen) { return Writer(options, chosen).run(); }

}  // namespace toolcomp::corpus
