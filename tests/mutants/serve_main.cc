// SPDX-License-Identifier: Apache-2.0
// The controller protocol with the fast engine, and nothing else: what mutants and other compilers are linked into.
#include <iostream>

#include "certify/serve.h"

int main() {
  using toolcomp::certify::serve;
  using toolcomp::certify::ServedEngine;
  constexpr std::size_t kLongest = std::size_t{1} << 30;  // bytes of a request
  serve(ServedEngine::fast, std::cin, std::cout, std::cerr, kLongest);
}
