// toolcomp config: setups and cases.
#include <iostream>

#include "cli/program.h"
#include "cli/verbs.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::cli {
namespace {

int check(const std::string& file) {
  if (file.empty()) throw spec::InputError("config check", 0, 0, "name a setup or a case");
  const std::string text = spec::read_file(file);
  const bool is_case = file.ends_with(".json") && text.find("\"program\"") != std::string::npos;
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
  std::cerr << file << ": " << (is_case ? "a valid case" : "a valid setup") << '\n';
  return kAgrees;
}

std::string_view schema(const std::string& name) {
  if (name.empty() || name == "setup") return spec::setup_schema();
  if (name == "case") return spec::case_schema();
  if (name == "event") return spec::event_schema();
  if (name == "hello") return spec::hello_schema();
  if (name == "answer") return spec::answer_schema();
  throw spec::InputError("config schema", 0, 0,
                         "no schema \"" + name + "\"; there are setup, case, event, hello, answer");
}

}  // namespace

int config(const ConfigOptions& options) {
  if (options.verb == "schema") {
    std::cout << schema(options.file);
    return kAgrees;
  }
  if (options.verb == "example") {
    std::cout << spec::setup_example(options.control == "fanuc" ? spec::Control::fanuc : spec::Control::heidenhain);
    return kAgrees;
  }
  return check(options.file);
}

}  // namespace toolcomp::cli
