// SPDX-License-Identifier: Apache-2.0
#include "spec/language/outside_json.h"

#include "spec/language/document.h"
#include "spec/language/input_error.h"

namespace toolcomp::spec {

nlohmann::json read_outside_json(std::string_view text, const std::string& file) {
  document::parse_json(text, file);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {  // a number beyond what a double holds
    throw InputError(file, 0, 0, error.what());
  }
}

}  // namespace toolcomp::spec
