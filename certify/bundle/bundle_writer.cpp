// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/bundle_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "certify/bundle/archive_writer.h"
#include "certify/bundle/plain_name.h"
#include "certify/bundle/record.h"
#include "certify/bundle/sbom.h"
#include "certify/bundle/signature.h"
#include "certify/controller.h"
#include "host/date.h"
#include "host/sha256.h"
#include "spec/language/byte_source.h"

namespace toolcomp::certify::bundle {
namespace {

namespace fs = std::filesystem;

// Of an answer that is no list of events, so many bytes are kept.
constexpr std::size_t kMostOfFault = std::size_t{1} << 16;

// "inputs/01-pocket.nc"
std::string input_name(std::size_t index, const std::string& given) {
  constexpr std::size_t kLongest = 60;
  std::string name = fs::path(given).filename().string();
  if (name.size() > kLongest) name.erase(0, name.size() - kLongest);
  for (char& c : name)
    if (!is_plain_name("x" + std::string(1, c))) c = '_';
  return fmt::format("inputs/{:03}-{}", index + 1, name);
}

fs::path folder_of(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  fs::create_directories(folder);
  return folder;
}

}  // namespace

BundleWriter::BundleWriter(fs::path file, Request request)
    : file_(std::move(file)),
      request_(std::move(request)),
      cases_(folder_of(file_)),
      answers_(folder_of(file_)),
      results_(folder_of(file_)) {}

void BundleWriter::add_input(const std::string& given, std::string bytes) {
  if (std::ranges::any_of(inputs_, [&](const ManifestInput& input) { return input.given == given; })) return;
  inputs_.push_back({given, input_name(inputs_.size(), given)});
  texts_.push_back(std::move(bytes));
}

void BundleWriter::add(const JudgedCase& judged) {
  Record record;
  record.asked = judged.answer != nullptr;
  record.result = judged.result;
  std::string_view line;
  if (judged.answer != nullptr) {
    line = judged.answer->line;
    if (const auto* fault = std::get_if<Fault>(&judged.answer->result)) {
      record.fault = *fault;
      record.cut = line.size() > kMostOfFault;
      line = line.substr(0, kMostOfFault);
    }
  }
  cases_.append(request_line(judged.c) + "\n");
  answers_.append(line);
  answers_.append("\n");
  results_.append(write_record(number_++, record) + "\n");
}

void BundleWriter::finish(const Certificate& certificate, const fs::path& report,
                          const std::vector<fs::path>& findings) {
  Manifest manifest;
  manifest.tool = certificate.identity.tool;
  manifest.made = host::date_of_now();
  manifest.command = request_.command;
  manifest.directory = fs::current_path().string();
  manifest.sections = request_.sections;
  manifest.adapter = request_.adapter;
  manifest.interrupted = certificate.interrupted;
  manifest.cases = number_;
  manifest.inputs = inputs_;

  std::map<std::string, std::function<void(ArchiveWriter&)>> members;
  const auto add_text = [&](const std::string& name, std::string text) {
    manifest.files.push_back({name, text.size(), host::sha256(text)});
    members[name] = [name, text = std::move(text)](ArchiveWriter& archive) { archive.add(name, text); };
  };
  const auto add_spool = [&](std::string_view name, Spool& spool) {
    manifest.files.push_back({std::string(name), spool.size(), spool.finish()});
    members[std::string(name)] = [name, &spool](ArchiveWriter& archive) { archive.add(std::string(name), spool); };
  };
  add_spool(kCases, cases_);
  add_spool(kAnswers, answers_);
  add_spool(kResults, results_);
  if (!certificate.hello.empty()) add_text(std::string(kHello), certificate.hello);
  if (!request_.corpus.empty()) add_text(std::string(kCorpus), spec::read_file(request_.corpus / "manifest.json"));
  for (const char* name : {"certificate.json", "junit.xml", "certificate.sarif", "index.html"})
    add_text(name, spec::read_file(report / name));
  for (const fs::path& finding : findings)
    add_text("findings/" + finding.filename().string(), spec::read_file(finding));
  for (std::size_t i = 0; i < inputs_.size(); ++i) add_text(inputs_[i].file, std::move(texts_[i]));
  add_text(std::string(kSbom), sbom(manifest.made, certificate.identity.tool_hash));
  std::ranges::sort(manifest.files, {}, &ManifestFile::file);

  // The manifest comes first: a reader knows what is to come, and how large.
  ArchiveWriter archive(file_);
  archive.add(std::string(kManifest), write_manifest(manifest));
  for (const auto& [name, add_to] : members) add_to(archive);
  archive.finish();
  // What was signed was another.
  std::error_code ignored;
  fs::remove(signature_file(file_), ignored);
}

}  // namespace toolcomp::certify::bundle
