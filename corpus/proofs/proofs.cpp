// SPDX-License-Identifier: Apache-2.0
#include "corpus/proofs/proofs.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <utility>

#include "corpus/golden.h"
#include "corpus/proofs/rows.h"
#include "host/data_folder.h"
#include "host/file_writer.h"
#include "spec_engine/case_data.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;

// "fanuc.tool-offset.fbc293fa0c" as a name of Coq.
std::string identifier(std::string id) {
  std::ranges::replace_if(id, [](char c) { return c == '.' || c == '-'; }, '_');
  return id;
}

// "fanuc/tool-offset" as a name of a file.
std::string file_name(std::string section, std::size_t part) {
  std::ranges::replace_if(section, [](char c) { return c == '/' || c == '-'; }, '_');
  return fmt::format("Golden_{}_{}.v", section, part);
}

spec_engine::CaseData data_of(const spec::Case& c) {
  return c.dialect == "fanuc" ? spec_engine::fanuc_case(c) : spec_engine::klartext_case(c);
}

// The arguments of the statements about a vector.
std::string arguments(const spec::Case& c) {
  const spec_engine::CaseData made = data_of(c);
  return fmt::format("({})\n  {}", data_term(made.data), row_term(c, made.places));
}

std::string question_about(const spec::Case& c) {
  return fmt::format("Eval vm_compute in (\"{}\", can_be_computed {}).\n", c.id, arguments(c));
}

}  // namespace

std::string proofs_head() {
  return "From Coq Require Import List String ZArith.\nFrom Toolcomp Require Import Numbers Data Comparison Runs.\n"
         "Import ListNotations.\nOpen Scope string_scope.\nOpen Scope Z_scope.\nOpen Scope list_scope.\n";
}

std::string proof_of(const spec::Case& c) {
  return fmt::format("Lemma {} : runs_as_written {}.\nProof. by_running. Qed.\n", identifier(c.id), arguments(c));
}

ProofFiles write_proofs(const fs::path& corpus, const fs::path& output, const ProofOptions& options) {
  const auto left_out = options.only_tell ? std::map<std::string, std::string>() : unproven();
  std::map<std::string, std::vector<spec::Case>> sections;
  for (spec::Case& c : read_golden(corpus, options.sections))
    if (!left_out.contains(c.id)) sections[c.section].push_back(std::move(c));
  // Small enough that one file does not wait for another.
  constexpr std::size_t kInAFile = 60;
  ProofFiles written;
  for (auto& [section, cases] : sections) {
    if (options.a_section != 0 && options.a_section < cases.size()) {
      std::mt19937_64 generator(options.seed);
      for (std::size_t i = 0; i < options.a_section; ++i)
        std::swap(cases[i], cases[i + generator() % (cases.size() - i)]);
      cases.resize(options.a_section);
    }
    for (std::size_t first = 0; first < cases.size(); first += kInAFile) {
      std::string text = fmt::format("(** Generated from the golden vectors of {}. *)\n{}", section, proofs_head());
      for (std::size_t i = first; i < std::min(first + kInAFile, cases.size()); ++i)
        text += '\n' + (options.only_tell ? question_about(cases[i]) : proof_of(cases[i]));
      host::write_file(output / file_name(section, first / kInAFile + 1), text);
      ++written.files;
    }
    written.vectors[section] = cases.size();
  }
  return written;
}

std::map<std::string, std::string> unproven() {
  std::ifstream file(host::data_folder() / "corpus/proofs/unproven.json");
  std::map<std::string, std::string> reasons;
  const nlohmann::json by_reason = nlohmann::json::parse(file);
  for (const auto& [reason, ids] : by_reason.items())
    for (const auto& id : ids) reasons[id] = reason;
  return reasons;
}

std::vector<spec::ProofCount> count_proofs(const fs::path& corpus) {
  const std::map<std::string, std::string> left_out = unproven();
  std::map<std::string, spec::ProofCount> sections;
  for (const spec::Case& c : read_golden(corpus)) {
    spec::ProofCount& count = sections[c.section];
    count.section = c.section;
    ++count.vectors;
    if (!left_out.contains(c.id)) ++count.proven;
  }
  std::vector<spec::ProofCount> counts;
  counts.reserve(sections.size());
  for (auto& [section, count] : sections) counts.push_back(std::move(count));
  return counts;
}

}  // namespace toolcomp::corpus
