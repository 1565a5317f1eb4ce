// SPDX-License-Identifier: Apache-2.0
// Turns the tree of a setup into a Setup. Internal to the readers of setups and cases.
#pragma once

#include "spec/language/document.h"
#include "spec/language/setup.h"

namespace toolcomp::spec {

Setup setup_from(const document::Node& node, const document::Reader& read);

// Reads the keys that only Heidenhain has: [[tool]], [[correction.tcs]], [[dr2table]].
void read_tool_tables(const document::Node& node, const document::Reader& read, Setup& setup);

}  // namespace toolcomp::spec
