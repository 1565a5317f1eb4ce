// SPDX-License-Identifier: Apache-2.0
// Rules for clause files, in addition to what the generator needs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace toolcomp::spec {

// Every breach in the clause files below `folder`, "FILE:LINE:COLUMN: id: what is wrong", in the order of the files:
//   ids       slugs of three parts or more that begin with the name of their folder, unique, without the page of their
//             source, short enough for events where a decision by sign can be undecided;
//   kinds     normative, parameter, alarm, open, note; outcomes sign, fact, reach;
//   source    present, says how well the clause is known, with document and page if it is known from a manual; a
//             definition of ours is normative only if it follows by geometry;
//   texts     a text of whole sentences; an outcome text for every outcome of a decision and for no other;
//   open      a clause that can be tested lists alternatives;
//   testable  false has a reason; unreachable outcomes exist and have a reason;
//   retired   replaced_by names clauses that are in force; an id in the file `published`, one a line, never disappears:
//             a retired clause stays as a tombstone, so that its id is never given to another.
// Throws InputError for a file that cannot be read or is not TOML.
std::vector<std::string> lint_clauses(const std::filesystem::path& folder, const std::filesystem::path& published);

}  // namespace toolcomp::spec
