// toolcomp serve: the controller protocol, for our own engines.
#include "certify/serve.h"

#include <iostream>

#include "cli/verbs.h"

namespace toolcomp::cli {

int serve(EngineName engine) {
  const auto served = engine == EngineName::model ? certify::ServedEngine::model : certify::ServedEngine::fast;
  return certify::serve(served, std::cin, std::cout, std::cerr) == 0 ? kAgrees : kBadInput;
}

}  // namespace toolcomp::cli
