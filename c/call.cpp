// SPDX-License-Identifier: Apache-2.0
#include "c/call.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

#include "spec/language/input_error.h"

namespace toolcomp::c {

void report(toolcomp_error* error, std::uint64_t line, std::uint64_t column, const char* message) noexcept {
  if (error == nullptr) return;
  error->line = line;
  error->column = column;
  const std::size_t length = std::min(std::strlen(message), sizeof error->message - 1);
  std::memcpy(error->message, message, length);
  std::memset(error->message + length, 0, sizeof error->message - length);
}

toolcomp_status status_of_exception(toolcomp_error* error, std::uint64_t before) noexcept {
  try {
    throw;
  } catch (const spec::InputError& fault) {
    report(error, fault.line() == 0 ? 0 : fault.line() + before, fault.column(), fault.message().c_str());
    return TOOLCOMP_BAD_INPUT;
  } catch (const std::invalid_argument& fault) {
    report(error, 0, 0, fault.what());
    return TOOLCOMP_BAD_CALL;
  } catch (const std::bad_alloc&) {
    report(error, 0, 0, "out of memory");
    return TOOLCOMP_NO_MEMORY;
  } catch (const std::exception& fault) {
    report(error, 0, 0, fault.what());
    return TOOLCOMP_FAILED;
  } catch (...) {
    report(error, 0, 0, "unknown exception");
    return TOOLCOMP_FAILED;
  }
}

}  // namespace toolcomp::c
