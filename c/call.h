// SPDX-License-Identifier: Apache-2.0
// From exceptions to what a caller from C gets.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

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

// What a pointer points to that must not be null: throws std::invalid_argument.
template <class Object>
Object& need(Object* pointer, const char* name) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + " is a null pointer");
  return *pointer;
}

}  // namespace toolcomp::c
