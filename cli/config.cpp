// SPDX-License-Identifier: Apache-2.0
// toolcomp config: setups and cases.
#include <array>
#include <filesystem>
#include <iostream>
#include <optional>

#include "cli/manners.h"
#include "cli/program.h"
#include "cli/verbs.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/data_folder.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"
#include "spec/language/suggestion.h"

namespace toolcomp::cli {
namespace {

int check(const std::string& file) {
  if (file.empty()) throw spec::InputError("config check", 0, 0, "name a setup or a case");
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

std::string_view schema(const std::string& name) {
  if (name.empty() || name == "setup") return spec::setup_schema();
  if (name == "case") return spec::case_schema();
  if (name == "event") return spec::event_schema();
  if (name == "hello") return spec::hello_schema();
  if (name == "answer") return spec::answer_schema();
  throw spec::InputError("config schema", 0, 0,
                         "no schema \"" + name + "\"; there are setup, case, event, hello, answer" +
                             spec::did_you_mean(name, std::array{"setup", "case", "event", "hello", "answer"}));
}

// Where the schema of setups lies, for editors that read TOML by schemas.
std::optional<std::filesystem::path> schema_file() {
  for (const char* const folder : {"", "corpus/schema"}) {
    std::filesystem::path file = spec::data_folder() / folder / "setup.schema.json";
    if (std::filesystem::is_regular_file(file)) return file;
  }
  return std::nullopt;
}

}  // namespace

int config(const ConfigOptions& options) {
  if (options.verb == "schema") {
    std::cout << schema(options.file);
    return kAgrees;
  }
  if (options.verb == "example") {
    if (const auto file = schema_file()) std::cout << "#:schema " << file->string() << '\n';
    std::cout << spec::setup_example(options.control == "fanuc" ? spec::Control::fanuc : spec::Control::heidenhain);
    return kAgrees;
  }
  return check(options.file);
}

}  // namespace toolcomp::cli
