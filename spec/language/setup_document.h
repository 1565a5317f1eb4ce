// SPDX-License-Identifier: Apache-2.0
// The tree of a setup to a Setup. Internal to the readers of setups and cases.
#pragma once

#include "spec/language/document.h"
#include "spec/language/setup.h"

namespace toolcomp::spec {

Setup setup_from(const document::Node& node, const document::Reader& read);

// The keys of Heidenhain alone: [[tool]], [[correction.tcs]], [[dr2table]].
void read_tool_tables(const document::Node& node, const document::Reader& read, Setup& setup);

}  // namespace toolcomp::spec
