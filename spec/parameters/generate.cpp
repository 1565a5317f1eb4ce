// SPDX-License-Identifier: Apache-2.0
// Turns the registry of keys and parameters, and the table of alarms, into C++: `toolcomp_parameters REGISTRY ALARMS
// CLAUSE_FOLDER OUTPUT_FOLDER` writes keys.h, key_table.h, table.h, alarm_causes.h and alarm_table.h.
#include <toml++/toml.h>
#include <exception>
#include <filesystem>
#include <iostream>

#include "spec/generated_source.h"
#include "spec/parameters/alarms.h"
#include "spec/parameters/registry.h"

int main(int argc, char** argv) {
  using namespace toolcomp::spec;
  if (argc != 5) {
    std::cerr << "usage: toolcomp_parameters REGISTRY ALARMS CLAUSE_FOLDER OUTPUT_FOLDER\n";
    return 2;
  }
  try {
    const Registry registry(argv[1], argv[3]);
    const AlarmTable alarms(argv[2]);
    const std::filesystem::path folder(argv[4]);
    write_changed(folder / "keys.h", key_values(registry));
    write_changed(folder / "key_table.h", key_table(registry));
    write_changed(folder / "table.h", parameter_table(registry));
    write_changed(folder / "alarm_causes.h", alarms.causes());
    write_changed(folder / "alarm_table.h", alarms.table());
  } catch (const toml::parse_error& error) {
    const auto& where = error.source().begin;
    const std::string file = error.source().path ? *error.source().path : std::string(argv[1]);
    std::cerr << file << ':' << where.line << ':' << where.column << ": " << error.description() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
