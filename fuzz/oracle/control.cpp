#include "fuzz/oracle/control.h"

#include "spec/language/input_error.h"

namespace toolcomp::fuzz {

spec::Units program_units(const spec::Setup& setup, std::string_view program) {
  if (setup.control != spec::Control::heidenhain) return setup.units;
  try {
    HeidenhainControl::Reader reader = HeidenhainControl::reader(spec::text_source(program), setup, "program");
    const auto first = std::make_unique<HeidenhainControl::Block>();
    if (reader.next(*first)) return units_of(*first).value_or(setup.units);
  } catch (const spec::InputError&) {
    // Reported where the program is run.
  }
  return setup.units;
}

}  // namespace toolcomp::fuzz
