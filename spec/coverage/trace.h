// SPDX-License-Identifier: Apache-2.0
// The places that name each clause: the model, which applies it, the tests, the theorems, the golden vectors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "spec/clauses/clauses.h"

namespace toolcomp::spec {

// A file, relative to the source tree, and the line of the first mention.
struct Mention {
  std::string file;
  std::size_t line = 0;
};

// Everything that names one clause.
struct ClauseTrace {
  std::vector<Mention> model;         // files of the model that mark it, by name
  std::vector<Mention> tests;         // files of tests that name it
  std::vector<std::string> theorems;  // "LeadingEdgeOffset.V_components", in the order of the files
  std::vector<std::string> vectors;   // ids of golden vectors that state it or whose expected events rest on it
};

// The source tree from which toolcomp was built.
std::filesystem::path default_source();

// The trace of every clause, indexed by Clause. Throws InputError if `source` is not a source tree (has no
// spec/clauses), or if a golden vector is not a case.
std::vector<ClauseTrace> trace(const std::filesystem::path& source = default_source());

// Whether the model must mark the clause. It need not for notes, for clauses with testable = false, and for replaced
// clauses.
bool needs_mark(const ClauseInfo& clause);

}  // namespace toolcomp::spec
