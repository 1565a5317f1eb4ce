// SPDX-License-Identifier: Apache-2.0
// The table of alarms, spec/alarms.toml, as C++.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace toolcomp::spec {

class AlarmTable {
 public:
  // Throws std::runtime_error or toml::parse_error, which name file, line and column, for what is no table of alarms.
  explicit AlarmTable(const std::filesystem::path& file);

  // alarm_causes.h: the enumeration. No text is in it, so that a changed text does not build everything anew.
  [[nodiscard]] std::string causes() const;
  // alarm_table.h: numbers, texts, sources.
  [[nodiscard]] std::string table() const;

 private:
  struct Row {
    std::string cause, number_16i, number_30i, text, source;
    std::size_t line = 0;
  };
  std::vector<Row> rows_;  // in the order of the file
};

}  // namespace toolcomp::spec
