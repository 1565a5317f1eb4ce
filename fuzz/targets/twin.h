// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target of one section: the bytes are the case (fuzz/gen/encode.h), every execution runs model and fast
// engine and judges. Three lines make one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/gen/generator.h"

namespace toolcomp::fuzz {

int initialize_target(std::string_view section, Mode mode);
// As a worker of a campaign notes what differs and goes on; else prints it and aborts, so that the fuzzer keeps the
// input. What libFuzzer is to be told.
int run_target(std::string_view section, Mode mode, const std::uint8_t* data, std::size_t size);
// A changed case, or a new one, in at most `most` bytes; the length.
std::size_t mutate_input(std::string_view section, Mode mode, std::uint8_t* data, std::size_t size, std::size_t most,
                         unsigned seed);
std::size_t cross_inputs(std::string_view section, const std::uint8_t* a, std::size_t a_size, const std::uint8_t* b,
                         std::size_t b_size, std::uint8_t* out, std::size_t most, unsigned seed);

}  // namespace toolcomp::fuzz

// libFuzzer's entry points, by its own names.
// NOLINTBEGIN(cppcoreguidelines-macro-usage,readability-identifier-naming)
#define TOOLCOMP_TWIN_TARGET(section, mode)                                                                          \
  extern "C" int LLVMFuzzerInitialize(int*, char***) { return toolcomp::fuzz::initialize_target(section, mode); }    \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {                                \
    return toolcomp::fuzz::run_target(section, mode, data, size);                                                    \
  }                                                                                                                  \
  extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,             \
                                                 unsigned seed) {                                                    \
    return toolcomp::fuzz::mutate_input(section, mode, data, size, most, seed);                                      \
  }                                                                                                                  \
  extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* a, std::size_t a_size, const std::uint8_t* b, \
                                                   std::size_t b_size, std::uint8_t* out, std::size_t most,          \
                                                   unsigned seed) {                                                  \
    return toolcomp::fuzz::cross_inputs(section, a, a_size, b, b_size, out, most, seed);                             \
  }
// NOLINTEND(cppcoreguidelines-macro-usage,readability-identifier-naming)
