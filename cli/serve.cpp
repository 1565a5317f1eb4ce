// SPDX-License-Identifier: Apache-2.0
// toolcomp serve: the controller protocol, for our own engines.
#include "certify/serve.h"

#include <unistd.h>

#include <iostream>

#include "cli/manners.h"
#include "cli/verbs.h"
#include "spec_engine/engine.h"

namespace toolcomp::cli {

int serve(EngineName engine) {
  if (::isatty(STDIN_FILENO) == 1)
    note(
        "This command speaks the controller protocol (docs/protocol.md): each input line is a JSON object, each output "
        "line an answer.\n"
        "Try {\"hello\":1}, then {\"case\":1,\"id\":\"a\",\"setup\":{\"control\":\"fanuc\"},\"program\":\"G01 "
        "X1 F1\"}. Ctrl-D ends it.");
  if (engine == EngineName::specification && !spec_engine::available()) {
    std::cerr << "this toolcomp was built without the formal specification: install coq, ocaml and ocaml-findlib, and "
                 "build it again\n";
    return kBadInput;
  }
  detail(engine == EngineName::model  ? "engine: model, exact"
         : engine == EngineName::fast ? "engine: fast, double"
                                      : "engine: formal specification");
  const auto served = engine == EngineName::model  ? certify::ServedEngine::model
                      : engine == EngineName::fast ? certify::ServedEngine::fast
                                                   : certify::ServedEngine::specification;
  return certify::serve(served, std::cin, std::cout, std::cerr) == 0 ? kAgrees : kBadInput;
}

}  // namespace toolcomp::cli
