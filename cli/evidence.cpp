// SPDX-License-Identifier: Apache-2.0
#include "cli/evidence.h"

#include <fmt/format.h>

#include <filesystem>

#include "certify/bundle/signature.h"
#include "cli/program.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;

}  // namespace

Evidence::Evidence(const CertifyOptions& options) : options_(options) {
  if (options.evidence.empty()) {
    if (!options.sign.empty()) throw spec::InputError("--sign", 0, 0, "needs --evidence, the file to sign");
    return;
  }
  if (!options.evidence.ends_with(".tar.zst"))
    throw spec::InputError("--evidence", 0, 0,
                           "takes a file that ends in .tar.zst, found \"" + options.evidence + "\"");
  if (fs::is_directory(options.evidence)) throw spec::InputError("--evidence", 0, 0, options.evidence + " is a folder");
  if (const fs::path folder = fs::path(options.evidence).parent_path(); !folder.empty())
    expect_folder(folder.string(), "--evidence");
  if (!options.sign.empty()) certify::bundle::expect_key(options.sign);
}

void Evidence::begin(certify::CertificationOptions& certification, const std::string& adapter, const fs::path& corpus) {
  if (options_.evidence.empty()) return;
  writer_.emplace(options_.evidence, certify::bundle::Request{options_.words, certification.sections, adapter, corpus});
  add_inputs();
  certification.judged = [this](const certify::JudgedCase& judged) { writer_->add(judged); };
}

// Programs and cases, and the setups of programs.
void Evidence::add_inputs() {
  for (const std::string& path : options_.inputs) {
    // What came from standard input is in the case.
    if (path == "-") continue;
    writer_->add_input(path, spec::read_file(path));
    const std::string extension = fs::path(path).extension().string();
    if (extension == ".json" || extension == ".jsonl") continue;
    const std::string setup =
        options_.setup.empty() ? (fs::path(path).parent_path() / "setup.toml").string() : options_.setup;
    if (fs::is_regular_file(setup)) writer_->add_input(setup, spec::read_file(setup));
  }
}

void Evidence::finish(const certify::Certificate& certificate, const std::vector<fs::path>& findings) {
  if (!writer_) return;
  writer_->finish(certificate, options_.report, findings);
  fmt::print("evidence: {}\n", options_.evidence);
  if (options_.sign.empty()) return;
  certify::bundle::sign(options_.evidence, options_.sign);
  fmt::print("signature: {}\n", certify::bundle::signature_file(options_.evidence).string());
}

void refuse_evidence(const CertifyOptions& options, const std::string& why) {
  if (!options.evidence.empty() || !options.sign.empty()) throw spec::InputError("--evidence", 0, 0, why);
}

}  // namespace toolcomp::cli
