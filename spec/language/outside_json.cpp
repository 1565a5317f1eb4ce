// SPDX-License-Identifier: Apache-2.0
#include "spec/language/outside_json.h"

namespace toolcomp::spec {

using document::Kind;

nlohmann::json tree_of(const document::Node& node, const document::Reader& read) {
  switch (node.kind) {
    case Kind::null:
    case Kind::other:
      return nullptr;
    case Kind::boolean:
      return node.boolean;
    case Kind::string:
      return node.text;
    case Kind::number: {
      auto number = nlohmann::json::parse(node.text, nullptr, false);
      if (number.is_discarded())
        read.fail(node.at, document::in_quotes(node.text) + " is outside the range of a double");
      return number;
    }
    case Kind::array: {
      auto array = nlohmann::json::array();
      for (const document::Node& item : node.items) array.push_back(tree_of(item, read));
      return array;
    }
    case Kind::table: {
      auto table = nlohmann::json::object();
      for (const document::Member& member : node.members) table[member.name] = tree_of(member.value, read);
      return table;
    }
  }
  return nullptr;
}

nlohmann::json read_outside_json(std::string_view text, const std::string& file) {
  return tree_of(document::parse_json(text, file), document::Reader(file));
}

}  // namespace toolcomp::spec
