// Any bytes as a setup, JSON if they begin with {, else TOML: read or refused; what is read is read back equal from
// both formats.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace {

using namespace toolcomp::spec;

void require(bool holds) {
  if (!holds) std::abort();
}

std::optional<Setup> read(std::string_view text) {
  try {
    return text.starts_with('{') ? read_setup_json(text, "setup") : read_setup_toml(text, "setup");
  } catch (const InputError& error) {
    require(error.line() != 0);
    return std::nullopt;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // NOLINTNEXTLINE(*-reinterpret-cast): bytes as characters
  const std::optional<Setup> setup = read({reinterpret_cast<const char*>(data), size});
  if (!setup) return 0;
  require(read_setup_toml(write_setup_toml(*setup), "again") == *setup);
  require(read_setup_json(write_setup_json(*setup), "again") == *setup);
  return 0;
}
