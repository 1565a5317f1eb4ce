// SPDX-License-Identifier: Apache-2.0
// toolcomp config: setups and cases.
#include <filesystem>
#include <iostream>
#include <optional>

#include "certify/schema.h"
#include "cli/manners.h"
#include "cli/program.h"
#include "cli/verbs.h"
#include "host/data_folder.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::cli {
namespace {

// Where the schema of setups lies, for editors that read TOML by schemas.
std::optional<std::filesystem::path> schema_file() {
  for (const char* const folder : {"", "corpus/schema"}) {
    std::filesystem::path file = host::data_folder() / folder / "setup.schema.json";
    if (std::filesystem::is_regular_file(file)) return file;
  }
  return std::nullopt;
}

}  // namespace

int config_example(const std::string& control) {
  if (const auto file = schema_file()) std::cout << "#:schema " << file->string() << '\n';
  std::cout << spec::setup_example(control == "heidenhain" ? spec::Control::heidenhain : spec::Control::fanuc);
  return kAgrees;
}

int config_schema(const std::string& name) {
  std::cout << (name == "case"       ? spec::case_schema()
                : name == "event"    ? spec::event_schema()
                : name == "hello"    ? spec::hello_schema()
                : name == "answer"   ? spec::answer_schema()
                : name == "finding"  ? certify::finding_schema()
                : name == "manifest" ? certify::manifest_schema()
                                     : spec::setup_schema());
  return kAgrees;
}

int config_check(const std::string& file) {
  detail("reads " + file);
  const std::string text = spec::read_file(file);
  const auto has = [&text](std::string_view name) { return text.find(name) != std::string::npos; };
  const bool is_case = file.ends_with(".json") && (has("\"program\"") || has("\"case\""));
  try {
    if (is_case) {
      const spec::Case c = spec::read_case(text, file);
      check_setup(c.setup);
      expect_readable(c, file + ": program");
    } else {
      static_cast<void>(read_setup(file));
    }
  } catch (const spec::InputError& error) {
    // The engines know the key at fault, not the file.
    if (error.line() == 0 && !error.file().starts_with(file)) throw spec::InputError(file, 0, 0, error.what());
    throw;
  }
  note(file + ": " + (is_case ? "a valid case" : "a valid setup"));
  return kAgrees;
}

}  // namespace toolcomp::cli
