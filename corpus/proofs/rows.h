// SPDX-License-Identifier: Apache-2.0
// Cases, and what is expected of them, as terms of Coq.
#pragma once

#include <string>
#include <vector>

#include "spec/language/case.h"
#include "spec_engine/case_data.h"

namespace toolcomp::corpus {

// A tree of whole numbers and texts as `data` (spec/formal/program/Data.v).
std::string data_term(const spec_engine::Data& data);

// The expected events as a `list (mark written)` (corpus/proofs/Comparison.v), in the form in which FanucCase.v and
// KlartextCase.v tell them. `places` are those of the blocks.
std::string row_term(const spec::Case& c, const std::vector<spec_engine::Place>& places);

}  // namespace toolcomp::corpus
