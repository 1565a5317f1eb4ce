// SPDX-License-Identifier: Apache-2.0
#include "spec/parameters/registry.h"

#include <fmt/format.h>

#include <algorithm>

#include "spec/generated_source.h"

namespace toolcomp::spec {

namespace fs = std::filesystem;

Registry::Registry(const fs::path& file, const fs::path& clause_folder)
    : file_(file), root_(toml::parse_file(file.string())) {
  for (const auto& entry : fs::recursive_directory_iterator(clause_folder)) {
    if (entry.path().extension() != ".toml") continue;
    const toml::table clauses = toml::parse_file(entry.path().string());
    if (const auto* list = clauses["clause"].as_array())
      for (const toml::node& clause : *list)
        if (const toml::table* table = clause.as_table())
          in_force_[(*table)["id"].value_or(std::string())] = table->get("replaced_by") == nullptr;
  }
}

std::vector<const toml::table*> Registry::entries(std::string_view name) const {
  const auto* list = root_[name].as_array();
  if (list == nullptr) fail(root_, fmt::format("[[{}]] is missing", name));
  std::vector<const toml::table*> tables;
  for (const toml::node& node : *list) {
    if (!node.is_table()) fail(node, fmt::format("[[{}]] must be a table", name));
    tables.push_back(node.as_table());
  }
  return tables;
}

const toml::node* Registry::of_type(std::string_view type, std::string_view key) const {
  const auto* table = root_["type"][type].as_table();
  return table == nullptr ? nullptr : table->get(key);
}

void Registry::fail(const toml::node& node, std::string_view what) const { spec::fail(file_, node.source(), what); }

void Registry::expect_keys(const toml::table& table, std::span<const std::string_view> known) const {
  for (const auto& [key, value] : table)
    if (std::ranges::find(known, key.str()) == known.end()) fail(value, fmt::format("unknown key {}", key.str()));
}

std::string Registry::text(const toml::table& table, std::string_view key) const {
  const toml::node* node = table.get(key);
  if (node == nullptr) return {};
  if (!node->is_string()) fail(*node, fmt::format("{} must be a string", key));
  return node->value_or(std::string());
}

std::vector<std::string> Registry::strings(const toml::table& table, std::string_view key) const {
  const toml::node* node = table.get(key);
  if (node == nullptr) return {};
  if (!node->is_array() || node->as_array()->empty()) fail(*node, fmt::format("{} must be strings", key));
  std::vector<std::string> list;
  for (const toml::node& item : *node->as_array()) {
    if (!item.is_string()) fail(item, fmt::format("{} must be strings", key));
    list.push_back(item.value_or(std::string()));
  }
  return list;
}

bool Registry::flag(const toml::table& table, std::string_view key) const {
  const toml::node* node = table.get(key);
  if (node == nullptr) return false;
  if (!node->is_boolean()) fail(*node, fmt::format("{} must be true or false", key));
  return node->value_or(false);
}

std::vector<std::string> Registry::clauses(const toml::table& table) const {
  std::vector<std::string> ids = strings(table, "clauses");
  if (ids.empty()) fail(table, "clauses must name what rules the entry");
  for (const std::string& id : ids) {
    const auto found = in_force_.find(id);
    if (found == in_force_.end()) fail(*table.get("clauses"), fmt::format("there is no clause {}", id));
    if (!found->second) fail(*table.get("clauses"), fmt::format("the clause {} is replaced by another", id));
  }
  return ids;
}

}  // namespace toolcomp::spec
