// toolcomp config: setups and cases.
#include <iostream>

#include "cli/program.h"
#include "cli/verbs.h"
#include "fuzz/oracle/control.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::cli {
namespace {

template <class Number>
struct Nothing final : spec::EventSink<Number> {
  void on(const spec::Event<Number>&) override {}
};

// What only the engines refuse: kinematics no machine could have, tables of deviations that are missing.
void check_setup(const spec::Setup& setup) {
  model::Recorder recorder;
  Nothing<exact::Real> exact_sink;
  Nothing<double> fast_sink;
  fuzz::with_control(setup, [&]<class Control>(Control) {
    const auto model = Control::model(setup, recorder, exact_sink, 0);
    const auto fast = Control::fast(setup, fast_sink, 0);
  });
}

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
      check_setup(read_setup(file));
    }
  } catch (const spec::InputError& error) {
    // The engines know the key at fault, not the file.
    if (error.line() == 0 && !error.file().starts_with(file)) throw spec::InputError(file, 0, 0, error.what());
    throw;
  }
  std::cerr << file << ": " << (is_case ? "a valid case" : "a valid setup") << '\n';
  return kAgrees;
}

}  // namespace

int config(const ConfigOptions& options) {
  if (options.verb == "schema") {
    std::cout << spec::setup_schema();
    return kAgrees;
  }
  if (options.verb == "example") {
    std::cout << spec::setup_example(options.control == "fanuc" ? spec::Control::fanuc : spec::Control::heidenhain);
    return kAgrees;
  }
  return check(options.file);
}

}  // namespace toolcomp::cli
