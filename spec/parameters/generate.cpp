// SPDX-License-Identifier: Apache-2.0
// Turns the registry of keys and parameters into C++: `toolcomp_parameters REGISTRY CLAUSE_FOLDER OUTPUT_FOLDER` writes
// keys.h, key_table.h and table.h.
#include <toml++/toml.h>
#include <exception>
#include <filesystem>
#include <iostream>

#include "spec/generated_source.h"
#include "spec/parameters/registry.h"

int main(int argc, char** argv) {
  using namespace toolcomp::spec;
  if (argc != 4) {
    std::cerr << "usage: toolcomp_parameters REGISTRY CLAUSE_FOLDER OUTPUT_FOLDER\n";
    return 2;
  }
  try {
    const Registry registry(argv[1], argv[2]);
    const std::filesystem::path folder(argv[3]);
    write_changed(folder / "keys.h", key_values(registry));
    write_changed(folder / "key_table.h", key_table(registry));
    write_changed(folder / "table.h", parameter_table(registry));
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
