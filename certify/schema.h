// SPDX-License-Identifier: Apache-2.0
// JSON Schemas of the files that are passed on: what their readers accept, and no more. They stand in corpus/schema
// too.
#pragma once

#include <string_view>

namespace toolcomp::certify {

std::string_view finding_schema();   // finding.h
std::string_view manifest_schema();  // bundle/manifest.h

}  // namespace toolcomp::certify
