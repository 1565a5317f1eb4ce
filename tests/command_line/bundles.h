// SPDX-License-Identifier: Apache-2.0
// Evidence bundles taken apart and put together again, as somebody would who wants another result in them.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "certify/bundle/archive_reader.h"
#include "certify/bundle/archive_writer.h"
#include "host/sha256.h"
#include "tests/command_line/command.h"

namespace toolcomp::test {

using Json = nlohmann::ordered_json;
using Members = std::map<std::string, std::string>;  // by name

inline Members members_of(const std::string& bundle) {
  Members members;
  certify::bundle::ArchiveReader archive(bundle);
  while (const auto member = archive.next())
    archive.read([&](std::string_view piece) { members[member->name] += piece; });
  return members;
}

// Sealed as the command seals it.
inline void write_bundle(const std::string& file, const Members& members) {
  certify::bundle::ArchiveWriter archive(file);
  archive.add("manifest.json", members.at("manifest.json"));
  for (const auto& [name, bytes] : members)
    if (name != "manifest.json") archive.add(name, bytes);
  archive.finish();
}

// The manifest says what there is: its sizes, digests and number of cases.
inline void adapt_manifest(Members& members) {
  Json manifest = Json::parse(members.at("manifest.json"));
  manifest["files"] = Json::array();
  for (const auto& [name, bytes] : members)
    if (name != "manifest.json")
      manifest["files"].push_back(Json{{"file", name}, {"size", bytes.size()}, {"sha256", host::sha256(bytes)}});
  const std::string& cases = members.at("cases.jsonl");
  manifest["cases"] = std::ranges::count(cases, '\n');
  members["manifest.json"] = manifest.dump(2) + "\n";
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

inline std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// The lines of the three files with a line a case.
struct Cases {
  std::vector<std::string> requests, answers, results;

  explicit Cases(const Members& members)
      : requests(lines_of(members.at("cases.jsonl"))),
        answers(lines_of(members.at("answers.jsonl"))),
        results(lines_of(members.at("results.jsonl"))) {}
  void erase(std::size_t i) {
    for (auto* lines : {&requests, &answers, &results}) lines->erase(lines->begin() + static_cast<std::ptrdiff_t>(i));
  }
  void repeat(std::size_t i) {
    for (auto* lines : {&requests, &answers, &results}) lines->push_back(std::string((*lines)[i]));
  }
  // With results numbered anew.
  void put_into(Members& members) {
    for (std::size_t i = 0; i < results.size(); ++i) {
      Json record = Json::parse(results[i]);
      record["case"] = i;
      results[i] = record.dump();
    }
    members["cases.jsonl"] = joined(requests);
    members["answers.jsonl"] = joined(answers);
    members["results.jsonl"] = joined(results);
  }
};

}  // namespace toolcomp::test
