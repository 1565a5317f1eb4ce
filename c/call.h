// From exceptions to what a caller from C gets.
#pragma once

#include <cstdint>
#include <exception>

#include "c/include/toolcomp.h"

namespace toolcomp::c {

// Writes an error, where one is wanted.
void report(toolcomp_error* error, std::uint64_t line, std::uint64_t column, const char* message) noexcept;
// Of the exception being handled: the status it stands for. `before`: lines of the program in front of the text.
toolcomp_status status_of_exception(toolcomp_error* error, std::uint64_t before) noexcept;

// Runs `call`, which may throw.
template <class Call>
toolcomp_status guarded(toolcomp_error* error, const Call& call, std::uint64_t before = 0) noexcept {
  report(error, 0, 0, "");
  try {
    call();
    return TOOLCOMP_OK;
  } catch (...) {
    return status_of_exception(error, before);
  }
}

// Throws std::invalid_argument: a pointer that must not be null.
void need(const void* pointer, const char* name);

}  // namespace toolcomp::c
