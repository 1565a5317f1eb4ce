// SPDX-License-Identifier: Apache-2.0
// The registry as the generator reads it: tables of TOML with the positions of their faults, and the clauses they name.
#pragma once

#include <toml++/toml.h>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::spec {

class Registry {
 public:
  // Throws toml::parse_error, of `file` or of a clause file.
  Registry(const std::filesystem::path& file, const std::filesystem::path& clause_folder);

  // The tables [[name]]. Throws std::runtime_error, as all below, where there are none.
  [[nodiscard]] std::vector<const toml::table*> entries(std::string_view name) const;
  // The node of [type.NAME], or nullptr.
  [[nodiscard]] const toml::node* of_type(std::string_view type, std::string_view key) const;

  // Throws with file, line and column of the node.
  [[noreturn]] void fail(const toml::node& node, std::string_view what) const;
  void expect_keys(const toml::table& table, std::span<const std::string_view> known) const;
  // Empty where the table has no such key.
  [[nodiscard]] std::string text(const toml::table& table, std::string_view key) const;
  [[nodiscard]] std::vector<std::string> strings(const toml::table& table, std::string_view key) const;
  [[nodiscard]] bool flag(const toml::table& table, std::string_view key) const;
  // "clauses": at least one, each in force.
  [[nodiscard]] std::vector<std::string> clauses(const toml::table& table) const;

 private:
  std::filesystem::path file_;
  toml::table root_;
  std::map<std::string, bool> in_force_;  // by clause id
};

// table.h: every [[parameter]] as a ParameterInfo.
std::string parameter_table(const Registry& registry);
// keys.h: the enumerations of the values of every [[key]], and SetupKeys, a struct of them. What texts say is not in
// it, for everything is built again behind it.
std::string key_values(const Registry& registry);
// key_table.h: every [[key]] as a KeyInfo.
std::string key_table(const Registry& registry);

}  // namespace toolcomp::spec
