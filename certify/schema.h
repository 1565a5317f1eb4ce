// SPDX-License-Identifier: Apache-2.0
// JSON Schemas of the files that are passed on. They describe exactly what the readers accept. corpus/schema has them
// too.
#pragma once

#include <string_view>

namespace toolcomp::certify {

std::string_view finding_schema();   // finding.h
std::string_view manifest_schema();  // bundle/manifest.h

}  // namespace toolcomp::certify
